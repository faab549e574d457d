// Floor 9. Level 2 of the trade.
#include <cairn/study/trajectory_study.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <cairn/math/nearest.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/study/jitter.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/world/scene_length.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

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
  List<TrialResult> results = {};
  List<double> errors = {};
  std::string status = "ok";  // of the last run, which is the first that was not ok

  /// The quantile of a number that each of them has.
  template <typename Number>
  double quantile(Number number, double share) const {
    List<double> values;
    for (const TrialResult& result : results)
      values.push_back(static_cast<double>(std::invoke(number, result)));
    return cairn::quantile(values, share);
  }
};

double step_nanoseconds(const TrialResult& result) {
  return result.steps > 0 ? 1e9 * result.step_seconds / result.steps : 0;
}

void add_run(const TrajectoryScene& scene, const TrialResult& result, double error, Runs& runs) {
  const bool failed = result.status != TrialStatus::ok;
  if (failed) runs.status = status_text(result.status);
  if (!failed && result.fell_at) runs.status = "fell";
  // Where a formula knows the motion, it says how wrong such a run is.
  if (runs.status == "ok" && !scene.watch && !result.failures.empty()) runs.status = "fails";
  runs.errors.push_back(failed || std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
  runs.results.push_back(result);
}

/// The options under which one start runs, until it falls or is seen to be too slow.
TrialOptions until_too_slow(const TrajectoryScene& scene, const Setting& setting, bool& too_slow) {
  TrialOptions options = trial_options(scene, setting);
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
  if (runs.results.size() < agreeing_starts) return false;
  const double least = runs.quantile(&TrialResult::farthest, 0),
               most = runs.quantile(&TrialResult::farthest, 1);
  return most - least <= agreement * scene.stand_distance;
}

Runs all_runs(const TrajectoryScene& scene, const Setting& setting) {
  Runs runs;
  for (int start = 0; start < scene.starts && !starts_agree(scene, runs); ++start) {
    const std::unique_ptr<MotionError> error = scene.watch ? scene.watch() : nullptr;
    bool too_slow = false;
    TrialOptions options = until_too_slow(scene, setting, too_slow);
    if (error) options.observer = [&error](const Snapshot& snapshot) { error->see(snapshot); };
    TrialResult result =
        run_trial(nth_start(scene.make(), static_cast<std::uint64_t>(start)), setting, options);
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
  row.set("starts", static_cast<long long>(runs.results.size()));
  row.set("cost", runs.quantile(&TrialResult::cost, 0.5));
  row.set("work", runs.quantile(&TrialResult::work, 0.5));
  row.set("row_updates", static_cast<long long>(runs.quantile(&TrialResult::row_updates, 0.5)));
  row.set("step_ns_med", runs.quantile(step_nanoseconds, 0.5));
  row.set("pen_max", runs.quantile(&TrialResult::worst_penetration, 1));
  row.set("drift_max", runs.quantile(&TrialResult::worst_drift, 1));
  row.set("dE_max_gain", runs.quantile(&TrialResult::energy_gain, 1));
  row.set("dE_final", -runs.quantile(&TrialResult::energy_loss, 0.5));
  if (scene.stand_distance > 0) {
    const auto stood = std::count_if(runs.results.begin(), runs.results.end(),
                                     [](const TrialResult& result) { return result.stands(); });
    row.set("stands_until", runs.quantile(&TrialResult::stands_until, 0.5));
    row.set("survival", static_cast<double>(stood) / static_cast<double>(runs.results.size()));
  }
  if (scene.watch) {
    row.set("err_name", scene.error_name);
    row.set("err_ref", scene.error_formula);
    row.set("ref_kind", std::string("formula"));
    row.set("err_value", quantile(runs.errors, 0.5));
    row.set("err_p90", quantile(runs.errors, 0.9));
  }
  row.set("state_hash", fmt::format("{:016x}", runs.results.front().state_hash));
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

TrialOptions trial_options(const TrajectoryScene& scene, const Setting& setting) {
  const int every = std::max(1, static_cast<int>(std::lround(1 / (30 * setting.dt))));
  TrialOptions options{.seconds = scene.seconds, .places = scene.places, .penetration_every = every};
  if (scene.stand_distance > 0) options.stand_distance = scene.stand_distance;
  return options;
}

SettingGrid trajectory_grid() {
  return {.solvers = {"si", "accelerated", "newton", "box2d", "block"},
          .frequencies = {30, 60, 120, 240, 480, 960},
          .substeps = {1, 4, 16},
          .sweeps = {1, 2, 4, 8, 16, 32, 64}};
}

Study trajectory_study(const List<TrajectoryScene>& scenes, const SettingGrid& grid) {
  Study study{.name = "cairn work against error 2:", .header = trade_header(), .tasks = {}};
  for (const TrajectoryScene& scene : scenes) {
    study.name += fmt::format(" {} {:x} x{}", scene.name, scene.fingerprint, scene.starts);
    for (const Setting& setting : settings_of(grid)) {
      study.tasks.push_back({.name = scene.name + ", " + setting_text(setting),
                             .run = [scene, setting] { return trajectory_row(scene, setting); }});
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
