// Floor 7. What a scene file says of the whole scene.
#pragma once

#include "scenes/scene_list.hpp"
#include "scenes/scene_table.hpp"

namespace cairn {

/// [step], view and gravity.
SceneSettings scene_settings_of(const SceneTable& file);
/// [recommended]; what it leaves out is as in `settings`.
Setting recommended_of(const SceneTable& file, const SceneSettings& settings);
/// [expect], but for its bodies.
Expectations expectations_of(const SceneTable& file);
std::optional<SceneCamera> camera_of(const SceneTable& file);

}  // namespace cairn
