// A trial with an observer that keeps what is wanted.
#include "lessons/sandbox/scene_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <sstream>

#include "lessons/sandbox/progress_line.hpp"
#include <cairn/math/check.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/measure/violation.hpp>

namespace cairn::sandbox {
namespace {

double sum_of_normal_impulses(const Snapshot& snapshot) {
  double sum = 0;
  for (const SnapshotContact& contact : snapshot.contacts) sum += contact.normal_impulse;
  return sum;
}

/// Watches a run from outside: nothing that it does changes what is seen.
class RunKeeper {
 public:
  RunKeeper(const Setting& setting, const RunWish& wish, SceneRun& run)
      : dt_(setting.dt), wish_(wish), run_(run) {
    if (wish_.series) {
      run_.series.header = {"step",          "time_s",      "kinetic_J",   "potential_J",
                            "penetration_m", "drift",       "contacts",    "normal_impulse_Ns",
                            "fastest_m_s",   "energy_gain", "energy_loss", "row_updates"};
    }
  }

  void see(const Snapshot& snapshot) {
    const bool finite = is_finite(snapshot);
    const Overlap in_ground = deepest_in_ground(snapshot);
    if (in_ground.depth > run_.in_ground.depth) run_.in_ground = in_ground;
    run_.occurrences.see(snapshot);
    const long long step = seen_++;
    const double time = static_cast<double>(step) * dt_;  // [s]
    // As many frames as have become due; where steps are longer than frames, each step is one.
    if (wish_.frames_per_second > 0 && finite) latest_ = snapshot;
    if (wish_.frames_per_second > 0 && finite && time >= next_frame_ - 1e-9) {
      run_.frames.push_back(snapshot);
      while (time >= next_frame_ - 1e-9)
        next_frame_ = static_cast<double>(++frame_) / wish_.frames_per_second;
    }
    if (wish_.series && finite) add_row(snapshot, step, time);
    if (run_.tracks && finite) run_.tracks->add(snapshot);
  }

  /// The last frame of a run that ends badly is that of its end, whether one was due or not.
  void end(const TrialResult& result) {
    if (result.status == TrialStatus::ok || !latest_) return;
    if (run_.frames.empty() || run_.frames.back().step != latest_->step) run_.frames.push_back(*latest_);
  }

  /// What only the trial knows of the step that was seen last.
  void count(const TrialResult& so_far) {
    if (!run_.series.rows.empty()) {
      List<CsvCell>& row = run_.series.rows.back();
      row[row.size() - 3] = so_far.energy_gain;
      row[row.size() - 2] = so_far.energy_loss;
      row.back() = so_far.row_updates - updates_before_;
    }
    updates_before_ = so_far.row_updates;
  }

 private:
  void add_row(const Snapshot& snapshot, long long step, double time) {
    double fastest = 0;
    for (const SnapshotBody& body : snapshot.bodies)
      fastest = std::max(fastest, body.velocity.head<2>().norm());
    run_.series.rows.push_back({step, time, kinetic_energy(snapshot), potential_energy(snapshot),
                                worst_penetration(snapshot), worst_joint_drift(snapshot),
                                static_cast<long long>(snapshot.contacts.size()),
                                sum_of_normal_impulses(snapshot), fastest, 0.0, 0.0, 0LL});
  }

  double dt_;
  const RunWish& wish_;
  SceneRun& run_;
  long long seen_ = 0;
  long long frame_ = 0;
  double next_frame_ = 0;                // [s]
  std::optional<Snapshot> latest_ = {};  // where there are frames
  std::int64_t updates_before_ = 0;
};

TrackNames track_names(const SceneEntry& scene) {
  const Scene made = scene.make();
  return {.bodies = scene.body_names,
          .joints = scene.joint_ids,
          .sensors = sensors_of(made),
          .counters = counters_of(made)};
}

}  // namespace

SceneRun run_scene(const SceneEntry& scene, const Setting& setting, const RunWish& wish,
                   const ConsoleSettings& console) {
  SceneRun run{.setting = setting};
  if (!wish.tracks.empty()) run.tracks = std::make_shared<TrackRecorder>(wish.tracks, track_names(scene));
  RunKeeper keeper(setting, wish, run);
  TrialOptions options = trial_options(scene);
  options.seconds = wish.seconds;
  options.residual = ResidualMeasure::last_step;
  options.whole_impulses = wish.series || run.tracks;
  const double steps = std::round(wish.seconds / setting.dt);
  require(steps >= 1, scene.name, "seconds", fmt::format("at least a step of {:g} s", setting.dt),
          wish.seconds);
  require(steps <= 1e9, "run_scene", "seconds", "from 0 to 1e9 steps", wish.seconds);
  const int judged_at = static_cast<int>(std::lround(std::min(scene.seconds, wish.seconds) / setting.dt));
  std::optional<TrialResult> judged;
  ProgressLine progress(console, "steps", static_cast<int>(steps));
  options.observer = [&keeper](const Snapshot& snapshot) { keeper.see(snapshot); };
  options.gives_up = [&](const TrialResult& so_far) {
    keeper.count(so_far);
    progress.advance(so_far.steps);
    if (so_far.steps == judged_at) judged = so_far;
    run.stopped = wish.stops && wish.stops();
    return run.stopped;
  };
  run.result = run_trial(scene.make(), setting, options);
  progress.clear();
  keeper.end(run.result);
  // A run that was shorter than the scene's own time, or that ended badly, is judged as far as it came.
  if (!judged || run.result.steps <= judged_at || run.result.status != TrialStatus::ok) judged = run.result;
  judged->failures = run.result.failures;
  run.result.place_distances = judged->place_distances;
  Wish expected = wish_of(scene);
  if (judged->seconds < scene.seconds - setting.dt / 2) expected.places.clear();  // they are of its end
  run.judgement = judge(*judged, expected, scene.body_names);
  return run;
}

std::string series_csv(const CsvTable& series) {
  std::ostringstream text;
  write_csv(text, series);
  return text.str();
}

}  // namespace cairn::sandbox
