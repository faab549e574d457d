// Beside floor 6. What a scene file says of the whole scene.
#pragma once

#include "study/scene_list.hpp"
#include "study/scene_table.hpp"

namespace cairn {

/// [step], view and gravity.
SceneSettings scene_settings_of(const SceneTable& file);
/// [recommended]; what it leaves out is as in `settings`.
Setting recommended_of(const SceneTable& file, const SceneSettings& settings);
Expectations expectations_of(const SceneTable& file);
std::optional<SceneCamera> camera_of(const SceneTable& file);

}  // namespace cairn
