// Floor 4. The energy of impulses, row by row.
#include "solvers/impulse_energy.hpp"

namespace cairn {

template <Scalar Real>
Real impulse_energy(const VelocityProblem<Real>& problem, std::vector<Vec3<Real>>& scratch) {
  scratch = problem.velocity;
  const auto push = [&](BodyId id, const Vec3<Real>& jacobian, Real impulse) {
    const auto body = static_cast<std::size_t>(id.index);
    scratch[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * impulse;
  };
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    for_each_term(problem, problem.rows[i],
                  [&](BodyId body, const Vec3<Real>& jacobian) { push(body, jacobian, problem.impulse[i]); });
  }
  // A impulse = J (v with them - v), so that both terms together take the mean of both velocities.
  Real energy = 0;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real mean = (row_velocity(problem, row) + row_velocity(problem, row, scratch)) / 2;
    energy += problem.impulse[i] * (mean - row.bias + row.softness * problem.impulse[i] / 2);
  }
  return energy;
}

template float impulse_energy(const VelocityProblem<float>&, std::vector<Vec3<float>>&);
template double impulse_energy(const VelocityProblem<double>&, std::vector<Vec3<double>>&);
template long double impulse_energy(const VelocityProblem<long double>&, std::vector<Vec3<long double>>&);

}  // namespace cairn
