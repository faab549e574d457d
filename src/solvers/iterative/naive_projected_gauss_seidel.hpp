// Floor 4. Projected Gauss-Seidel that recomputes every velocity for every lambda (paper 4.4): a comparison.
#pragma once

#include <cairn/solvers/row_order.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What section 4.4 warns of: after each new lambda the velocity of the whole system is computed anew,
/// v = v_1 + M^-1 J^T lambda dt (12), from all lambdas, although only two bodies have changed. The next row
/// then reads its error from v. There is no A, and nothing to recommend it but two things: it is (12) and
/// (28) word for word, and its velocities cannot drift away from its impulses, as no update builds on
/// another.
///
/// Guarantees: every lambda is inside its bounds after its row's update; the same numbers as
/// ProjectedGaussSeidel, row by row, but for rounding. Cost: 6m multiply-adds and n copies for each row, so
/// 6 m^2 a sweep: six times the dense solver's, with the memory of the sequential one (m + 3n numbers).
template <Scalar Real = double>
class NaiveProjectedGaussSeidel final : public Solver<Real> {
 public:
  /// At this many rows a sweep takes 1.5e8 multiply-adds.
  static constexpr int max_rows = 5000;

  /// @throws std::invalid_argument for settings out of range.
  explicit NaiveProjectedGaussSeidel(const SolverSettings& settings = {});

  std::string name() const override { return "naive PGS"; }
  /// @throws std::length_error for more than max_rows rows: before anything is changed.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  std::size_t memory() const override { return inverse_mass_.bytes() + velocity_.bytes(); }

 private:
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);
  void recompute_velocity(VelocityProblem<Real>& problem) const;

  SolverSettings settings_;
  RowSequence sequence_;
  Stopping<Real> stopping_;
  PerRow<Real> inverse_mass_;     // m, A_ii [1/kg]
  PerBody<Vec3<Real>> velocity_;  // n, v_1
};

}  // namespace cairn
