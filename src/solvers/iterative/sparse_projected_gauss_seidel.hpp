// Floor 4. Projected Gauss-Seidel over the entries of A that can be non-zero (paper 2.3 and 4.4).
#pragma once

#include <cairn/solvers/body_rows.hpp>
#include <cairn/solvers/row_order.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// ProjectedGaussSeidel with the zeros left out. A_ij can be non-zero only where rows i and j act on the same
/// body of non-zero inverse mass; for each row these entries stand one after the other, with their columns
/// beside them (compressed rows). The sweep is the same: each lambda takes the value that satisfies its own
/// row (28) and is clamped to its interval, and velocities are updated at the end (12). No dense matrix is
/// formed, not even on the way.
///
/// Guarantees: every lambda is inside its bounds after its row's update; the same numbers as the dense
/// solver, row by row, but for rounding: the zeros added nothing. Softness is one number on the diagonal.
/// Cost: one multiply-add for each stored entry and sweep; time to build and memory proportional to the
/// entries, whose number is coupled_pairs (non_zeros.hpp). That is linear in m as long as few rows meet on
/// each body, and m^2 when all meet on one.
template <Scalar Real = double>
class SparseProjectedGaussSeidel final : public Solver<Real> {
 public:
  /// Above this many pairs of rows on a body A could take 300 MB in double, the columns included.
  static constexpr std::ptrdiff_t max_pairs = 25'000'000;

  /// @throws std::invalid_argument for settings out of range.
  explicit SparseProjectedGaussSeidel(const SolverSettings& settings = {});

  std::string name() const override { return "sparse PGS"; }
  /// @throws std::length_error for more than max_pairs pairs: before A is allocated.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  std::size_t memory() const override;

 private:
  void build(const VelocityProblem<Real>& problem);
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);
  Real row_product(int i) const;
  void update_velocity(VelocityProblem<Real>& problem) const;

  SolverSettings settings_;
  RowSequence sequence_;
  Stopping<Real> stopping_;
  BodyRows body_rows_;
  List<std::ptrdiff_t> first_;    // m + 1: where a row begins in entry_ and column_
  List<Real> entry_;              // A_ij [1/kg], row after row
  List<int> column_;              // j, ascending inside a row
  PerRow<Real> diagonal_;         // m, A_ii once more, to divide by
  PerRow<Real> b_;                // m, (zeta - J v_1) / dt (15) [m/s^2]
  PerRow<Real> lambda_;           // m [N]
  PerBody<Vec3<Real>> velocity_;  // n, v_1
};

}  // namespace cairn
