// Floor 8. Scenes from TOML files.
#pragma once

#include <string>

#include <cairn/scenes/scene_list.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// [bytes] Longer scene files are refused.
inline constexpr int most_scene_bytes = 1'000'000;

/// The scene of a file; its name is that of the file without its ending.
/// @throws std::invalid_argument "file:line:column: field must be rule unit, got value" for the first thing
/// in the file that is not as lessons/scenes/README.md says, and for a file that cannot be read.
SceneEntry read_scene_file(const std::string& path);

/// The same from the text of a file. `file` is the name that messages give it.
SceneEntry read_scene_text(const std::string& text, const std::string& file);

/// All scenes of the *.toml files of a folder, by their order and then by name.
/// @throws std::invalid_argument for a folder without any, and for the first file that is refused.
List<SceneEntry> read_scene_folder(const std::string& folder);

}  // namespace cairn
