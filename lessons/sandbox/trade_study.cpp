// Studies of work against error, from the words of a command line.
#include "lessons/sandbox/reports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <cairn/study/frozen/frozen_set.hpp>
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/charts.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/scenes/scene_list.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/trajectory_study.hpp>
#include <cairn/study/work_precision.hpp>
#include <cairn/study/tuning/map_study.hpp>

namespace cairn::sandbox {
namespace {

/// An error that can stand on the axis.
struct ErrorColumn {
  std::string word = {};
  std::string column = {};
  std::string axis = {};
};

const List<ErrorColumn>& solve_errors() {
  static const List<ErrorColumn> errors = {
      {"R_E", "R_E_v", "R_{E}: energy left over energy at the start"},
      {"E_M", "E_M", "E_{M}: distance from the true velocity over that at the start"}};
  return errors;
}

const List<ErrorColumn>& trajectory_errors() {
  static const List<ErrorColumn> errors = {
      {"expect", "asked", "the worst of what the scene asks for, over its limit"},
      {"formula", "err_value", "error of "},
      {"body", "of_body", "worst overlap or gap, of the thinner body"},
      {"penetration", "pen_max", "worst overlap (m)"},
      {"drift", "drift_max", "worst drift of a joint (m)"},
      {"energy", "dE_max_gain", "energy gained, of the scene's scale"},
      {"jitter", "jitter", "motion of what rests (m/s)"},
      {"exact", "exact_gap", "distance from the exact run after a second (m)"}};
  return errors;
}

const ErrorColumn& error_of(const Words& words, const List<ErrorColumn>& errors,
                            const std::string& standard) {
  List<std::string> known;
  for (const ErrorColumn& error : errors) known.push_back(error.word);
  const std::string word = words.word("error", standard, known);
  return *std::find_if(errors.begin(), errors.end(), [&](const ErrorColumn& e) { return e.word == word; });
}

std::string lower_is_better(const std::string& axis) { return axis + "    lower is better ↓"; }
std::string left_is_better(const std::string& axis) { return "← cheaper    " + axis; }

/// `others`: contestants that are no solvers.
List<std::string> solvers_of(const Words& words, const List<std::string>& standard,
                             const List<std::string>& others) {
  const List<std::string> given = words.known_texts("solvers", solver_names(others));
  return given.empty() ? standard : given;
}

List<std::string> first_four(List<std::string> solvers) {
  solvers.resize(std::min(4, solvers.size()));
  return solvers;
}

/// Level 1: frozen problems.
TradeStudy solve_trade(const Words& words, const List<std::string>& names) {
  words.refuse_beside("contact-search", "for one step (level 1)");
  SolveGrid grid;
  const bool by_time = words.word("work", "updates", {"updates", "time"}) == "time";
  grid.solvers = solvers_of(words, grid.solvers, {});
  const std::string start = words.word("start", "cold", {"cold", "warm"});
  const std::string scalar = words.word("scalar", "double", {"double", "float"});
  if (words.has("quick")) {
    grid.scalars = {scalar == "double" ? Precision::double_precision : Precision::single_precision};
    grid.timing = {.repetitions = by_time ? 10 : 0, .seconds = by_time ? 0.01 : 0};
  }
  List<FrozenProblem> problems;
  for (const std::string& name : names) problems.push_back(make_frozen(name));
  const ErrorColumn& error = error_of(words, solve_errors(), "R_E");
  return {
      .study = solve_study(problems, grid),
      .level = 1,
      .name = names.size() == 1 ? names.front() : "level1",
      .title = fmt::format("{}: one step, from a {} start, in {}",
                           names.size() == 1 ? unmarked(names.front()) : "frozen problems", start, scalar),
      .note = names.size() == 1 ? problems.front().description : "",
      .work = by_time ? "solve_ns_med" : "row_updates",
      .error = error.column,
      .work_name = by_time ? "time (ns)" : "row updates",
      .error_name = error.word,
      .work_axis = left_is_better(by_time ? "time of one solve (ns)" : "row updates of one solve"),
      .error_axis = lower_is_better(error.axis),
      .curves = first_four(grid.solvers),
      .shown = {{"warm", start}, {"scalar", scalar}}};
}

SettingGrid grid_of(const Words& words) {
  SettingGrid grid = trajectory_grid();
  if (!has_box2d()) {
    grid.solvers.erase(std::remove(grid.solvers.begin(), grid.solvers.end(), "box2d"), grid.solvers.end());
  }
  set_search(words, grid.base);
  grid.solvers =
      solvers_of(words, grid.solvers, has_box2d() ? List<std::string>{"box2d"} : List<std::string>{});
  refuse_idle_flags(words, grid.solvers);
  if (!words.has("quick")) return grid;
  grid.frequencies = {60, 120, 240};
  grid.substeps = {1, 4};
  grid.sweeps = {1, 4, 16, 64};
  return grid;
}

/// Says which solvers the scene is nothing for before their first step.
void require_runnable(const Words& words, const TrajectoryScene& scene, const SettingGrid& grid) {
  List<std::string> refusals;
  for (const std::string& solver : grid.solvers) {
    Setting setting = grid.base;
    setting.solver = solver;
    const TrialResult start = run_trial(scene.make(), setting, {.seconds = 0});
    if (start.status == TrialStatus::refused)
      refusals.push_back(fmt::format("{} cannot run {}: {}", solver, scene.name, start.reason));
  }
  if (refusals.size() == grid.solvers.size()) throw UsageError("cairn tradeoff: " + joined(refusals, "; "));
  for (const std::string& refusal : refusals)
    Console(words.console).warn("cairn tradeoff: " + refusal + "; it is left out");
}

std::string trajectory_note(const TrajectoryScene& scene) {
  if (scene.watch) return "The formula: " + scene.error_formula + ".";
  return scene.starts > 1
             ? fmt::format(
                   "The worst of up to {} starts, 1e-6 m apart; settings under which it falls are left out.",
                   scene.starts)
             : "";
}

/// Level 2: whole runs.
TradeStudy trajectory_trade(const Words& words, const List<std::string>& names) {
  for (const char* flag : {"start", "scalar"}) words.refuse_beside(flag, "for whole runs (level 2)");
  const SettingGrid grid = grid_of(words);
  List<TrajectoryScene> scenes;
  for (const std::string& name : names) {
    scenes.push_back(trajectory_scene(name));
    if (words.has("quick")) scenes.back().starts = std::min(scenes.back().starts, 2);
  }
  const TrajectoryScene& first = scenes.front();
  const bool is_asked = !first.wish.is_empty();
  const ErrorColumn& error = error_of(words, trajectory_errors(),
                                      first.watch ? "formula"
                                      : is_asked  ? "expect"
                                                  : "body");
  const bool by_formula = error.word == "formula";
  if (by_formula && !first.watch)
    words.refuse("error", "another, as no formula knows this scene", error.word);
  if (error.word == "expect" && !is_asked)
    words.refuse("error", "another, as this scene expects nothing ([expect])", error.word);
  const bool by_time = words.word("work", "time", {"updates", "time"}) == "time";
  if (scenes.size() == 1) require_runnable(words, first, grid);
  return {.study = trajectory_study(scenes, grid),
          .level = 2,
          .name = names.size() == 1 ? first.name : "level2",
          .title = fmt::format("{}: {:.3g} s", unmarked(first.name), first.seconds),
          .note = trajectory_note(first),
          .work = by_time ? "frame_ms" : "work",
          .error = error.column,
          .work_name = by_time ? "ms a frame" : "updates/s",
          .error_name = error.word,
          .work_axis = left_is_better(by_time ? "processor time for a 60th of a second (ms)"
                                              : "row updates for each second simulated"),
          .error_axis = lower_is_better(error.axis + (by_formula ? first.error_name : "")),
          .curves = first_four(grid.solvers),
          .shown = {}};
}

/// Several whole runs: what more sweeps of a solver buy in each.
TradeStudy sweeps_trade(const Words& words) {
  for (const char* flag : {"level", "all", "quick", "work", "start", "scalar", "labels", "shard", "merge"})
    words.refuse_beside(flag, "beside several scenes");
  const List<std::string> solvers = words.known_texts("solvers", solver_names());
  if (solvers.size() > 1) words.refuse("solvers", "one, beside several scenes", joined(solvers, ","));
  SettingGrid grid{.solvers = solvers.empty() ? List<std::string>{"si"} : solvers,
                   .frequencies = {60},
                   .substeps = {4},
                   .sweeps = doubled(1, 64)};
  set_search(words, grid.base);
  List<TrajectoryScene> scenes;
  TradeStudy trade{.study = {}, .level = 2, .name = "sweeps", .is_of_sweeps = true};
  for (const std::string& name : words.places) {
    if (!names_scene_file(name))
      words.require_known("SCENE, of several,", name, trajectory_names(), "cairn tradeoff --list");
    scenes.push_back(trajectory_scene(name));
    scenes.back().starts = 1;
    scenes.back().beside_exact = false;
    trade.curves.push_back(scenes.back().name);
  }
  const ErrorColumn& error = error_of(words, trajectory_errors(), "body");
  if (error.word == "formula") words.refuse("error", "another, beside several scenes", error.word);
  trade.study = trajectory_study(scenes, grid);
  trade.title = fmt::format("1 to 64 sweeps of {}, 60 Hz in 4 substeps", grid.solvers.front());
  trade.note = "Every run that does not fail is drawn. Where a curve rises, more work has made it worse.";
  trade.error = error.column;
  trade.error_name = error.axis;
  trade.work_axis = left_is_better("sweeps of a substep");
  trade.error_axis = lower_is_better(error.axis);
  return trade;
}

/// Level 3: the map of settings.
TradeStudy map_trade(const Words& words) {
  for (const char* flag : {"start", "scalar", "quick", "solvers", "work", "error", "contact-search"})
    words.refuse_beside(flag, "for the map of settings (level 3)");
  return {.study = map_study(map_scenes(), map_settings()), .level = 3, .name = "level3"};
}

}  // namespace

TradeStudy trade_study(const Words& words) {
  const bool all = words.has("all");
  if (all == !words.places.empty()) {
    throw UsageError(
        "cairn tradeoff: it goes cairn tradeoff SCENE, or several, or cairn tradeoff --all; --list shows the "
        "scenes");
  }
  if (all) words.refuse_beside("labels", "beside --all, which draws no settings");
  if (words.places.size() > 1) return sweeps_trade(words);
  const std::string name = all ? "" : words.places.front();
  const bool is_frozen = std::count(frozen_names().begin(), frozen_names().end(), name) > 0;
  const int level = words.whole("level", all || is_frozen ? 1 : 2, 1, all ? 3 : 2);
  if (level == 3) return map_trade(words);
  const List<std::string> everything = level == 1 ? frozen_names() : trajectory_names();
  const bool is_file = level == 2 && names_scene_file(name);
  if (!all && !is_file)
    words.require_known(level == 1 ? "SCENE, of level 1," : "SCENE, of level 2,", name, everything,
                        "cairn tradeoff --list");
  const List<std::string> names = all ? everything : List<std::string>{name};
  return level == 1 ? solve_trade(words, names) : trajectory_trade(words, names);
}

}  // namespace cairn::sandbox
