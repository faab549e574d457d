// Floor 11. Scenes, settings and runs of the map.
#include "tuning/map_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "measure/failure.hpp"
#include "scenes/solver_list.hpp"
#include "study/jitter.hpp"
#include "study/trial.hpp"
#include "tuning/recommend_scenes.hpp"
#include "tuning/tuner.hpp"

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

constexpr double longest_run = 2;      // [s]
constexpr double micrometre = 1e-6;    // [m]
constexpr double box_may_move = 0.05;  // [m] of boxes of 1 m
constexpr double looks_a_second = 30;  // [1/s] at which overlap is measured

void add_member(List<MapScene>& scenes, const std::string& family, double value, std::function<Scene()> make,
                double stands) {
  scenes.push_back({.family = family,
                    .value = value,
                    .scene = {.name = fmt::format("{} {:g}", family, value),
                              .make = std::move(make),
                              .seconds = longest_run,
                              .stand_distance = stands}});
}

void add_families(List<MapScene>& scenes) {
  for (const double top : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 1e4})
    add_member(
        scenes, "heavy-top", top, [top] { return tower_of_boxes(5, top); }, box_may_move);
  for (const int boxes : {2, 3, 5, 10, 20, 30, 50})
    add_member(
        scenes, "height", boxes, [boxes] { return tower_of_boxes(boxes); }, box_may_move);
  for (const int rows : {2, 3, 5, 8, 12})
    add_member(
        scenes, "pyramid", rows, [rows] { return pyramid_of_boxes(rows); }, box_may_move);
  for (const double bob : {1.0, 10.0, 100.0, 1e3, 1e4})
    add_member(
        scenes, "heavy-bob", bob, [bob] { return chain_with_bob(5, bob, ChainStart::level); }, 0);
  for (const int links : {1, 2, 5, 10, 20, 50})
    add_member(
        scenes, "length", links, [links] { return chain_with_bob(links, 1, ChainStart::level); }, 0);
}

double error_of(const TrialResult& run) { return std::max(run.worst_penetration, run.worst_drift); }

/// How a run of the map goes: what it must not do, and the formula where there is one.
struct MapWatch {
  std::unique_ptr<MotionError> formula = {};
  bool driven = false;
  bool slow = false;

  bool gains(const TrialResult& run) const { return !driven && run.energy_gain > largest_map_gain; }
  double error(const TrialResult& run) const { return formula ? formula->value() : error_of(run); }

  bool is_over(const TrialResult& so_far, const Setting& setting, double seconds) {
    const double work = counted_work(setting.solver, static_cast<double>(so_far.row_updates),
                                     static_cast<double>(so_far.rows));
    slow = so_far.seconds > seconds / 10 && work > most_map_work * so_far.seconds;
    const bool off = !formula && error_of(so_far) > largest_map_error;
    return slow || off || so_far.fell_at || gains(so_far);
  }

  std::string status(const TrialResult& run) const {
    if (run.status != TrialStatus::ok) return status_text(run.status);
    if (run.fell_at) return "fell";
    if (gains(run)) return "gained";
    if (slow) return "timeout";
    return error(run) <= largest_map_error ? "ok" : "off";
  }
};

/// With four digits, as many as a table of so many rows has room for.
CsvCell short_cell(double value) { return fmt::format("{:.4g}", value); }

List<CsvCell> map_row(const MapScene& entry, const Setting& setting) {
  const TrajectoryScene& scene = entry.scene;
  const Scene as_made = scene.make();
  MapWatch watch{.formula = scene.watch ? scene.watch() : nullptr, .driven = is_driven(as_made)};
  const int every = std::max(1, static_cast<int>(std::lround(1 / (looks_a_second * setting.dt))));
  const bool is_whole = watch.formula || !scene.places.empty();
  TrialOptions options{.seconds = is_whole ? scene.seconds : std::min(scene.seconds, longest_run),
                       .places = scene.places,
                       .penetration_every = every};
  if (scene.stand_distance > 0) options.stand_distance = scene.stand_distance;
  if (watch.formula) options.observer = [&watch](const Snapshot& now) { watch.formula->see(now); };
  options.gives_up = [&](const TrialResult& so_far) {
    return watch.is_over(so_far, setting, options.seconds);
  };
  const TrialResult run =
      run_trial(scene.stand_distance > 0 ? jittered(as_made, micrometre, 1) : as_made, setting, options);
  const double seconds = run.seconds > 0 ? run.seconds : 1;
  return {scene.name,
          entry.family,
          short_cell(entry.value),
          setting.solver,
          static_cast<long long>(std::lround(1 / setting.dt)),
          static_cast<long long>(setting.substeps),
          static_cast<long long>(setting.sweeps.iterations),
          stabilization_text(setting.stabilization),
          word_of(setting.scalar),
          watch.status(run),
          short_cell(static_cast<double>(run.rows) / seconds),
          short_cell(static_cast<double>(run.row_updates) / seconds),
          short_cell(watch.error(run))};
}

void add_settings(const std::string& solver, const List<int>& sweeps, List<Setting>& settings) {
  for (const int frequency : {30, 60, 120, 240}) {
    for (const int substeps : {1, 4}) {
      for (const int count : sweeps) {
        for (const Policy policy :
             {Policy::relaxed, Policy::soft, Policy::split_impulse, Policy::baumgarte}) {
          for (const Precision scalar : {Precision::double_precision, Precision::single_precision}) {
            Setting setting{.solver = solver, .scalar = scalar, .dt = 1.0 / frequency, .substeps = substeps};
            setting.sweeps.iterations = count;
            setting.stabilization.policy = policy;
            settings.push_back(setting);
          }
        }
      }
    }
  }
}

}  // namespace

const List<MapFamily>& map_families() {
  static const List<MapFamily> families = {
      {"heavy-top", "Five boxes, the top one heavier", "mass of the top box over that of the others"},
      {"height", "A stack of boxes", "boxes"},
      {"pyramid", "A pyramid of boxes", "layers"},
      {"heavy-bob", "A swinging chain of five links, and a bob", "mass of the bob over that of a link"},
      {"length", "A swinging chain", "links"}};
  return families;
}

List<MapScene> map_scenes() {
  List<MapScene> scenes;
  add_families(scenes);
  for (const std::string& name : trajectory_names()) scenes.push_back({.scene = trajectory_scene(name)});
  return scenes;
}

List<Setting> map_settings() {
  List<Setting> settings;
  for (const char* solver : {"si", "accelerated", "block", "jacobi-split"})
    add_settings(solver, {1, 3, 10, 30, 100}, settings);
  add_settings("newton", {1, 3, 10}, settings);
  return settings;
}

double counted_work(const std::string& solver, double updates, double rows) {
  const SolverEntry& entry = solver_entry(solver);
  const double weight = entry.work_of_a_sweep / entry.updates_a_row;
  return weight * updates + work_of_a_step * rows;
}

const List<std::string>& map_header() {
  static const List<std::string> header = {"scene",    "family",    "value",  "solver", "Hz",
                                           "substeps", "sweeps",    "policy", "scalar", "status",
                                           "rows/s",   "updates/s", "error"};
  return header;
}

Study map_study(const List<MapScene>& scenes, const List<Setting>& settings) {
  Study study{.name = "cairn map of settings:", .header = map_header(), .tasks = {}};
  const auto kept = std::make_shared<const List<MapScene>>(scenes);
  for (const MapScene& entry : *kept) {
    study.name += fmt::format(" {} {:x}", entry.scene.name, entry.scene.fingerprint);
    for (const Setting& setting : settings) {
      study.tasks.push_back({.name = entry.scene.name + ", " + setting_text(setting),
                             .run = [kept, &entry, setting] { return map_row(entry, setting); }});
    }
  }
  study.name += fmt::format("; {} settings", settings.size());
  return study;
}

}  // namespace cairn
