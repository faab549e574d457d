// Floor 4. What every solver is: an answer to a VelocityProblem.
#pragma once

#include <cstdint>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <cairn/constraints/row.hpp>
#include <cairn/solvers/row_order.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// When to stop, for every iterative solver; and how to sweep, for those of the Gauss-Seidel kind.
struct SolverSettings {
  int iterations = 10;     // sweeps over all rows, at most
  double tolerance = 0;    // stop once the residual R_E (residual.hpp) is at most this; 0: never sooner
  double time_budget = 0;  // [s] no sweep begins later than this; 0: none. Its answer depends on the machine
  RowOrder order = RowOrder::as_written;  // of the rows in a sweep
  std::uint64_t seed = 1;                 // of RowOrder::shuffled
  double relaxation = 1;  // omega of SOR (D. M. Young, 1954): every corrective impulse is multiplied by it
  int patience = 0;  // so many sweeps at a standstill end it; cycles and plateaus do (stopping.hpp); 0: never
};

/// One row update, as an observer sees it.
template <Scalar Real>
struct RowUpdate {
  int sweep = 0;            // from 1
  int row = 0;              // from 0
  Real row_velocity = 0;    // j v before the update (paper (22))
  Real inverse_mass = 0;    // A_ii
  Real corrective = 0;      // [N s] before clamping: lambda_corrective of Algorithm 1, times dt and omega
  Real impulse_before = 0;  // [N s] accumulated
  Real impulse_after = 0;   // [N s] accumulated and clamped
};

/// Looks at a solver at work, and never changes anything. The problem passed in holds the current impulses;
/// its velocities are current too.
template <Scalar Real>
class SolveObserver {
 public:
  virtual ~SolveObserver() = default;
  /// Whether after_row is wanted: asked once for each solve.
  virtual bool watches_rows() const { return false; }
  /// Before the first sweep: `problem` as given, warm start not applied yet.
  virtual void before_solve(const VelocityProblem<Real>&) {}
  /// After a row update, where watches_rows().
  virtual void after_row(const RowUpdate<Real>&, const VelocityProblem<Real>&) {}
  /// After every sweep, counted from 1.
  virtual void after_sweep(int /*sweep*/, const VelocityProblem<Real>&) {}
};

/// Why a solver stopped.
enum class Stop {
  sweeps,     // all that were allowed are done
  tolerance,  // the residual asked for is reached
  stalled,    // impulses have not changed, but for rounding, for as many sweeps as patience says
  cycle,      // impulses repeat those of an earlier sweep exactly, and would do so for ever
  time,       // the time budget is used up
  plateau,    // rows contradict each other: impulses drift, and the residual stays where it is
};

/// How a solve ended.
struct SolveReport {
  int iterations = 0;         // sweeps done; linear systems solved, where those are what is counted
  int extra_sweeps = 0;       // beside such systems
  double largest_change = 0;  // [N s] the largest change of an impulse in the last sweep
  bool converged = false;     // the tolerance was asked for and reached
  Stop stop = Stop::sweeps;   // why it ended
  /// R_E of the answer (residual.hpp), where the solver has looked: one with a tolerance, and exact ones.
  std::optional<double> residual = {};

  /// Whether it is known to have ended far from the answer: short of its tolerance, and above 1e-6.
  bool unfinished() const { return !converged && residual && !(*residual <= 1e-6); }
};

/// Owns settings and scratch memory only: the problem carries everything else. The one exception is
/// NewtonSolver, which finds its answer sooner by what it has kept.
///
/// Threads: one solve at a time. Different solvers, copies too, have nothing in common, and may solve at the
/// same time. After a solve that throws it is as good as
/// new.
template <Scalar Real>
class Solver {
 public:
  virtual ~Solver() = default;
  /// What tables call it.
  virtual std::string name() const = 0;
  /// Changes problem.velocity and problem.impulse, from the impulses that it finds there.
  virtual SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) = 0;
  /// Whether VelocityProblem::contacts are all that it needs of contacts: most need rows.
  virtual bool takes_contacts() const { return false; }
  /// Bytes that the last solve kept beside the problem: the numbers stored, not what the allocator has set
  /// aside for more. 0 before the first solve, and for a solver that keeps nothing.
  virtual std::size_t memory() const { return 0; }
};

/// @throws std::invalid_argument unless iterations and patience are >= 0, tolerance and time_budget are
/// finite numbers >= 0, and relaxation is above 0 and below 2.
void check(const SolverSettings& settings, const std::string& solver);

/// @throws std::invalid_argument unless the problem's blocks follow each other and cover all rows.
template <Scalar Real>
void check_blocks(const VelocityProblem<Real>& problem, std::string_view solver);

}  // namespace cairn
