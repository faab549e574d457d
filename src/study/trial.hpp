// Floor 9. One run of a scene under a setting: what it cost, and how good it was.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/measure/failure.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// How a run ended.
enum class TrialStatus {
  ok,        // all of its steps were done
  diverged,  // it had far more kinetic energy than anything in the scene explains: TrialOptions::most_energy
  nan,       // a pose or a velocity is no finite number, or would have been after a step
  refused,   // the engine cannot run the scene, or the solver its problem: TrialResult::reason says why
  timeout,   // its steps took longer than TrialOptions::time_limit
};

/// "ok", "diverged", "nan", "refused" or "timeout".
std::string status_text(TrialStatus status);

/// In which steps R_E is measured, which takes a second solve of each.
enum class ResidualMeasure { off, last_step, every_step };

/// Whether all poses and velocities are finite numbers.
bool is_finite(const Snapshot& now);

/// Seconds of processor time that this thread has used.
double thread_cpu_seconds();

struct TrialResult;

/// Where and when a run was worst.
struct TrialWorst {
  double time = 0;         // [s]
  BodyId a = {}, b = {};   // the bodies that overlapped, or that the joint joins
  std::string joint = {};  // Constraint::name(); none for an overlap
  double thickness = std::numeric_limits<double>::infinity();  // [m] thickness_of() the thinner of the two
};

struct TrialOptions {
  double seconds = 2;  // [s] to simulate, rounded to whole steps
  /// [m] The scene stands while every dynamic body's centre of mass is at most as far from its place: where
  /// it is after settle_seconds. Until then half its bounding radius is allowed (see Standing).
  double stand_distance = std::numeric_limits<double>::infinity();
  /// Where there are any, the scene stands if it ends with these bodies in their places, however they come
  /// there; stand_distance then means nothing.
  List<ExpectedPlace> places = {};
  double settle_seconds = 1;  // [s] but at most half of `seconds`; with 0 the places are those of the start
  /// Overlap is measured after every so many steps, and at the end. The other measures, taken after every
  /// step, cost O(bodies + joints); this one looks for pairs and collides them, as a step does.
  int penetration_every = 1;
  ResidualMeasure residual = ResidualMeasure::off;
  /// A run has diverged once its kinetic energy is so many times what the scale and what drives the scene
  /// (measure/energy_account.hpp) explain: its bodies are then a hundred times as fast. Infinite: never.
  double most_energy = 1e4;
  double time_limit = 0;  // [s] of the clock in all steps; 0: none
  /// Asked after every step: true ends the run there, for example because it can no longer do what is wanted.
  std::function<bool(const TrialResult&)> gives_up = {};
  std::function<void(const Snapshot&)> observer = {};  // sees the start, and then every step
  bool whole_impulses = false;                         // what it sees has the impulses of whole steps
  std::function<double()> clock = thread_cpu_seconds;  // [s]
};

/// The same for the same scene, setting and options, but for the seconds of the clock, and what a time_limit
/// or a solver's time budget makes of it.
struct TrialResult {
  TrialStatus status = TrialStatus::ok;
  std::string reason = {};                // of a refusal
  std::optional<BodyId> not_finite = {};  // for whose sake the last step was not done: StepReport::not_finite
  int steps = 0;                          // done
  double seconds = 0;                     // [s] simulated
  double worst_penetration = 0;           // [m] of any step that was measured
  double worst_drift = 0;                 // [m or rad] of any joint after any step
  TrialWorst penetration_worst = {};      // where worst_penetration is above 0
  TrialWorst drift_worst = {};            // where worst_drift is above 0
  List<Failure> failures = {};            // the first of each kind, whatever is expected of the scene
  /// [J] EnergyAccount::scale() (measure/energy_account.hpp); 1 J where it is 0.
  double energy_scale = 0;
  /// Of the scale: how far kinetic and potential energy rose above those of the start, without what events
  /// gave and took.
  double energy_gain = 0;
  int unfinished_steps = 0;        // in which a solve ended far from its answer: StepReport::unfinished
  double unfinished_residual = 0;  // the largest R_E of these
  double energy_loss = 0;          // of the scale: how far they are below it at the end; < 0: above it
  double farthest = 0;  // [m] that a dynamic body's centre of mass was from its start, infinite for nan
  List<double> place_distances = {};  // [m] how far each body of TrialOptions::places is from its place
  /// [s] After the first step where the scene did not stand; none: it did; 0: it ended out of place.
  std::optional<double> fell_at = {};
  double stands_until = 0;                    // [s] fell_at, or else all of `seconds`
  double stand_share = 0;                     // Standing::share(), the largest of all steps
  double jitter = 0;                          // [m/s] Shaking::speed() in the last second, or half of a
                                              // shorter run
  double thinnest = 0;                        // [m] thinnest_body() of the start
  double setup_seconds = 0;                   // [s] of the clock until the scene could step
  double step_seconds = 0;                    // [s] of the clock in steps; measuring is not in it
  double median_step = 0;                     // [s] of one step
  double slowest_step = 0;                    // [s]
  std::int64_t row_updates = 0;               // see Contestant::row_updates
  std::int64_t rows = 0;                      // of all substeps: see Contestant::rows
  std::optional<double> worst_residual = {};  // R_E, where it was asked for and can be had
  std::optional<double> mean_residual = {};
  std::uint64_t state_hash = 0;  // see Contestant::state_hash; 0 after a refusal before the first step

  /// The overlap or the gap, whichever is more, beside the thinner of its two bodies.
  double of_body() const {
    return std::max(worst_penetration / penetration_worst.thickness, worst_drift / drift_worst.thickness);
  }
  bool stands() const { return status == TrialStatus::ok && !fell_at; }
  /// Of the clock for each second simulated; 0 before any.
  double cost() const { return seconds > 0 ? step_seconds / seconds : 0; }
  /// [s] The median step, for so much of the clock as a sixtieth of a second of the scene takes of it.
  double frame() const { return steps > 0 ? median_step * steps / (60 * seconds) : 0; }
  /// [1/s] Row updates for each second simulated; 0 before any.
  double work() const { return seconds > 0 ? static_cast<double>(row_updates) / seconds : 0; }
};

/// Steps the scene, by the setting in place of its own settings, until its time is over or something goes
/// wrong. Only the steps are timed. Blow-ups and refusals by the engine are results, not exceptions.
/// @throws std::invalid_argument for a setting that check() refuses, and for options out of range.
TrialResult run_trial(const Scene& scene, const Setting& setting, const TrialOptions& options = {});

}  // namespace cairn
