// Floor 4. J, M^-1, A and b (paper 2.1 and 2.2).
#include <cairn/solvers/system_matrix.hpp>

namespace cairn {

namespace {

/// J (6): row i holds jacobian_a and jacobian_b in the columns of its two bodies.
template <Scalar Real>
void fill_jacobian(const VelocityProblem<Real>& problem, Matrix<Real>& J) {
  J.setZero(problem.row_count(), 3 * problem.body_count());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      J.template block<1, 3>(i, 3 * body.index) += jacobian.transpose();
    });
  }
}

/// A = J M^-1 J^T. Column i is J times M^-1 j_i^T, which is zero but for the bodies of row i.
template <Scalar Real>
void fill_product(const VelocityProblem<Real>& problem, const Matrix<Real>& J, Matrix<Real>& A) {
  A.setZero(problem.row_count(), problem.row_count());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      const Vec3<Real>& inverse_mass = problem.inverse_mass[body];
      for (int k = 0; k < 3; ++k) A.col(i) += J.col(3 * body.index + k) * inverse_mass(k) * jacobian(k);
    });
    A(i, i) += row.softness;
  }
}

}  // namespace

template <Scalar Real>
void system_velocity(const VelocityProblem<Real>& problem, Vector<Real>& velocity) {
  velocity.resize(3 * problem.body_count());
  for (const BodyId body : problem.velocity.indices()) {
    velocity.template segment<3>(3 * body.index) = problem.velocity[body];
  }
}

template <Scalar Real>
void system_matrices(const VelocityProblem<Real>& problem, SystemMatrices<Real>& system) {
  fill_jacobian(problem, system.J);
  fill_product(problem, system.J, system.A);
  system.inverse_mass.resize(3 * problem.body_count());
  system.b.setZero(problem.row_count());
  for (const BodyId body : problem.velocity.indices()) {
    system.inverse_mass.template segment<3>(3 * body.index) = problem.inverse_mass[body];
    for (int k = 0; k < 3; ++k)
      system.b += system.J.col(3 * body.index + k) * problem.velocity[body](k);  // J v_1
  }
  for (int i = 0; i < problem.row_count(); ++i) {
    const Real zeta = problem.rows[i].bias;
    system.b(i) = (zeta - system.b(i)) / problem.dt;
  }
}

template <Scalar Real>
SystemMatrices<Real> system_matrices(const VelocityProblem<Real>& problem) {
  SystemMatrices<Real> system;
  system_matrices(problem, system);
  return system;
}

template void system_velocity(const VelocityProblem<float>&, Vector<float>&);
template SystemMatrices<float> system_matrices(const VelocityProblem<float>&);
template void system_matrices(const VelocityProblem<float>&, SystemMatrices<float>&);
template void system_velocity(const VelocityProblem<double>&, Vector<double>&);
template SystemMatrices<double> system_matrices(const VelocityProblem<double>&);
template void system_matrices(const VelocityProblem<double>&, SystemMatrices<double>&);
template void system_velocity(const VelocityProblem<long double>&, Vector<long double>&);
template SystemMatrices<long double> system_matrices(const VelocityProblem<long double>&);
template void system_matrices(const VelocityProblem<long double>&, SystemMatrices<long double>&);

}  // namespace cairn
