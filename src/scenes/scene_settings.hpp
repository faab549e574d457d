// Floor 8. What a scene file says of the whole scene.
#pragma once

#include <cairn/scenes/scene_list.hpp>
#include <cairn/scenes/scene_table.hpp>

namespace cairn {

/// [step], view and gravity.
SceneSettings scene_settings_of(const SceneTable& file);
/// [recommended]; what it leaves out is as default_setting() has it, and substeps as in [step] where that says
/// them.
Setting recommended_of(const SceneTable& file, const Scene& scene);

}  // namespace cairn
