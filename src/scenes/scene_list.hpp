// Floor 8. Scenes by name, and what may be expected of each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include <cairn/scenes/setting.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Where a body should be when the scene's time is over.
struct ExpectedPlace {
  BodyId body = {};                // whose centre of mass
  Vec2<double> position = {0, 0};  // [m] should be here
  double within = 0;               // [m] or as near
};

/// What a good run keeps to; what is left out is not expected.
struct Expectations {
  std::optional<double> penetration = {};  // [m] TrialResult::worst_penetration at most
  std::optional<double> drift = {};        // [m or rad] TrialResult::worst_drift at most
  std::optional<double> energy_gain = {};  // [%] of EnergyAccount::scale() at most
  std::optional<double> energy_loss = {};  // [%] likewise, at the end
  /// [m] It stands: once the scene has settled, for at most a second, every dynamic body's centre of mass
  /// stays this near to its place (Standing says how far it may come before).
  std::optional<double> stands = {};
  List<ExpectedPlace> places = {};  // not beside `stands`
};

/// What a picture of the scene shows.
struct SceneCamera {
  Vec2<double> center = {0, 0};  // [m]
  double height = 10;            // [m]
};

struct SceneEntry {
  std::string name = {};
  std::string title = {};
  std::string look = {};  // what to see, in a sentence
  double seconds = 2;     // [s] worth watching; expectations are for all of them
  Expectations expectations = {};
  Setting setting = {};  // that meets them
  std::function<Scene()> make = {};
  std::optional<SceneCamera> camera = {};  // none: all that is there
  PerBody<std::string> body_names = {};
  std::map<std::string, JointId> joint_ids = {};  // by name
  double order = 1000;            // place in lists
  std::uint64_t fingerprint = 0;  // of the text of its file
};

/// All that come with Cairn, from lessons/scenes, or from the folder that the environment variable
/// CAIRN_SCENES names; by their order, and then by name. They are read once.
/// @throws std::invalid_argument for the first file that is refused.
const List<SceneEntry>& scene_entries();

/// Where they are, unless CAIRN_SCENES says otherwise: in data_folder(). Before it is installed, a program
/// finds the folder of the sources there.
std::filesystem::path scene_folder();
/// The scene of that name, or of the file: what has a "/" in it or ends in ".toml" is the path of one.
/// @throws std::invalid_argument for an unknown name, with the nearest known one, and for what
/// read_scene_file refuses.
SceneEntry scene_entry(const std::string& name);
/// Whether it says where a scene file is: it has a '/' in it or ends in .toml.
bool names_scene_file(const std::string& name);

}  // namespace cairn
