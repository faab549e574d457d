// Floor 8. Finding a scene.
#include <cairn/scenes/scene_list.hpp>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include <cairn/math/nearest.hpp>
#include <cairn/scenes/data_folder.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

std::filesystem::path scene_folder() {
  std::error_code error;
  const std::filesystem::path folder = data_folder() / "scenes";
  const std::filesystem::path resolved = std::filesystem::canonical(folder, error);
  return error ? folder : resolved;
}

const List<SceneEntry>& scene_entries() {
  static const List<SceneEntry> entries = [] {
    const char* folder = std::getenv("CAIRN_SCENES");
    return read_scene_folder(folder && *folder ? folder : scene_folder());
  }();
  return entries;
}

bool names_scene_file(const std::string& name) {
  return name.ends_with(".toml") || name.find('/') != std::string::npos;
}

SceneEntry scene_entry(const std::string& name) {
  if (names_scene_file(name)) return read_scene_file(name);
  List<std::string> known;
  for (const SceneEntry& entry : scene_entries()) known.push_back(entry.name);
  require_known(name, known, "scene_entry", "scene");
  const auto found = std::find(known.begin(), known.end(), name);
  return scene_entries()[found - known.begin()];
}

}  // namespace cairn
