// cairn freeze: one step's problem, kept in a file.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <sstream>

#include <cairn/study/frozen/frozen_set.hpp>
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/scenes/solver_list.hpp>

namespace cairn::sandbox {
namespace {

constexpr int most_steps = 1000000;

bool is_of_the_set(const std::string& name) {
  return std::count(frozen_names().begin(), frozen_names().end(), name) > 0;
}

/// A scene file may have a name that a frozen problem may not: all but letters, digits and _ becomes -.
std::string frozen_name(const std::string& scene, int step) {
  std::string name = scene.substr(0, 56);  // with its step at most 64
  const auto is_other = [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_'; };
  std::replace_if(name.begin(), name.end(), is_other, '-');
  return name + "-" + std::to_string(step);
}

FrozenProblem frozen_scene(const SceneEntry& entry, int step, int sweeps) {
  World<double> world(entry.make());
  const auto solver = make_solver<double>("si", {.iterations = sweeps});
  for (int k = 0; k < step; ++k) {
    const StepReport report = world.step(*solver);
    if (report.not_finite)
      throw std::invalid_argument("freeze: the scene is not finite after step " + std::to_string(k + 1));
  }
  return freeze(world, frozen_name(entry.name, step),
                fmt::format("{}, after {} steps of SI with {} sweeps", entry.title, step, sweeps));
}

List<std::string> freezable() {
  List<std::string> names = frozen_names();
  for (const SceneEntry& scene : scene_entries()) names.push_back(scene.name);
  return names;
}

int list_problems(const Words& words, Console& console) {
  if (words.has("json")) {
    fmt::print("{}\n", nlohmann::json(freezable()).dump());
    return all_well;
  }
  for (const std::string& name : frozen_names()) console.result(name);
  for (const SceneEntry& scene : scene_entries())
    console.result(console.spelt(fmt::format("{:<18} {} (--step N)", scene.name, scene.title)));
  return all_well;
}

int freeze_set(const Words& words, Console& console) {
  if (!words.places.empty())
    throw UsageError("cairn freeze: --set writes all of the frozen set: no SCENE goes with it, got " +
                     words.places.front());
  for (const char* flag : {"step", "sweeps", "out"}) words.refuse_beside(flag, "beside --set");
  const std::string folder = *words.text("set");
  write_frozen_set(folder);
  if (words.has("json"))
    fmt::print("{}\n", nlohmann::json(frozen_names()).dump());
  else
    console.result(console.spelt(fmt::format("{} problems in {}", frozen_names().size(), folder)));
  return all_well;
}

int run_freeze(const Words& words, Console& console) {
  if (words.has("list")) return list_problems(words, console);
  if (words.has("set")) return freeze_set(words, console);
  if (words.places.empty())
    throw UsageError("cairn freeze: a word is missing: it goes cairn freeze SCENE; --list shows them");
  const std::string& name = words.places.front();
  const int step = words.whole("step", 30, 0, most_steps);
  const int sweeps = words.whole("sweeps", 10, 0, Setting::most_sweeps);
  if (is_of_the_set(name)) {
    for (const char* flag : {"step", "sweeps"}) words.refuse_beside(flag, "for a problem of the frozen set");
  }
  const FrozenProblem frozen = is_of_the_set(name)
                                   ? make_frozen(name)
                                   : frozen_scene(scene_of(words, name, frozen_names()), step, sweeps);
  if (words.has("json")) {
    std::ostringstream text;
    write_frozen(text, frozen);
    if (const std::optional<std::string> path = words.text("out")) write_frozen_file(*path, frozen);
    fmt::print("{}", text.str());
    return all_well;
  }
  const std::string path = words.text("out").value_or(frozen.name + ".json");
  write_frozen_file(path, frozen);
  console.result(console.spelt(fmt::format("{}: {} bodies, {} rows; {}", path, frozen.problem.body_count(),
                                           frozen.problem.row_count(), frozen.description)));
  return all_well;
}

}  // namespace

Verb freeze_verb() {
  return {.name = "freeze",
          .places = "[SCENE]",
          .fewest_places = 0,
          .most_places = 1,
          .summary = "writes one step's problem to a file, to the last bit",
          .idea =
              "A world asks its solver one question a step: given these rows, masses and velocities, which "
              "impulses? This verb keeps the question: as JSON, with 17 digits, so that it reads back bit "
              "for bit and every solver can be given the very same. SCENE is the name of a scene, the path "
              "of a scene file, or a problem of the frozen set.",
          .flags = {{"step", "N", "after so many steps of a scene (30)"},
                    {"sweeps", "N", "of SI in the steps before (10)"},
                    {"out", "FILE", "where to (NAME.json; with --json: nowhere)"},
                    {"set", "DIR", "writes the whole frozen set into a folder"},
                    {"list", "", "what can be frozen"}},
          .examples = {"freeze stack --step 60", "freeze --set problems"},
          .run = run_freeze};
}

}  // namespace cairn::sandbox
