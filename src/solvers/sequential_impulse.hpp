// Floor 4. Sequential impulses: section 3 of the paper.
#pragma once

#include "solvers/solver.hpp"

namespace cairn {

/// Algorithm 1. Visits one row after the other; computes the impulse that would satisfy that row alone (22),
/// adds it to what the row has given so far, clamps the sum, and gives the difference to the two bodies at
/// once. Builds no matrix. Effective masses are computed once, before the sweeps.
///
/// Guarantees: every impulse is inside its bounds after its row's update; only the row's two bodies change.
/// Its impulses are those of Gauss-Seidel on A lambda = b (paper 4.1, eq. (24)-(29)).
/// Cost: 12 multiply-adds a row and sweep (6 for j v, 6 for the update), memory linear in m: one effective
/// mass a row.
template <Scalar Real = double>
class SequentialImpulse final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit SequentialImpulse(const SolverSettings& settings = {});

  std::string name() const override { return "SI"; }
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;

 private:
  template <bool watched>
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* observer);

  SolverSettings settings_;
  std::vector<Real> effective_mass_;  // [kg] for each row, 1 / A_ii
};

}  // namespace cairn
