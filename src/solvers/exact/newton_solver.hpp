// Floor 4. Newton's method as a solver for steps.
#pragma once

#include <memory>

#include <cairn/solvers/exact/island_newton.hpp>
#include <cairn/solvers/islands.hpp>
#include <cairn/solvers/solver.hpp>

namespace cairn {

/// Solves all rows of an island at once, by Newton's method on sparse factors (island_newton.hpp), and each
/// island by itself. So what rests keeps its factors and its answer, however much moves beside it; what is
/// tiny is as exact as what is huge; and an island that takes many systems costs the others none.
///
/// Masses do not matter, nor does how far a load has to travel: what takes Gauss-Seidel 10^5 sweeps takes it
/// the same few systems. For fixed bounds that rows can keep, it converges; with friction nothing is
/// guaranteed.
///
/// The factors that it has kept change the way to the answer: a solver that has solved other problems may
/// differ from a new one within the tolerance, and by anything where neither has converged. The same sequence
/// of problems gives the same bits.
///
/// settings.iterations is the number of new systems of an island, at most; 0: the warm start is applied.
/// Order, relaxation, patience and time_budget mean nothing to it. Cost of a new system: for a stack or a
/// chain that of 5 sweeps of SequentialImpulse, for 50 x 50 bodies in a grid that of 40.
/// SolveReport::iterations counts those, and extra_sweeps counts sweeps, two of them for a step by kept
/// factors and three to look at the warm start, which is what they take; both in the mean over all rows, and
/// rounded up. SolveReport::residual is that of the worst island. Memory: that of the factors, and some 40
/// numbers a row. Once it has been as large, a solve in double without sweeps and a new order allocates
/// nothing. Observers see the end alone.
template <Scalar Real = double>
class NewtonSolver final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit NewtonSolver(const SolverSettings& settings = {});

  std::string name() const override { return "Newton"; }
  /// @throws std::length_error for more pairs of bodies in an island than BlockFactors holds.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  std::size_t memory() const override;

 private:
  /// One island, and what is kept of it.
  struct Part {
    BodyId lowest = {};                    // its lowest body: by that it is known in the next problem
    IslandProblem<Real> island = {};       // empty where it is the whole problem
    std::unique_ptr<IslandNewton> solver;  // of it
  };

  void split(const VelocityProblem<Real>& problem);
  SolveReport solve_part(Part& part, VelocityProblem<Real>& problem);
  static bool is_whole(const Part& part) { return part.island.rows.empty(); }

  SolverSettings settings_;
  Islands islands_;
  List<Part> parts_;          // by their lowest bodies
  List<Part> before_;         // while they are made; else none
  std::uint64_t solved_ = 0;  // the number of the problem that parts_ are of
};

}  // namespace cairn
