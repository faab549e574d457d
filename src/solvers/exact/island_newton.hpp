// Floor 4. Newton's method for one island: warm, in double, on sparse factors.
#pragma once

#include <algorithm>

#include <cairn/solvers/exact/interior_rows.hpp>
#include <cairn/solvers/exact/newton_steps.hpp>
#include <cairn/solvers/exact/slope_factors.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Solves all rows of a problem at once, by the proximal steps of newton.hpp: rows a little soft around the
/// impulses of the moment, each such problem by Newton's method, one sparse linear system after the other. It
/// differs from newton() in four things. It begins from the warm start, the softer the farther that is from
/// the answer (as regularized Newton methods do: D.-H. Li, M. Fukushima, L. Qi, N. Yamashita, Regularized
/// Newton methods for convex minimization problems with singular solutions, 2004), and softer yet where the
/// last such start was too stiff (K. Levenberg, 1944; D. W. Marquardt, 1963), so that what changes little
/// needs one system at most. Where one is not the answer, rows change sides, and it goes through the interior
/// of all bounds (interior_rows.hpp), where they are of that kind: after an impact, or where friction slides
/// at many points, steps of Newton's method stop at each kink. That way ends far inside the
/// bounds of all rows that need not be at theirs, so that what is left over moves no row across in the steps
/// that follow. Only where it fails do sweeps of accelerated PGS lead on. It keeps its factors in blocks
/// (block_factors.hpp) from solve to solve: an old system gives a step for a tenth of what a new one costs,
/// and is asked first, for as long as each step leaves less than a third of the error (slope_factors.hpp).
/// And it stops by the settings' tolerance, of which 1e-9 is enough for any scene, or where R_E falls no
/// further.
///
/// A warm start within a hundredth of the tolerance is the answer. Where it has to solve at all, it goes on
/// to that hundredth, if systems lead there without a failure: what is left over comes back in the next step,
/// and an answer that is just good enough makes that one solve again. So a tolerance above 1e-7 is taken for
/// 1e-7. Without a tolerance no way is tried twice once R_E is below 1e-9. What no impulse that the caller
/// can hold comes nearer to is an answer too. SolveReport::converged means the tolerance itself, as it was
/// asked for.
///
/// Impulses that hardly move a body, such as the pull along a straight chain, change little in a proximal
/// step, and alike in each. So where a step leaves most of R_E, it goes on along that step to the least error
/// of the rows that are held: reduced rank extrapolation of order one (M. Mesina, 1977; R. P. Eddy, 1979).
///
/// Where it has not converged it gives the impulses with the least R_E that it has seen, those of the warm
/// start among them. A problem with the number of the one before has its rows, scaled already. Where the
/// answer of before is one to the new problem as well, it stays, whatever the warm start.
class IslandNewton {
 public:
  /// With settings that are in range, for impulses whose type has this epsilon.
  IslandNewton(const SolverSettings& settings, double epsilon) : settings_(settings), epsilon_(epsilon) {}

  /// As Solver::solve; blocks and contacts are not looked at.
  /// @throws std::length_error for more pairs of bodies than BlockFactors holds: before anything is changed.
  SolveReport solve(VelocityProblem<double>& problem);
  /// As Solver::memory().
  std::size_t memory() const {
    const Eigen::Index numbers = center_.numbers() + map_.numbers() + steps_.numbers() + change_.size();
    return rows_.memory() + interior_.memory() + factors_.memory() + best_.impulse.bytes() +
           static_cast<std::size_t>(numbers) * sizeof(double);
  }

 private:
  /// The impulses with the least R_E so far.
  struct Best {
    PerRow<double> impulse;  // [N s]
    double residual = 0;
  };

  void answer(const VelocityProblem<double>& problem, bool again);
  void give_answer(VelocityProblem<double>& problem);
  void approach(const VelocityProblem<double>& problem);
  void sweep(const VelocityProblem<double>& problem, int sweeps);
  /// R_E at the centre.
  double residual() const;
  double goal() const;
  double first_softness() const;
  double enough() const;
  double rounding() const;
  double rounding_of_answer() const;
  void go_on();
  bool solve_softened(int most_systems);
  bool take_kept_step();
  bool take_new_step();
  void follow_interior();
  double take_interior_step();
  NewtonSteps<double>::Place at() { return {rows_, center_, map_}; }
  void note_center();
  void go_to(const PerRow<double>& impulse);
  bool last_is_answer();

  SolverSettings settings_;
  double epsilon_;
  ScaledRows<double> rows_;
  ProximalCenter<double> center_;
  ProximalMap<double> map_;
  NewtonSteps<double> steps_;
  InteriorRows interior_;
  SlopeFactors factors_;           // of the last system, in this solve or in an earlier one
  Vector<double> change_;          // a step of Newton's method
  VelocityProblem<double> swept_;  // a copy for sweeps
  Best best_;
  double caution_ = 1;        // how many times softer than by R_E the next start is
  std::uint64_t solved_ = 0;  // the number of the problem whose rows it has
  SolveReport done_;          // in this solve
};

}  // namespace cairn
