// Floor 4. After which sweep an iterative solver stops, and why.
#pragma once

#include <chrono>
#include <optional>

#include <cairn/solvers/cycle_search.hpp>
#include <cairn/solvers/rare_looks.hpp>
#include <cairn/solvers/solver.hpp>

namespace cairn {

/// After which sweeps R_E is computed, where there is a tolerance, and by whom.
enum class Looks {
  always,  // after every sweep
  rarely,  // as RareLooks says. The solver computes it, for it may have no rows, and its scale
};

/// How a solver wants its sweeps to be judged.
struct Judging {
  Looks looks = Looks::always;  // at R_E
  bool seeks_cycles = true;     // false where impulses are not all that the next sweep depends on
};

/// Judges every sweep of one solve by the solver's settings:
/// - tolerance: the residual R_E is at most this. O(m) a sweep; with Looks::rarely, a few times in a solve.
/// - stalled: for `patience` sweeps no impulse has changed by more than 16 roundings of the largest impulse.
///   Slow progress is no stall. O(m) a sweep.
/// - plateau, where there is a patience: rows contradict each other, so that no impulse satisfies them all.
///   Their impulses drift for ever, by as much in every sweep, and R_E stays where it is. Seen where both
///   have changed by less than 1e-4 of themselves since half of the sweeps, after sweeps 1024, 2048, 4096
///   ...; a problem that converges more slowly than that is called so too. O(m) for each look.
/// - cycle: all impulses are, to the last bit, what they were after an earlier sweep, and have moved by more
///   than that in between; SolveReport::largest_change tells how far. Bodies much faster than their impulses
///   can end in a small circle of roundings (CycleSearch). RowOrder::shuffled never repeats itself, so
///   nothing is sought there.
/// - time: the time budget, from begin() on, is used up. The only rule that depends on the machine.
/// Without tolerance, patience and time budget it costs nothing. Impulses that are not finite are never
/// called stalled or cyclic.
template <Scalar Real>
class Stopping {
 public:
  /// Before the warm start is applied: the scale of R_E needs the velocities as given.
  void begin(const SolverSettings& settings, const VelocityProblem<Real>& problem, Judging how = {});
  /// With Looks::rarely, before the first sweep: what R_E is measured by [sqrt(J)].
  void take_scale(Real scale) { scale_ = scale; }
  /// With Looks::rarely, after a sweep for which looks() says so: R_E, or something near it.
  void take_residual(Real energy) { energy_ = energy; }
  /// Whether what was taken is so near the tolerance that R_E itself may be there.
  bool is_near() const { return !(energy_ > Real(1.02) * Real(settings_.tolerance)); }
  /// What R_E is measured by [sqrt(J)].
  Real scale() const { return scale_; }

  /// Stop::sweeps: nothing speaks against another sweep. `largest_change` [N s] is that of any impulse in
  /// this sweep. problem.velocity must be current where needs_velocity() says so.
  Stop judge(const VelocityProblem<Real>& problem, int sweep, Real largest_change);

  /// Whether judge() will look at the velocities after this sweep.
  bool needs_velocity(int sweep) const {
    return settings_.tolerance > 0 || (settings_.patience > 0 && looks_for_plateau(sweep));
  }

  /// Whether judge() will look at impulses and velocities after this sweep, whose steps are of this size, as
  /// RareLooks. With Looks::rarely it must be asked before judge().
  bool looks(int sweep, Real size) {
    size_seen_.reset();
    if (rare_looks_.are_due(sweep, size)) size_seen_ = size;
    return (settings_.tolerance > 0 && size_seen_) || settings_.patience > 0;
  }

  /// Sweeps until the settings given to begin() say stop: "while not satisfied with global solution" of
  /// Algorithm 1, in every iterative solver. sweep(number, watcher) does one sweep, from number 1, and
  /// returns the largest change of an impulse [N s]; it leaves problem.velocity current where an observer or
  /// needs_velocity() asks for it. `watcher` is the observer, where it wants to see every row; or null.
  template <typename Sweep>
  SolveReport repeat(VelocityProblem<Real>& problem, SolveObserver<Real>* observer, const Sweep& sweep) {
    SolveObserver<Real>* const watcher = observer && observer->watches_rows() ? observer : nullptr;
    SolveReport report;
    while (report.iterations < settings_.iterations && report.stop == Stop::sweeps) {
      const int number = ++report.iterations;
      const Real change = sweep(number, watcher);
      report.largest_change = static_cast<double>(change);
      if (observer != nullptr) observer->after_sweep(number, problem);
      report.stop = judge(problem, number, change);
    }
    report.converged = report.stop == Stop::tolerance;
    const bool has_looked = how_.looks == Looks::always || size_seen_;
    if (settings_.tolerance > 0 && has_looked && report.iterations > 0)
      report.residual = static_cast<double>(energy_);
    return report;
  }

  /// The same for solvers that visit row after row: every sweep finds the order of its rows in `sequence`.
  template <typename Sweep>
  SolveReport repeat_rows(VelocityProblem<Real>& problem, SolveObserver<Real>* observer,
                          RowSequence& sequence, const Sweep& sweep) {
    return repeat(problem, observer, [&](int number, SolveObserver<Real>* watcher) {
      order_rows(problem, settings_.order, settings_.seed, number, sequence);
      return sweep(number, watcher);
    });
  }

  /// The same for sweeps that leave problem.velocity as it was: `update` makes it current, after the last
  /// sweep and for those who look at it before.
  template <typename Sweep, typename Update>
  SolveReport repeat_rows(VelocityProblem<Real>& problem, SolveObserver<Real>* observer,
                          RowSequence& sequence, const Sweep& sweep, const Update& update) {
    const SolveReport report =
        repeat_rows(problem, observer, sequence, [&](int number, SolveObserver<Real>* watcher) {
          const Real change = sweep(number, watcher);
          if (observer != nullptr || needs_velocity(number)) update();
          return change;
        });
    update();
    return report;
  }

 private:
  static constexpr int first_look = 512;  // half of the sweeps that a plateau must have lasted for at least

  static bool looks_for_plateau(int sweep) { return sweep >= first_look && (sweep & (sweep - 1)) == 0; }
  bool has_arrived(const VelocityProblem<Real>& problem, int sweep);
  bool is_plateau(const VelocityProblem<Real>& problem, int sweep, Real largest_change);

  SolverSettings settings_;
  std::chrono::steady_clock::time_point began_ = {};  // where there is a time budget
  Real scale_ = 0;                                    // of R_E
  Real energy_ = 0;                                   // R_E, when last looked at
  Judging how_ = {};                                  // it is to judge
  RareLooks<Real> rare_looks_;                        // where they are rare
  std::optional<Real> size_seen_ = {};                // [sqrt(J)] of the last sweep, where it looks after it
  int quiet_sweeps_ = 0;                              // in a row, without a change above rounding
  Real residual_before_ = 0;                          // R_E at half of the sweeps
  Real change_before_ = 0;                            // [N s] the largest change there
  CycleSearch<Real> cycles_;
};

}  // namespace cairn
