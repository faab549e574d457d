// Beside floor 6. Finding a scene, and holding a run against what is expected of it.
#include "study/scene_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "math/nearest.hpp"
#include "study/scene_file.hpp"

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

TrialOptions trial_options(const SceneEntry& scene) {
  TrialOptions options{.seconds = scene.seconds};
  if (scene.expectations.stands) options.stand_distance = *scene.expectations.stands;
  return options;
}

std::vector<std::string> unmet(const Expectations& expectations, const TrialResult& result) {
  if (result.status == TrialStatus::refused) return {"refused: " + result.reason};
  if (result.status != TrialStatus::ok) {
    const std::string ending = fmt::format("{} after {:.3g} s", status_text(result.status), result.seconds);
    if (!result.not_finite) return {ending};
    return {fmt::format("{}: body {} would not be finite", ending, result.not_finite->index)};
  }
  std::vector<std::string> missed;
  const auto at_most = [&missed](const char* name, double value, const std::optional<double>& most,
                                 const char* unit) {
    if (!most || value <= *most) return;
    missed.push_back(fmt::format("{} {:.3g} {}, expected at most {:g} {}", name, value, unit, *most, unit));
  };
  at_most("worst penetration", result.worst_penetration, expectations.penetration, "m");
  at_most("worst drift", result.worst_drift, expectations.drift, "m or rad");
  at_most("energy gain", 100 * result.energy_gain, expectations.energy_gain, "%");
  if (expectations.stands && result.fell_at) {
    missed.push_back(fmt::format("stands for {:.3g} s of {:.3g} s", result.stands_until, result.seconds));
  }
  return missed;
}

}  // namespace cairn
