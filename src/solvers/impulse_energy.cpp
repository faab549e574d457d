// Floor 4. The energy of impulses, row by row.
#include "solvers/impulse_energy.hpp"

#include <algorithm>
#include <cmath>

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

namespace {

// What leverage is taken for granted.
constexpr double most_leverage = 100;

/// Whether the impulse of a row comes from a force that it has by itself: a spring, a motor.
template <Scalar Real>
bool pushes_by_itself(const ConstraintRow<Real>& row) {
  return row.softness > 0 || (std::isfinite(row.bounds.lower) && std::isfinite(row.bounds.upper));
}

}  // namespace

template <Scalar Real>
void limit_impulses(VelocityProblem<Real>& problem) {
  Real largest = 0;
  for (const Real impulse : problem.impulse) largest = std::max(largest, std::abs(impulse));
  const Real leverage = static_cast<Real>(most_leverage);
  Real momentum = 0;
  for (std::size_t i = 0; i < problem.velocity.size(); ++i) {
    const Real inverse_mass = problem.inverse_mass[i].x();
    if (inverse_mass > 0) momentum += problem.velocity[i].template head<2>().norm() / inverse_mass;
  }
  if (!(largest > leverage * momentum)) return;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    momentum += std::abs(row.bias) * effective_mass(problem, row);
    if (pushes_by_itself(row)) momentum += std::abs(problem.impulse[i]);
  }
  const Real limit = leverage * momentum;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    if (!pushes_by_itself(problem.rows[i]))
      problem.impulse[i] = std::clamp(problem.impulse[i], -limit, limit);
  }
}

template void limit_impulses(VelocityProblem<float>&);
template void limit_impulses(VelocityProblem<double>&);
template void limit_impulses(VelocityProblem<long double>&);

template float impulse_energy(const VelocityProblem<float>&, std::vector<Vec3<float>>&);
template double impulse_energy(const VelocityProblem<double>&, std::vector<Vec3<double>>&);
template long double impulse_energy(const VelocityProblem<long double>&, std::vector<Vec3<long double>>&);

}  // namespace cairn
