// Floor 4. J, M^-1, A and b (paper 2.1 and 2.2).
#include "solvers/system_matrix.hpp"

namespace cairn {

template <Scalar Real>
Vector<Real> system_velocity(const VelocityProblem<Real>& problem) {
  Vector<Real> v(3 * problem.body_count());
  for (int body = 0; body < problem.body_count(); ++body) {
    v.template segment<3>(3 * body) = problem.velocity[static_cast<std::size_t>(body)];
  }
  return v;
}

template <Scalar Real>
Matrix<Real> system_jacobian(const VelocityProblem<Real>& problem) {
  Matrix<Real> J = Matrix<Real>::Zero(problem.row_count(), 3 * problem.body_count());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[static_cast<std::size_t>(i)];
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      J.template block<1, 3>(i, 3 * body.index) += jacobian.transpose();
    });
  }
  return J;
}

template <Scalar Real>
SystemMatrices<Real> system_matrices(const VelocityProblem<Real>& problem) {
  SystemMatrices<Real> system;
  system.J = system_jacobian(problem);
  system.inverse_mass.resize(3 * problem.body_count());
  for (int body = 0; body < problem.body_count(); ++body) {
    system.inverse_mass.template segment<3>(3 * body) = problem.inverse_mass[static_cast<std::size_t>(body)];
  }
  system.A = system.J * system.inverse_mass.asDiagonal() * system.J.transpose();

  Vector<Real> zeta(problem.row_count());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[static_cast<std::size_t>(i)];
    zeta(i) = row.bias;
    system.A(i, i) += row.softness;
  }
  system.b = (zeta - system.J * system_velocity(problem)) / problem.dt;
  return system;
}

template Vector<float> system_velocity(const VelocityProblem<float>&);
template Vector<double> system_velocity(const VelocityProblem<double>&);
template Vector<long double> system_velocity(const VelocityProblem<long double>&);
template Matrix<float> system_jacobian(const VelocityProblem<float>&);
template Matrix<double> system_jacobian(const VelocityProblem<double>&);
template Matrix<long double> system_jacobian(const VelocityProblem<long double>&);
template SystemMatrices<float> system_matrices(const VelocityProblem<float>&);
template SystemMatrices<double> system_matrices(const VelocityProblem<double>&);
template SystemMatrices<long double> system_matrices(const VelocityProblem<long double>&);

}  // namespace cairn
