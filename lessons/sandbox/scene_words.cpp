// From flags to a setting.
#include "lessons/sandbox/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/kit/words.hpp"
#include <cairn/scenes/default_setting.hpp>
#include <cairn/scenes/solver_list.hpp>

namespace cairn::sandbox {
namespace {

int sweeps_behind(const Words& words, std::string_view flag, const std::string& text, std::size_t colon) {
  const std::optional<double> sweeps = parse_number(text.substr(colon + 1));
  const bool fits =
      sweeps && std::trunc(*sweeps) == *sweeps && *sweeps >= 0 && *sweeps <= Setting::most_sweeps;
  if (!fits)
    words.refuse(
        flag,
        fmt::format("a solver, or a solver and its 0 to {} sweeps, such as si:10", Setting::most_sweeps),
        text);
  return static_cast<int>(*sweeps);
}

double step_of(const Words& words, double standard) {
  if (words.has("dt") && words.has("frequency")) {
    throw UsageError("cairn " + words.verb + ": --dt and --frequency say the same; give one of them");
  }
  if (words.has("dt")) {
    // A fraction says it best, and read_quantity() knows none.
    const std::optional<double> fraction = parse_number(*words.text("dt"));
    if (fraction && *fraction > 0) return *fraction;
    return words.quantity("dt", "s", standard);
  }
  return words.has("frequency") ? 1 / words.number("frequency", 60, 1e-3, 1e9) : standard;
}

/// What a flag says of an enumeration.
template <typename Enum>
void choose(const Words& words, std::string_view flag, Enum& chosen) {
  if (words.has(flag)) chosen = value_of<Enum>(words.word(flag, "", words_of<Enum>()));
}

/// "a, b or c".
template <typename Enum>
std::string either() {
  const List<std::string> words = words_of<Enum>();
  return joined({words.begin(), words.end() - 1}, ", ") + " or " + words.back();
}

bool is_world_stepped(const SolverEntry& solver) { return solver.uses_world; }

/// The flags that not every solver takes, by what its entry says.
struct TakenFlag {
  const char* flag = "";
  bool (*taken)(const SolverEntry&) = nullptr;
};
constexpr TakenFlag taken_flags[] = {
    {"sweeps", [](const SolverEntry& solver) { return solver.uses_sweeps; }},
    {"tolerance", [](const SolverEntry& solver) { return solver.uses_world && solver.uses_sweeps; }},
    {"cold", [](const SolverEntry& solver) { return solver.uses_warm_start; }},
    {"contact-search", is_world_stepped},
    {"scalar", is_world_stepped},
    {"stabilization", is_world_stepped}};

}  // namespace

void refuse_idle_flags(const Words& words, const List<std::string>& solvers) {
  for (const TakenFlag& each : taken_flags) {
    const auto takes = [&each](const std::string& solver) { return each.taken(solver_entry(solver)); };
    if (std::none_of(solvers.begin(), solvers.end(), takes))
      words.refuse_beside(each.flag, "to " + joined(solvers, ", "));
  }
}

SceneEntry scene_of(const Words& words, const std::string& name, List<std::string> others) {
  if (!names_scene_file(name)) {
    const std::string list = others.empty() ? "cairn list scenes" : "cairn " + words.verb + " --list";
    for (const SceneEntry& entry : scene_entries()) others.push_back(entry.name);
    words.require_known("SCENE", name, others, list);
  }
  SceneEntry scene = scene_entry(name);
  if (scene.make().bodies().size() == 1) {  // the ground
    throw UsageError("cairn " + words.verb + ": " + name + ": bodies must be at least one, got none");
  }
  return scene;
}

List<Flag> search_flags() { return {{"contact-search", "WHICH", either<ContactSearch>()}}; }

void set_search(const Words& words, Setting& setting) {
  choose(words, "contact-search", setting.contact_search);
}

List<Flag> setting_flags() {
  List<Flag> flags = {
      {"solver", "NAME",
       "or NAME:SWEEPS, such as si:10; cairn list solvers (the scene's own, as all of these)"},
      {"sweeps", "N", fmt::format("over all rows, at most; from 0 to {}", Setting::most_sweeps)},
      {"tolerance", "NUMBER", "a solver stops once R_E is at most this; 0: never sooner"},
      {"substeps", "N", "of which a step is made"}};
  flags = joined_flags(flags, search_flags());
  return joined_flags(
      flags, {{"frequency", "HZ", "steps a second"},
              {"dt", "TIME", "the length of a step, such as 1/60 or 2ms, in place of --frequency"},
              {"scalar", "WHICH", either<Precision>()},
              {"stabilization", "WHICH", either<StabilizationPolicy>() + "; cairn list stabilizations"},
              {"cold", "", "every step begins without the impulses of the last"}});
}

Setting with_solver(const Words& words, std::string_view flag, Setting setting, const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string given = text.substr(0, colon);
  const List<std::string> known = contestant_names();
  const std::string name = known_word(given, known);
  setting.solver = name.empty() ? given : name;
  if (const std::string refusal = solver_refusal(setting); !refusal.empty())
    words.refuse(flag, refusal, setting.solver);
  if (name.empty()) {
    const std::string meant = nearest(given, known);
    words.refuse(flag, "one of " + joined(known, ", "),
                 given + (meant.empty() ? "" : "; did you mean " + meant + "?"));
  }
  if (colon == std::string::npos) return setting;
  if (!solver_entry(name).uses_sweeps) words.refuse(flag, name + " without sweeps, which it has not", text);
  setting.sweeps.iterations = sweeps_behind(words, flag, text, colon);
  return setting;
}

std::string why_chosen(const SceneEntry& scene, const Setting& setting) {
  const DefaultSetting usual = default_setting(scene.make());
  const bool is_usual = setting.solver == usual.setting.solver &&
                        setting.substeps == usual.setting.substeps &&
                        setting.sweeps.iterations == usual.setting.sweeps.iterations &&
                        setting.sweeps.tolerance == usual.setting.sweeps.tolerance;
  return is_usual ? usual.reason : "";
}

Setting setting_of(const Words& words, const SceneEntry& scene) {
  const Setting setting = common_setting(words, scene);
  refuse_idle_flags(words, {setting.solver});
  return setting;
}

Setting common_setting(const Words& words, const SceneEntry& scene) {
  Setting setting = scene.setting;
  choose(words, "scalar", setting.scalar);
  if (const std::optional<std::string> solver = words.text("solver")) {
    setting = with_solver(words, "solver", setting, *solver);
    if (solver->find(':') != std::string::npos) words.refuse_beside("sweeps", "beside --solver " + *solver);
  }
  setting.sweeps.iterations = words.whole("sweeps", setting.sweeps.iterations, 0, Setting::most_sweeps);
  setting.sweeps.tolerance = words.number("tolerance", setting.sweeps.tolerance, 0, 1);
  setting.substeps = words.whole("substeps", setting.substeps, 1, SceneSettings::most_substeps);
  set_search(words, setting);
  setting.dt = step_of(words, setting.dt);
  choose(words, "stabilization", setting.stabilization.policy);
  if (words.has("cold")) setting.warm_start = false;
  check(setting);
  return setting;
}

std::string flags_text(const Setting& setting, const Setting& usual) {
  std::string text = "--solver " + setting.solver;
  if (solver_entry(setting.solver).uses_sweeps) text += fmt::format(":{}", setting.sweeps.iterations);
  if (setting.sweeps.tolerance != usual.sweeps.tolerance)
    text += fmt::format(" --tolerance {:g}", setting.sweeps.tolerance);
  if (setting.dt != usual.dt) text += fmt::format(" --frequency {:.12g}", 1 / setting.dt);
  if (setting.substeps != usual.substeps) text += fmt::format(" --substeps {}", setting.substeps);
  if (setting.contact_search != usual.contact_search)
    text += fmt::format(" --contact-search {}", word_of(setting.contact_search));
  if (setting.stabilization.policy != usual.stabilization.policy)
    text += fmt::format(" --stabilization {}", word_of(setting.stabilization.policy));
  if (setting.scalar != usual.scalar) text += fmt::format(" --scalar {}", word_of(setting.scalar));
  return text;
}

double seconds_of(const Words& words, const SceneEntry& scene) {
  return words.quantity("seconds", "s", scene.seconds);
}

List<Flag> joined_flags(List<Flag> first, const List<Flag>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace cairn::sandbox
