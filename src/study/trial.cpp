// Floor 10. Stepping, timing and measuring, in turns.
#include "study/trial.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "math/check.hpp"
#include "measure/trajectory.hpp"
#include "measure/violation.hpp"
#include "study/contestant.hpp"
#include "study/standing.hpp"

namespace cairn {

namespace {

void check_trial_options(const TrialOptions& options, double dt) {
  const double most_steps = 1e9;
  require(options.seconds >= 0 && options.seconds / dt <= most_steps, "run_trial", "seconds",
          "from 0 to 1e9 steps", options.seconds);
  require(options.stand_distance >= 0, "run_trial", "stand_distance", ">= 0 m", options.stand_distance);
  require(options.settle_seconds >= 0, "run_trial", "settle_seconds", ">= 0 s", options.settle_seconds);
  require(options.penetration_every >= 1, "run_trial", "penetration_every", ">= 1 step",
          options.penetration_every);
  require(options.fastest > 0, "run_trial", "fastest", "> 0 m/s", options.fastest);
  require(options.time_limit >= 0, "run_trial", "time_limit", ">= 0 s", options.time_limit);
  require(static_cast<bool>(options.clock), "run_trial", "clock", "a function", "none");
}

TrialStatus motion_status(const Snapshot& now, double fastest) {
  TrialStatus status = TrialStatus::ok;
  for (const SnapshotBody& body : now.bodies) {
    const bool finite =
        body.pose.position.allFinite() && std::isfinite(body.pose.angle) && body.velocity.allFinite();
    if (!finite) return TrialStatus::nan;
    const double speed = std::max(body.velocity.head<2>().norm(), std::abs(body.velocity.z()));
    if (speed > fastest) status = TrialStatus::diverged;
  }
  return status;
}

double farthest_from_start(const Snapshot& start, const Snapshot& now) {
  double farthest = 0;
  for (const BodyId body : now.bodies.indices()) {
    if (now.bodies[body].type != BodyType::dynamic) continue;
    farthest = std::max(farthest, (now.bodies[body].pose.position - start.bodies[body].pose.position).norm());
  }
  return farthest;
}

class Trial {
 public:
  Trial(Contestant& contestant, bool is_driven, const TrialOptions& options, TrialResult& result)
      : contestant_(contestant),
        options_(options),
        result_(result),
        start_(contestant.snapshot()),
        watch_(start_, !options.places.empty()),
        standing_(start_, options.stand_distance, std::min(options.settle_seconds, options.seconds / 2)),
        is_driven_(is_driven) {
    start_energy_ = energy_ = total_energy(start_);
    const double scale = energy_scale(start_);
    result_.energy_scale = scale > 0 ? scale : 1;
    note_places(start_);
    if (options_.observer) options_.observer(start_);
  }

  void run(int steps, double dt) {
    while (result_.steps < steps && result_.status == TrialStatus::ok) {
      if (!step()) break;
      result_.steps += 1;
      result_.seconds = result_.steps * dt;
      measure(contestant_.snapshot(), result_.steps == steps);
      if (options_.gives_up && options_.gives_up(result_)) break;
    }
    if (result_.status == TrialStatus::ok) {
      watch_.end(contestant_.snapshot(), result_.seconds);
      result_.failures = watch_.failures();
    }
    if (result_.steps == steps && is_out_of_place()) result_.fell_at = result_.stands_until = 0;
    if (!result_.fell_at) result_.stands_until = result_.seconds;
    if (residuals_ > 0) result_.mean_residual = residual_sum_ / residuals_;
    result_.state_hash = contestant_.state_hash();
  }

 private:
  /// False: the solver has refused.
  bool step() {
    try {
      do_events();
      measure_ahead();
      const double before = options_.clock();
      contestant_.step();
      result_.step_seconds += options_.clock() - before;
    } catch (const std::logic_error& refusal) {
      result_.status = TrialStatus::refused;
      result_.reason = refusal.what();
      return false;
    }
    return true;
  }

  /// What an event gives or takes is not the solver's doing: from there on, energy is held against what is
  /// left.
  void do_events() {
    if (!contestant_.do_events()) return;
    const Snapshot now = contestant_.snapshot();
    start_energy_ += total_energy(now) - energy_;
    result_.energy_scale = std::max(result_.energy_scale, energy_scale(now));
    watch_.scene_changed(now);
  }

  void measure_ahead() {
    if (options_.residual == ResidualMeasure::off) return;
    const std::optional<double> residual = contestant_.residual_ahead();
    if (!residual) return;
    residual_sum_ += *residual;
    residuals_ += 1;
    result_.worst_residual = std::max(result_.worst_residual.value_or(0), *residual);
  }

  void measure(const Snapshot& now, bool is_last) {
    result_.row_updates += contestant_.row_updates(now);
    result_.rows += contestant_.rows(now);
    if (options_.observer) options_.observer(now);
    result_.not_finite = contestant_.not_finite();
    result_.status = result_.not_finite ? TrialStatus::nan : motion_status(now, options_.fastest);
    if (result_.status == TrialStatus::nan) {
      result_.farthest = std::numeric_limits<double>::infinity();
      return note_fall();
    }
    result_.farthest = std::max(result_.farthest, farthest_from_start(start_, now));
    if (options_.places.empty() && !standing_.holds(now, result_.seconds)) note_fall();
    note_places(now);
    note_drift(now);
    watch_.see(now, result_.seconds);
    energy_ = total_energy(now);
    const double change = (energy_ - start_energy_) / result_.energy_scale;
    result_.energy_gain = std::max(result_.energy_gain, change);
    result_.energy_loss = -change;
    if (!is_driven_) watch_.see_gain(change, result_.seconds);
    if (is_last || result_.steps % options_.penetration_every == 0) {
      const List<Overlap> all = overlaps(now);
      note_overlap(deepest_of(all));
      watch_.see(all, result_.seconds);
    }
    result_.failures = watch_.failures();
    const bool late = options_.time_limit > 0 && result_.step_seconds > options_.time_limit;
    if (late && !is_last && result_.status == TrialStatus::ok) result_.status = TrialStatus::timeout;
  }

  void note_drift(const Snapshot& now) {
    for (const SnapshotJoint& joint : now.joints) {
      if (!(joint.drift > result_.worst_drift)) continue;
      result_.worst_drift = joint.drift;
      result_.drift_worst = {.time = result_.seconds, .a = joint.a, .b = joint.b, .joint = joint.name};
    }
  }

  void note_overlap(const Overlap& overlap) {
    if (!(overlap.depth > result_.worst_penetration)) return;
    result_.worst_penetration = overlap.depth;
    result_.penetration_worst = {.time = result_.seconds, .a = overlap.a, .b = overlap.b};
  }

  void note_places(const Snapshot& now) {
    result_.place_distances.clear();
    for (const ExpectedPlace& place : options_.places) {
      const Vec2<double> way = now.bodies[place.body].pose.position - place.position;
      result_.place_distances.push_back(way.norm());
    }
  }

  bool is_out_of_place() const {
    for (int i = 0; i < result_.place_distances.size(); ++i) {
      if (!(result_.place_distances[i] <= options_.places[i].within)) return true;
    }
    return false;
  }

  void note_fall() {
    if (!result_.fell_at) result_.fell_at = result_.stands_until = result_.seconds;
  }

  Contestant& contestant_;
  const TrialOptions& options_;
  TrialResult& result_;
  Snapshot start_;
  FailureWatch watch_;
  Standing standing_;
  bool is_driven_ = false;
  double energy_ = 0;        // [J] of the last snapshot
  double start_energy_ = 0;  // [J] of the start, and what events have given since
  double residual_sum_ = 0;
  int residuals_ = 0;
};

}  // namespace

std::string status_text(TrialStatus status) {
  switch (status) {
    case TrialStatus::ok:
      return "ok";
    case TrialStatus::diverged:
      return "diverged";
    case TrialStatus::nan:
      return "nan";
    case TrialStatus::refused:
      return "refused";
    case TrialStatus::timeout:
      break;
  }
  return "timeout";
}

double thread_cpu_seconds() {
  std::timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TrialResult run_trial(const Scene& scene, const Setting& setting, const TrialOptions& options) {
  check(setting);
  check_trial_options(options, setting.dt);
  TrialResult result;
  std::unique_ptr<Contestant> contestant;
  try {
    contestant = make_contestant(scene, setting);
  } catch (const std::logic_error& refusal) {
    result.status = TrialStatus::refused;
    result.reason = refusal.what();
    return result;
  }
  const int steps = static_cast<int>(std::lround(options.seconds / setting.dt));
  Trial(*contestant, is_driven(scene), options, result).run(steps, setting.dt);
  return result;
}

}  // namespace cairn
