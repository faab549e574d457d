// Floor 8. What a scene file says of the whole scene.
#pragma once

#include "scenes/scene_list.hpp"
#include "scenes/scene_table.hpp"

namespace cairn {

/// [step], view and gravity.
SceneSettings scene_settings_of(const SceneTable& file);
/// [recommended]; what it leaves out is as in the settings of the scene. Where there are joints, block solves
/// them in 4 substeps unless the file says otherwise: SI takes for ever over the two rows of a pin far from a
/// light body, and in one solve a step a net of a hundred joints or more comes apart.
Setting recommended_of(const SceneTable& file, const Scene& scene);
/// [expect], but for its bodies.
Expectations expectations_of(const SceneTable& file);
std::optional<SceneCamera> camera_of(const SceneTable& file);

}  // namespace cairn
