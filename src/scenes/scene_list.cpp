// Floor 7. Finding a scene.
#include "scenes/scene_list.hpp"

#include <algorithm>
#include <cstdlib>

#include "math/nearest.hpp"
#include "scenes/scene_file.hpp"

namespace cairn {

const std::vector<SceneEntry>& scene_entries() {
  static const std::vector<SceneEntry> entries = [] {
    const char* folder = std::getenv("CAIRN_SCENES");
    return read_scene_folder(folder && *folder ? folder : CAIRN_SCENE_DIR);
  }();
  return entries;
}

bool names_scene_file(const std::string& name) {
  return name.ends_with(".toml") || name.find('/') != std::string::npos;
}

SceneEntry scene_entry(const std::string& name) {
  if (names_scene_file(name)) return read_scene_file(name);
  std::vector<std::string> known;
  for (const SceneEntry& entry : scene_entries()) known.push_back(entry.name);
  require_known(name, known, "scene_entry", "scene");
  const auto found = std::find(known.begin(), known.end(), name);
  return scene_entries()[static_cast<std::size_t>(found - known.begin())];
}

}  // namespace cairn
