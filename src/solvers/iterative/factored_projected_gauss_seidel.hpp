// Floor 4. Projected Gauss-Seidel that never forms A: J and M^-1 J^T, two bodies a row.
#pragma once

#include <cairn/solvers/row_order.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Gauss-Seidel on A lambda = b as the paper's reference [1] does it: A = J (M^-1 J^T) is left in its two
/// factors. Of J (6) only the numbers of a row's two bodies are kept, all rows in one array, and the same of
/// M^-1 J^T beside them. The acceleration that the constraint forces cause, a = M^-1 J^T lambda, follows
/// every change of a lambda on two bodies, so that (A lambda)_i = j a + gamma lambda_i: row i of A times
/// lambda without A. Inside, lambda is a force [N].
///
/// SequentialImpulse reads v = v_1 + a dt in place of a, and multiplies by M^-1 in every update: the same
/// numbers, row by row, but for rounding.
/// Guarantees: every lambda is inside its bounds after its row's update. Cost: 12 multiply-adds a row and
/// sweep (6 for j a, 6 for the update); memory linear in m and n.
/// Source: E. Catto, Iterative Dynamics with Temporal Coherence (2005).
template <Scalar Real = double>
class FactoredProjectedGaussSeidel final : public Solver<Real> {
 public:
  /// @throws std::invalid_argument for settings out of range.
  explicit FactoredProjectedGaussSeidel(const SolverSettings& settings = {});

  std::string name() const override { return "factored PGS"; }
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  std::size_t memory() const override;

 private:
  /// A row of J, the column of M^-1 J^T that belongs to it, and what else one update reads.
  struct FactoredRow {
    BodyId body_a = {};
    BodyId body_b = {};
    int first_extra = 0;  // its terms of further bodies, in the problem's extra_terms
    int extra_count = 0;
    Vec3<Real> jacobian_a = Vec3<Real>::Zero();
    Vec3<Real> jacobian_b = Vec3<Real>::Zero();
    Vec3<Real> response_a = Vec3<Real>::Zero();  // M^-1 j^T
    Vec3<Real> response_b = Vec3<Real>::Zero();
    Real softness = 0;        // gamma [1/kg]
    Real effective_mass = 0;  // [kg] 1 / A_ii; 0 for two immovable bodies
    Real b = 0;               // (zeta - j v_1) / dt (15) [m/s^2]
    Real lambda = 0;          // [N]
  };

  void build(const VelocityProblem<Real>& problem);
  void accelerate(const VelocityProblem<Real>& problem, int i, Real lambda);
  Real sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);
  void update_velocity(VelocityProblem<Real>& problem) const;

  SolverSettings settings_;
  RowSequence sequence_;
  Stopping<Real> stopping_;
  List<FactoredRow> rows_;            // m
  PerBody<Vec3<Real>> acceleration_;  // n, a [m/s^2, m/s^2, rad/s^2]
  PerBody<Vec3<Real>> velocity_;      // n, v_1
};

}  // namespace cairn
