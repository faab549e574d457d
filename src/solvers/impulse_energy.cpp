// Floor 4. The energy of impulses, row by row.
#include "solvers/impulse_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

namespace {

/// M^-1 J^T p.
template <Scalar Real>
void velocities_of_impulses(const VelocityProblem<Real>& problem, PerBody<Vec3<Real>>& velocity) {
  velocity.assign(problem.velocity.size(), Vec3<Real>::Zero());
  for (int i = 0; i < problem.row_count(); ++i) {
    for_each_term(problem, problem.rows[i], [&](BodyId body, const Vec3<Real>& jacobian) {
      velocity[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * problem.impulse[i];
    });
  }
}

/// D along the impulses, at all of them.
template <Scalar Real>
struct EnergySlope {
  Real slope = 0;      // [J] D'(1)
  Real curvature = 0;  // [J] D''

  void add(Real impulse, Real lack, Real own) {
    slope += impulse * lack;
    curvature += impulse * own;
  }
  /// Written so that a NaN leaves things as they are: the step will report it.
  Real share() const {
    if (!(slope > 0) || !(curvature > 0)) return 1;
    return std::max(Real(0), 1 - slope / curvature);
  }
};

/// Whether the energy of any impulse is a number: the squares of smaller ones are 0, or slow to compute with.
template <Scalar Real>
bool have_energy(const PerRow<Real>& impulses) {
  const Real least = std::sqrt(std::numeric_limits<Real>::min());
  return std::any_of(impulses.begin(), impulses.end(), [least](Real p) { return !(std::abs(p) < least); });
}

template <Scalar Real>
void scale_impulses(VelocityProblem<Real>& problem, Real share) {
  for (Real& impulse : problem.impulse) impulse *= share;
}

}  // namespace

template <Scalar Real>
Real limit_warm_start(VelocityProblem<Real>& problem, PerBody<Vec3<Real>>& scratch) {
  if (!have_energy(problem.impulse)) return 1;
  velocities_of_impulses(problem, scratch);
  EnergySlope<Real> energy;
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real impulse = problem.impulse[i];
    const Real own = row_velocity(problem, row, scratch) + row.softness * impulse;
    const bool may_push_out = row.bounds.is_unilateral() && row.softness == 0;  // a spring gives in as well
    const Real bias = may_push_out ? std::min(row.bias, Real(0)) : row.bias;
    energy.add(impulse, row_velocity(problem, row) + own - bias, own);
  }
  const Real share = energy.share();
  if (share < 1) scale_impulses(problem, share);
  return share;
}

template <Scalar Real>
Real limit_solved(VelocityProblem<Real>& problem, PerBody<Vec3<Real>>& scratch) {
  if (!have_energy(problem.impulse)) return 1;
  velocities_of_impulses(problem, scratch);
  EnergySlope<Real> energy;
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real impulse = problem.impulse[i], give = row.softness * impulse;
    energy.add(impulse, row_velocity(problem, row) + give - row.bias,
               row_velocity(problem, row, scratch) + give);
  }
  const Real share = energy.share();
  if (!(share < 1)) return share;
  scale_impulses(problem, share);
  for (const BodyId body : scratch.indices()) problem.velocity[body] -= (1 - share) * scratch[body];
  return share;
}

namespace {

/// Whether the impulse of a row comes from a force that it has by itself: a spring, a motor.
template <Scalar Real>
bool pushes_by_itself(const ConstraintRow<Real>& row) {
  return row.softness > 0 || (std::isfinite(row.bounds.lower) && std::isfinite(row.bounds.upper));
}

/// The sum of m |v| [N s].
template <Scalar Real>
Real moving_momentum(const VelocityProblem<Real>& problem) {
  Real momentum = 0;
  for (const BodyId body : problem.velocity.indices()) {
    const Real inverse_mass = problem.inverse_mass[body].x();
    if (inverse_mass > 0) momentum += problem.velocity[body].template head<2>().norm() / inverse_mass;
  }
  return momentum;
}

}  // namespace

template <Scalar Real>
Real impulse_there_is(const VelocityProblem<Real>& problem) {
  Real sum = moving_momentum(problem);
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    sum += std::abs(row.bias) * effective_mass(problem, row);
    if (pushes_by_itself(row)) sum += std::abs(problem.impulse[i]);
  }
  return sum;
}

template <Scalar Real>
void limit_impulses(VelocityProblem<Real>& problem) {
  Real largest = 0;
  for (const Real impulse : problem.impulse) largest = std::max(largest, std::abs(impulse));
  const Real leverage = static_cast<Real>(most_leverage);
  if (!(largest > leverage * moving_momentum(problem))) return;
  const Real limit = leverage * impulse_there_is(problem);
  for (int i = 0; i < problem.row_count(); ++i) {
    if (!pushes_by_itself(problem.rows[i]))
      problem.impulse[i] = std::clamp(problem.impulse[i], -limit, limit);
  }
}

template float impulse_there_is(const VelocityProblem<float>&);
template double impulse_there_is(const VelocityProblem<double>&);
template long double impulse_there_is(const VelocityProblem<long double>&);
template void limit_impulses(VelocityProblem<float>&);
template void limit_impulses(VelocityProblem<double>&);
template void limit_impulses(VelocityProblem<long double>&);

template float limit_warm_start(VelocityProblem<float>&, PerBody<Vec3<float>>&);
template double limit_warm_start(VelocityProblem<double>&, PerBody<Vec3<double>>&);
template long double limit_warm_start(VelocityProblem<long double>&, PerBody<Vec3<long double>>&);
template float limit_solved(VelocityProblem<float>&, PerBody<Vec3<float>>&);
template double limit_solved(VelocityProblem<double>&, PerBody<Vec3<double>>&);
template long double limit_solved(VelocityProblem<long double>&, PerBody<Vec3<long double>>&);

}  // namespace cairn
