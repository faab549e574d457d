// Floor 4. Projected Gauss-Seidel over system matrices: section 2 of the paper, as written.
#pragma once

#include <cairn/solvers/row_order.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/solvers/system_matrix.hpp>

namespace cairn {

/// Builds J, M^-1, A and b (15) for the whole system, then sweeps A lambda = b row by row: each lambda takes
/// the value that satisfies its own row (28) and is clamped to its interval. Velocities are updated once, at
/// the end (12). Inside, lambda is a force [N] as in the paper; the problem's impulses are lambda times dt.
/// A relaxation other than 1 makes it SOR.
///
/// Guarantees: every lambda is inside its bounds after its row's update; the same numbers as
/// SequentialImpulse, row by row, but for rounding. Cost: m multiply-adds a row and sweep, and m^2 + 3nm
/// numbers of memory: for small scenes and for teaching.
template <Scalar Real = double>
class ProjectedGaussSeidel final : public Solver<Real> {
 public:
  /// Above this many rows A alone would take 200 MB in double.
  static constexpr int max_rows = 5000;

  /// @throws std::invalid_argument for settings out of range.
  explicit ProjectedGaussSeidel(const SolverSettings& settings = {});

  std::string name() const override { return "PGS"; }
  /// @throws std::length_error for more than max_rows rows: before anything is allocated.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// m^2 + 3nm + 6n + 2m numbers: A, J, M^-1 and v_1, b and lambda.
  std::size_t memory() const override;

 private:
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);
  void update_velocity(VelocityProblem<Real>& problem) const;

  SolverSettings settings_;
  SystemMatrices<Real> system_;
  Vector<Real> lambda_;    // [N]
  Vector<Real> velocity_;  // v_1, 3n
  RowSequence sequence_;
  Stopping<Real> stopping_;
};

}  // namespace cairn
