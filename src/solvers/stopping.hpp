// Floor 4. After which sweep an iterative solver stops, and why.
#pragma once

#include <vector>

#include "solvers/solver.hpp"

namespace cairn {

/// Judges every sweep of one solve by the solver's settings:
/// - tolerance: the residual R_E is at most this. O(m) a sweep.
/// - stalled: for `patience` sweeps no impulse has changed by more than 16 roundings of the largest impulse.
///   Slow progress is no stall, nor are redundant rows that no impulse can satisfy: their impulses drift for
///   ever, and only the number of sweeps ends that. O(m) a sweep.
/// - cycle: all impulses are, to the last bit, what they were after an earlier sweep, and have moved by more
///   than that in between; SolveReport::largest_change tells how far. Bodies much faster than their impulses
///   can end in a small circle of roundings. One remembered state is compared, renewed after sweeps 1, 2, 4,
///   8 ...: it finds a cycle of any length in memory for one (R. P. Brent, 1980). RowOrder::shuffled never
///   repeats itself, so nothing is sought there.
/// Without tolerance and patience it costs nothing. Impulses that are not finite are never called stalled or
/// cyclic.
template <Scalar Real>
class Stopping {
 public:
  /// Before the warm start is applied: the scale of R_E needs the velocities as given.
  void begin(const SolverSettings& settings, const VelocityProblem<Real>& problem);

  /// Stop::sweeps: nothing speaks against another sweep. `largest_change` [N s] is that of any impulse in
  /// this sweep. problem.velocity must be current where a tolerance is asked for.
  Stop judge(const VelocityProblem<Real>& problem, int sweep, Real largest_change);

  /// Sweeps until the settings given to begin() say stop: "while not satisfied with global solution" of
  /// Algorithm 1, in every iterative solver. sweep(number), from 1, does one sweep and returns the largest
  /// change of an impulse [N s]; it leaves problem.velocity current where an observer or a tolerance looks.
  template <typename Sweep>
  SolveReport repeat(VelocityProblem<Real>& problem, SolveObserver<Real>* observer, const Sweep& sweep) {
    SolveReport report;
    while (report.iterations < settings_.iterations && report.stop == Stop::sweeps) {
      const int number = ++report.iterations;
      const Real change = sweep(number);
      report.largest_change = static_cast<double>(change);
      if (observer != nullptr) observer->after_sweep(number, problem);
      report.stop = judge(problem, number, change);
    }
    report.converged = report.stop == Stop::tolerance;
    return report;
  }

 private:
  bool repeats(const VelocityProblem<Real>& problem, int sweep);

  SolverSettings settings_;
  Real scale_ = 0;                // of R_E
  int quiet_sweeps_ = 0;          // in a row, without a change above rounding
  bool moved_ = false;            // above rounding, since remembered_
  int remembered_sweep_ = 0;      // a power of two
  std::vector<Real> remembered_;  // [N s] impulses after that sweep
};

}  // namespace cairn
