// Floor 9. Level 2 of the trade.
#include <cairn/study/trajectory_study.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <cairn/math/nearest.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/study/exact_run.hpp>
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
  List<RunJudgement> judgements = {};
  List<double> errors = {};
  std::optional<double> exact_gap = {};  // [m] of start 0
  int failed = 0;                        // starts
  std::string status = "ok";             // of the first that was not ok

  /// The quantile of a number that each of them has.
  template <typename Number>
  double quantile(Number number, double share) const {
    List<double> values;
    for (const TrialResult& result : results)
      values.push_back(static_cast<double>(std::invoke(number, result)));
    return cairn::quantile(values, share);
  }
  /// The same of the shares of what is asked.
  double asked_share(double share) const {
    List<double> values;
    for (const RunJudgement& judgement : judgements) values.push_back(judgement.share());
    return cairn::quantile(values, share);
  }
};

double median_nanoseconds(const TrialResult& result) { return 1e9 * result.median_step; }

void add_run(const TrajectoryScene& scene, const TrialResult& result, double error, Runs& runs) {
  runs.judgements.push_back(judge(result, scene.wish));
  std::string status = status_text(result.status);
  if (result.status == TrialStatus::ok && result.fell_at) status = "fell";
  if (status == "ok" && runs.judgements.back().fails()) status = "fails";
  if (runs.status == "ok") runs.status = status;
  runs.failed += status != "ok" ? 1 : 0;
  const bool is_over = result.status == TrialStatus::ok && !std::isnan(error);
  runs.errors.push_back(is_over ? error : std::numeric_limits<double>::infinity());
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

/// The starts all failed, or came to nearly the same places: others are not likely to do otherwise.
bool starts_agree(const TrajectoryScene& scene, const Runs& runs) {
  if (runs.status == "refused" || runs.status == "timeout") return true;
  if (runs.results.size() < agreeing_starts) return false;
  if (runs.failed > 0) return runs.failed == runs.results.size();
  const double least = runs.quantile(&TrialResult::farthest, 0),
               most = runs.quantile(&TrialResult::farthest, 1);
  return most - least <= agreement * scene.stand_distance;
}

/// The exact run of a scene, once somebody asks for it.
class LazyExactRun {
 public:
  const ExactRun& of(const TrajectoryScene& scene) {
    if (!run_) run_ = scene.beside_exact ? ExactRun(scene.make(), scene.seconds) : ExactRun();
    return *run_;
  }

 private:
  std::optional<ExactRun> run_ = {};
};

Runs all_runs(const TrajectoryScene& scene, const Setting& setting, const ExactRun& exact) {
  Runs runs;
  const int exact_step = static_cast<int>(std::lround(exact.seconds() / setting.dt));
  for (int start = 0; start < scene.starts && !starts_agree(scene, runs); ++start) {
    const std::unique_ptr<MotionError> error = scene.watch ? scene.watch() : nullptr;
    bool too_slow = false;
    int step = 0;
    TrialOptions options = until_too_slow(scene, setting, too_slow);
    options.observer = [&](const Snapshot& snapshot) {
      if (error) error->see(snapshot);
      if (start == 0 && exact.is_known() && step == exact_step) runs.exact_gap = exact.gap(snapshot);
      step += 1;
    };
    TrialResult result =
        run_trial(nth_start(scene.make(), static_cast<std::uint64_t>(start)), setting, options);
    if (too_slow && result.status == TrialStatus::ok) result.status = TrialStatus::timeout;
    add_run(scene, result, error ? error->value() : 0, runs);
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

/// What it cost.
void set_cost(const Runs& runs, TradeRow& row) {
  row.set("cost", runs.quantile(&TrialResult::cost, 0.5));
  row.set("work", runs.quantile(&TrialResult::work, 0.5));
  row.set("row_updates", static_cast<long long>(runs.quantile(&TrialResult::row_updates, 0.5)));
  row.set("frame_ms", 1e3 * runs.quantile(&TrialResult::frame, 0.5));
  row.set("step_ns_med", runs.quantile(median_nanoseconds, 0.5));
  row.set("step_ns_max", 1e9 * runs.quantile(&TrialResult::slowest_step, 1));
  row.set("setup_ns", 1e9 * runs.quantile(&TrialResult::setup_seconds, 0.5));
}

/// What came out that an eye can see.
void set_errors(const Runs& runs, TradeRow& row) {
  row.set("pen_max", runs.quantile(&TrialResult::worst_penetration, 1));
  row.set("pen_med", runs.quantile(&TrialResult::worst_penetration, 0.5));
  row.set("drift_max", runs.quantile(&TrialResult::worst_drift, 1));
  row.set("drift_med", runs.quantile(&TrialResult::worst_drift, 0.5));
  row.set("of_body", runs.quantile(&TrialResult::of_body, 1));
  row.set("of_body_med", runs.quantile(&TrialResult::of_body, 0.5));
  row.set("jitter", runs.quantile(&TrialResult::jitter, 1));
  if (runs.exact_gap) row.set("exact_gap", *runs.exact_gap);
  row.set("dE_max_gain", runs.quantile(&TrialResult::energy_gain, 1));
  row.set("dE_final", -runs.quantile(&TrialResult::energy_loss, 0.5));
}

/// Beside what is asked.
void set_judgement(const TrajectoryScene& scene, const Runs& runs, TradeRow& row) {
  if (scene.stand_distance > 0) {
    const auto stood = std::count_if(runs.results.begin(), runs.results.end(),
                                     [](const TrialResult& result) { return result.stands(); });
    row.set("stands_until", runs.quantile(&TrialResult::stands_until, 0.5));
    row.set("survival", static_cast<double>(stood) / static_cast<double>(runs.results.size()));
  }
  row.set("failed", static_cast<double>(runs.failed) / static_cast<double>(runs.results.size()));
  if (!scene.wish.is_empty()) {
    row.set("asked", runs.asked_share(1));
    row.set("asked_med", runs.asked_share(0.5));
    const auto worst =
        std::max_element(runs.judgements.begin(), runs.judgements.end(),
                         [](const RunJudgement& a, const RunJudgement& b) { return a.share() < b.share(); });
    if (worst->worst() != nullptr) row.set("asked_most", worst->worst()->name);
  }
  if (!scene.watch) return;
  row.set("err_name", scene.error_name);
  row.set("err_ref", scene.error_formula);
  row.set("ref_kind", std::string("formula"));
  row.set("err_value", quantile(runs.errors, 0.5));
  row.set("err_p90", quantile(runs.errors, 0.9));
}

List<CsvCell> trajectory_row(const TrajectoryScene& scene, const Setting& setting, const ExactRun& exact) {
  const Runs runs = all_runs(scene, setting, exact);
  TradeRow row;
  set_build(row);
  row.set("level", 2LL);
  set_scene(scene, row);
  set_setting(scene.make(), setting, row);
  row.set("status", runs.status);
  if (runs.status == "refused") return row.cells();
  row.set("starts", static_cast<long long>(runs.results.size()));
  set_cost(runs, row);
  set_errors(runs, row);
  set_judgement(scene, runs, row);
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
          .wish = wish_of(scene),
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
  TrialOptions options{.seconds = scene.seconds, .places = scene.wish.places, .penetration_every = every};
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
    const auto exact = std::make_shared<LazyExactRun>();
    for (const Setting& setting : settings_of(grid)) {
      study.tasks.push_back(
          {.name = scene.name + ", " + setting_text(setting),
           .run = [scene, setting, exact] { return trajectory_row(scene, setting, exact->of(scene)); }});
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
