// Floor 10. Level 2 of the trade.
#include "study/trajectory_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/nearest.hpp"
#include "measure/fingerprint.hpp"
#include "study/build_info.hpp"
#include "study/jitter.hpp"
#include "scenes/scene_list.hpp"
#include "study/trade_row.hpp"
#include "world/scene_length.hpp"
#include "world/world.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

constexpr double start_jitter = 1e-6;  // [m]
constexpr int survival_starts = 16;
constexpr int agreeing_starts = 3;       // are enough, where they agree
constexpr double sweeps_of_a_step = 10;  // take as long as all else of a substep
constexpr double agreement = 0.01;       // of the distance at which the scene no longer stands

/// The value below which a share of the values lies.
double quantile(List<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<int>(share * (values.size() - 1))];
}

/// All runs of one point of the grid.
struct Runs {
  List<double> errors = {}, costs = {}, work = {}, stands = {}, penetrations = {}, drifts = {}, gains = {};
  List<double> losses = {}, steps = {}, updates = {};
  List<double> ways = {};  // [m] TrialResult::farthest
  int stood = 0;
  std::string status = "ok";  // of the last run, which is the first that was not ok
  std::uint64_t hash = 0;     // of the first start
};

void add_run(const TrajectoryScene& scene, const TrialResult& result, double error, Runs& runs) {
  if (runs.costs.empty()) runs.hash = result.state_hash;
  const bool failed = result.status != TrialStatus::ok;
  if (failed) runs.status = status_text(result.status);
  if (!failed && result.fell_at) runs.status = "fell";
  // Where a formula knows the motion, it says how wrong such a run is.
  if (runs.status == "ok" && !scene.watch && !result.failures.empty()) runs.status = "fails";
  runs.errors.push_back(failed || std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
  runs.costs.push_back(result.cost());
  runs.updates.push_back(static_cast<double>(result.row_updates));
  runs.work.push_back(result.seconds > 0 ? static_cast<double>(result.row_updates) / result.seconds : 0);
  runs.steps.push_back(result.steps > 0 ? 1e9 * result.step_seconds / result.steps : 0);
  runs.stands.push_back(result.stands_until);
  runs.ways.push_back(result.farthest);
  runs.penetrations.push_back(result.worst_penetration);
  runs.drifts.push_back(result.worst_drift);
  runs.gains.push_back(result.energy_gain);
  runs.losses.push_back(result.energy_loss);
  runs.stood += scene.stand_distance > 0 && result.stands() ? 1 : 0;
}

/// The options under which one start runs, until it falls or is seen to be too slow.
TrialOptions run_options(const TrajectoryScene& scene, const Setting& setting, bool& too_slow) {
  // Thirty times a second, however short the steps: it costs as much as finding contacts.
  const int every = std::max(1, static_cast<int>(std::lround(1 / (30 * setting.dt))));
  TrialOptions options{.seconds = scene.seconds, .penetration_every = every};
  if (scene.stand_distance > 0) options.stand_distance = scene.stand_distance;
  options.places = scene.places;
  const double with_steps = 1 + sweeps_of_a_step / setting.sweeps.iterations;
  options.gives_up = [&scene, &too_slow, with_steps](const TrialResult& so_far) {
    const double work = with_steps * static_cast<double>(so_far.row_updates);
    too_slow = so_far.seconds > scene.seconds / 10 && work > most_trajectory_work * so_far.seconds;
    return too_slow || so_far.fell_at.has_value();
  };
  return options;
}

/// The starts came to nearly the same places: none is likely to fall where these did not.
bool starts_agree(const TrajectoryScene& scene, const Runs& runs) {
  if (runs.ways.size() < agreeing_starts) return false;
  const auto [least, most] = std::minmax_element(runs.ways.begin(), runs.ways.end());
  return *most - *least <= agreement * scene.stand_distance;
}

Runs all_runs(const TrajectoryScene& scene, const Setting& setting) {
  Runs runs;
  for (int start = 0; start < scene.starts && !starts_agree(scene, runs); ++start) {
    const std::unique_ptr<MotionError> error = scene.watch ? scene.watch() : nullptr;
    bool too_slow = false;
    TrialOptions options = run_options(scene, setting, too_slow);
    if (error) options.observer = [&error](const Snapshot& snapshot) { error->see(snapshot); };
    const Scene made = scene.make();
    const auto seed = static_cast<std::uint64_t>(start);
    TrialResult result = run_trial(start == 0 ? made : jittered(made, start_jitter, seed), setting, options);
    if (too_slow && result.status == TrialStatus::ok) result.status = TrialStatus::timeout;
    add_run(scene, result, error ? error->value() : 0, runs);
    if (runs.status != "ok") break;  // it is not to be used for the scene
  }
  return runs;
}

/// The bodies at the start, and what tells this scene from others.
void set_scene(const TrajectoryScene& scene, TradeRow& row) {
  const Snapshot start = snapshot(World<double>(scene.make()));
  row.set("scene", scene.name);
  row.set("scene_hash", hexadecimal(scene.fingerprint != 0 ? scene.fingerprint : fingerprint_of(start)));
  const auto is_there = [](const SnapshotBody& body) { return !body.removed; };
  row.set("bodies",
          static_cast<long long>(std::count_if(start.bodies.begin(), start.bodies.end(), is_there)));
}

void set_setting(const Scene& scene, const Setting& setting, TradeRow& row) {
  const bool is_box2d = setting.solver == "box2d";
  const bool is_single = setting.scalar == Precision::single_precision || is_box2d;
  row.set("scalar", std::string(is_single ? "float" : "double"));
  row.set("solver", setting.solver);
  row.set("setting", setting_text(setting));
  row.set("dt", setting.dt);
  row.set("substeps", static_cast<long long>(setting.substeps));
  row.set("sweeps", static_cast<long long>(setting.sweeps.iterations));
  row.set("warm", std::string(setting.warm_start ? "warm" : "cold"));
  // Box2D bounds friction by the normal impulse of the sweep before, and brings its own stabilization.
  row.set("friction_model", std::string(is_box2d ? "lagged" : "coupled"));
  if (is_box2d) return;
  row.set("stabilizer", stabilization_text(setting.stabilization));
  row.set("beta", setting.stabilization.baumgarte);
  Scene stepped = scene;
  stepped.set_settings(with_setting(scene.settings(), setting));
  row.set("slop", *full_settings(stepped).stabilization.slop);
}

List<CsvCell> trajectory_row(const TrajectoryScene& scene, const Setting& setting) {
  const Runs runs = all_runs(scene, setting);
  TradeRow row;
  set_build(row);
  row.set("level", 2LL);
  set_scene(scene, row);
  set_setting(scene.make(), setting, row);
  row.set("status", runs.status);
  if (runs.status == "refused") return row.cells();
  row.set("starts", static_cast<long long>(runs.costs.size()));
  row.set("cost", quantile(runs.costs, 0.5));
  row.set("work", quantile(runs.work, 0.5));
  row.set("row_updates", static_cast<long long>(quantile(runs.updates, 0.5)));
  row.set("step_ns_med", quantile(runs.steps, 0.5));
  row.set("pen_max", quantile(runs.penetrations, 1));
  row.set("drift_max", quantile(runs.drifts, 1));
  row.set("dE_max_gain", quantile(runs.gains, 1));
  row.set("dE_final", -quantile(runs.losses, 0.5));
  if (scene.stand_distance > 0) {
    row.set("stands_until", quantile(runs.stands, 0.5));
    row.set("survival", static_cast<double>(runs.stood) / static_cast<double>(runs.costs.size()));
  }
  if (scene.watch) {
    row.set("err_name", scene.error_name);
    row.set("err_ref", scene.error_formula);
    row.set("ref_kind", std::string("formula"));
    row.set("err_value", quantile(runs.errors, 0.5));
    row.set("err_p90", quantile(runs.errors, 0.9));
  }
  row.set("state_hash", fmt::format("{:016x}", runs.hash));
  return row.cells();
}

}  // namespace

TrajectoryScene trajectory_scene(const std::string& name) {
  for (const AnsweredScene& scene : answered_scenes()) {
    if (scene.name != name) continue;
    return {.name = name,
            .make = scene.make,
            .seconds = scene.seconds,
            .error_name = scene.what,
            .error_formula = scene.formula,
            .watch = scene.watch};
  }
  if (!names_scene_file(name)) require_known(name, trajectory_names(), "tradeoff", "scene");
  const SceneEntry scene = scene_entry(name);
  double stands = scene.expectations.stands.value_or(0);
  for (const ExpectedPlace& place : scene.expectations.places)
    stands = stands > 0 ? std::min(stands, place.within) : place.within;
  return {.name = scene.name,
          .make = scene.make,
          .seconds = scene.seconds,
          .stand_distance = stands,
          .places = scene.expectations.places,
          .fingerprint = scene.fingerprint,
          .starts = stands > 0 ? survival_starts : 1};
}

List<std::string> trajectory_names() {
  List<std::string> names;
  for (const AnsweredScene& scene : answered_scenes()) names.push_back(scene.name);
  for (const SceneEntry& scene : scene_entries()) names.push_back(scene.name);
  return names;
}

Study trajectory_study(const List<TrajectoryScene>& scenes, const TrajectoryGrid& grid) {
  Study study{.name = "cairn work against error 2:", .header = trade_header(), .tasks = {}};
  for (const TrajectoryScene& scene : scenes) {
    study.name += fmt::format(" {} {:x} x{}", scene.name, scene.fingerprint, scene.starts);
    for (const std::string& solver : grid.solvers) {
      for (const int frequency : grid.frequencies) {
        for (const int substeps : grid.substeps) {
          for (const int sweeps : grid.sweeps) {
            Setting setting = grid.base;
            setting.solver = solver;
            setting.dt = 1.0 / frequency;
            setting.substeps = substeps;
            setting.sweeps.iterations = sweeps;
            study.tasks.push_back({.name = scene.name + ", " + setting_text(setting),
                                   .run = [scene, setting] { return trajectory_row(scene, setting); }});
          }
        }
      }
    }
  }
  study.name += ";";
  for (const std::string& solver : grid.solvers) study.name += " " + solver;
  study.name += fmt::format("; Hz {}; substeps {}; sweeps {}", fmt::join(grid.frequencies, " "),
                            fmt::join(grid.substeps, " "), fmt::join(grid.sweeps, " "));
  study.name += "; as " + setting_text(grid.base);
  return study;
}

}  // namespace cairn
