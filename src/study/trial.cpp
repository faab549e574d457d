// Floor 9. Stepping, timing and measuring, in turns.
#include <cairn/study/trial.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include <cairn/math/check.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/measure/energy_account.hpp>
#include <cairn/measure/violation.hpp>
#include <cairn/study/contestant.hpp>
#include <cairn/study/shaking.hpp>
#include <cairn/study/standing.hpp>

namespace cairn {

namespace {

constexpr double last_seconds = 1;  // [s] at the end of a run, in which what rests is looked at

void check_trial_options(const TrialOptions& options, double dt) {
  const double most_steps = 1e9;
  require(options.seconds >= 0 && options.seconds / dt <= most_steps, "run_trial", "seconds",
          "from 0 to 1e9 steps", options.seconds);
  require(options.stand_distance >= 0, "run_trial", "stand_distance", ">= 0 m", options.stand_distance);
  require(options.settle_seconds >= 0, "run_trial", "settle_seconds", ">= 0 s", options.settle_seconds);
  require(options.penetration_every >= 1, "run_trial", "penetration_every", ">= 1 step",
          options.penetration_every);
  require(options.most_energy > 0, "run_trial", "most_energy", "> 0", options.most_energy);
  require(options.time_limit >= 0, "run_trial", "time_limit", ">= 0 s", options.time_limit);
  require(static_cast<bool>(options.clock), "run_trial", "clock", "a function", "none");
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
  Trial(Contestant& contestant, const Scene& scene, const TrialOptions& options, TrialResult& result)
      : contestant_(contestant),
        options_(options),
        result_(result),
        start_(contestant.snapshot()),
        energy_(start_),
        drive_(scene),
        watch_(start_, !options.places.empty()),
        standing_(start_, options.stand_distance, std::min(options.settle_seconds, options.seconds / 2)),
        shaking_(options.seconds - std::min(last_seconds, options.seconds / 2)),
        is_driven_(is_driven(scene)) {
    if (options_.whole_impulses) contestant_.sum_impulses();
    result_.thinnest = thinnest_body(start_);
    note_energy();
    note_places(start_);
    if (options_.observer) options_.observer(start_);
  }

  void run(int steps, double dt) {
    while (result_.steps < steps && result_.status == TrialStatus::ok) {
      if (!step(result_.steps + 1 == steps)) break;
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
    result_.jitter = shaking_.speed();
    note_step_times();
    if (residuals_ > 0) result_.mean_residual = residual_sum_ / residuals_;
    result_.state_hash = contestant_.state_hash();
  }

 private:
  /// False: the solver has refused.
  bool step(bool is_last) {
    try {
      do_events();
      measure_ahead(is_last);
      const double before = options_.clock();
      contestant_.step();
      step_times_.push_back(options_.clock() - before);
      result_.step_seconds += step_times_.back();
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
    energy_.scene_changed(now);
    watch_.scene_changed(now);
  }

  void measure_ahead(bool is_last) {
    if (options_.residual == ResidualMeasure::off) return;
    if (options_.residual == ResidualMeasure::last_step && !is_last) return;
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
    if (const std::optional<double> residual = contestant_.unfinished()) {
      result_.unfinished_steps += 1;
      result_.unfinished_residual = std::max(result_.unfinished_residual, *residual);
    }
    result_.not_finite = contestant_.not_finite();
    if (result_.not_finite || !is_finite(now)) {
      result_.status = TrialStatus::nan;
      result_.farthest = std::numeric_limits<double>::infinity();
      return note_fall();
    }
    result_.farthest = std::max(result_.farthest, farthest_from_start(start_, now));
    note_standing(now);
    shaking_.see(now, result_.seconds);
    note_places(now);
    note_drift(now);
    watch_.see(now, result_.seconds);
    energy_.see(now);
    note_energy();
    if (!is_driven_) watch_.see_gain(-result_.energy_loss, result_.seconds);
    if (!(kinetic_energy(now) <= most_kinetic_energy(now))) result_.status = TrialStatus::diverged;
    if (is_last || result_.steps % options_.penetration_every == 0) {
      const List<Overlap> all = overlaps(now);
      note_overlap(deepest_of(all));
      watch_.see(all, now, result_.seconds);
    }
    result_.failures = watch_.failures();
    const bool late = options_.time_limit > 0 && result_.step_seconds > options_.time_limit;
    if (late && !is_last && result_.status == TrialStatus::ok) result_.status = TrialStatus::timeout;
  }

  void note_energy() {
    result_.energy_scale = energy_.scale() > 0 ? energy_.scale() : 1;
    most_gain_ = std::max(most_gain_, energy_.change());
    result_.energy_gain = most_gain_ / result_.energy_scale;
    result_.energy_loss = -energy_.change() / result_.energy_scale;
  }

  /// [J] More of it, and the run has diverged.
  double most_kinetic_energy(const Snapshot& now) const {
    const double substeps = result_.seconds / now.dt;
    return options_.most_energy * drive_.most_energy(result_.energy_scale, result_.seconds, substeps);
  }

  /// [m]
  double thinner(BodyId a, BodyId b) const {
    return std::min(thickness_of(start_.bodies[a]), thickness_of(start_.bodies[b]));
  }

  void note_drift(const Snapshot& now) {
    for (const SnapshotJoint& joint : now.joints) {
      if (!(joint.drift > result_.worst_drift)) continue;
      result_.worst_drift = joint.drift;
      result_.drift_worst = {.time = result_.seconds,
                             .a = joint.a,
                             .b = joint.b,
                             .joint = joint.name,
                             .thickness = thinner(joint.a, joint.b)};
    }
  }

  void note_overlap(const Overlap& overlap) {
    if (!(overlap.depth > result_.worst_penetration)) return;
    result_.worst_penetration = overlap.depth;
    result_.penetration_worst = {.time = result_.seconds,
                                 .a = overlap.a,
                                 .b = overlap.b,
                                 .joint = {},
                                 .thickness = thinner(overlap.a, overlap.b)};
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

  void note_standing(const Snapshot& now) {
    if (!options_.places.empty()) return;
    const double share = standing_.share(now, result_.seconds);
    result_.stand_share = std::max(result_.stand_share, share);
    if (share > 1) note_fall();
  }

  void note_step_times() {
    if (step_times_.empty()) return;
    const auto middle = step_times_.begin() + step_times_.size() / 2;
    std::nth_element(step_times_.begin(), middle, step_times_.end());
    result_.median_step = *middle;
    result_.slowest_step = *std::max_element(middle, step_times_.end());
  }

  void note_fall() {
    if (!result_.fell_at) result_.fell_at = result_.stands_until = result_.seconds;
  }

  Contestant& contestant_;
  const TrialOptions& options_;
  TrialResult& result_;
  Snapshot start_;
  EnergyAccount energy_;
  Drive drive_;
  FailureWatch watch_;
  Standing standing_;
  Shaking shaking_;
  List<double> step_times_ = {};  // [s]
  bool is_driven_ = false;
  double most_gain_ = 0;  // [J]
  double residual_sum_ = 0;
  int residuals_ = 0;
};

}  // namespace

std::string status_text(TrialStatus status) {
  static const List<std::string> words = {"ok", "diverged", "nan", "refused", "timeout"};
  return words[static_cast<int>(status)];
}

bool is_finite(const Snapshot& now) {
  return std::all_of(now.bodies.begin(), now.bodies.end(), [](const SnapshotBody& body) {
    return body.pose.position.allFinite() && std::isfinite(body.pose.angle) && body.velocity.allFinite();
  });
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
  const double before = options.clock();
  try {
    contestant = make_contestant(scene, setting);
  } catch (const std::logic_error& refusal) {
    result.status = TrialStatus::refused;
    result.reason = refusal.what();
    return result;
  }
  result.setup_seconds = options.clock() - before;
  const int steps = static_cast<int>(std::lround(options.seconds / setting.dt));
  Trial(*contestant, scene, options, result).run(steps, setting.dt);
  return result;
}

}  // namespace cairn
