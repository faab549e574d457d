// Floor 4. Natural residuals, weighted by energy.
#include <cairn/solvers/residual.hpp>

#include <cmath>

namespace cairn {

namespace {

/// sqrt(v^T M v) over the bodies that can move.
template <Scalar Real>
Real kinetic_norm(const VelocityProblem<Real>& problem) {
  Real sum = 0;
  for (const BodyId body : problem.velocity.indices()) {
    for (int axis = 0; axis < 3; ++axis) {
      const Real inverse = problem.inverse_mass[body](axis);
      if (inverse > 0) sum += problem.velocity[body](axis) * problem.velocity[body](axis) / inverse;
    }
  }
  return std::sqrt(sum);
}

/// Keeps the larger one, and what is not a number once it was seen.
template <Scalar Real>
void raise(Real& worst, Real value) {
  if (value > worst || std::isnan(value)) worst = value;
}

/// w_i of a row with this impulse.
template <Scalar Real>
Real velocity_error(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, Real impulse) {
  return row_velocity(problem, row) + row.softness * impulse - row.bias;
}

/// e_i, where A_ii is known and above 0.
template <Scalar Real>
Real correction_at(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, Real impulse,
                   Real inverse) {
  return impulse -
         row.bounds.clamp(impulse - velocity_error(problem, row, impulse) / inverse, problem.impulse);
}

}  // namespace

template <Scalar Real>
Real least_scale(const VelocityProblem<Real>& problem) {
  return Real(1e-12) * kinetic_norm(problem);
}

template <Scalar Real>
Real starting_energy(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
  const Real inverse = inverse_effective_mass(problem, row);
  if (row.bounds.is_friction() || !(inverse > 0)) return 0;
  // Of rows with fixed bounds: no impulse is read.
  const Real wish = row.bounds.clamp((row.bias - row_velocity(problem, row)) / inverse, problem.impulse);
  return inverse * wish * wish;
}

template <Scalar Real>
Real residual_scale(const VelocityProblem<Real>& problem) {
  Real sum = 0;
  for (const ConstraintRow<Real>& row : problem.rows) sum += starting_energy(problem, row);
  return std::max(std::sqrt(sum), least_scale(problem));
}

template <Scalar Real>
Real correction_energy(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, Real impulse) {
  const Real inverse = inverse_effective_mass(problem, row);
  if (!(inverse > 0)) return 0;
  const Real e = correction_at(problem, row, impulse, inverse);
  return inverse * e * e;
}

template <Scalar Real>
Real row_velocity_error(const VelocityProblem<Real>& problem, int i) {
  return velocity_error(problem, problem.rows[i], problem.impulse[i]);
}

template <Scalar Real>
Real natural_correction(const VelocityProblem<Real>& problem, int i) {
  const ConstraintRow<Real>& row = problem.rows[i];
  const Real inverse = inverse_effective_mass(problem, row);
  return inverse > 0 ? correction_at(problem, row, problem.impulse[i], inverse) : Real(0);
}

template <Scalar Real>
Residual<Real> residual(const VelocityProblem<Real>& problem, Real scale) {
  Residual<Real> result;
  Real sum = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real inverse = inverse_effective_mass(problem, row);
    if (!(inverse > 0)) continue;
    const Real e = correction_at(problem, row, problem.impulse[i], inverse);
    const Real speed = std::abs(inverse * e);
    sum += inverse * e * e;
    Real& of_kind = row.bounds.is_friction()     ? result.velocity_friction
                    : row.bounds.is_unilateral() ? result.velocity_normal
                                                 : result.velocity_equality;
    raise(of_kind, speed);
    raise(result.velocity, speed);
  }
  result.energy = sum == 0 ? Real(0) : std::sqrt(sum) / scale;
  return result;
}

template float least_scale(const VelocityProblem<float>&);
template float starting_energy(const VelocityProblem<float>&, const ConstraintRow<float>&);
template float correction_energy(const VelocityProblem<float>&, const ConstraintRow<float>&, float);
template double least_scale(const VelocityProblem<double>&);
template double starting_energy(const VelocityProblem<double>&, const ConstraintRow<double>&);
template double correction_energy(const VelocityProblem<double>&, const ConstraintRow<double>&, double);
template long double least_scale(const VelocityProblem<long double>&);
template long double starting_energy(const VelocityProblem<long double>&, const ConstraintRow<long double>&);
template long double correction_energy(const VelocityProblem<long double>&, const ConstraintRow<long double>&,
                                       long double);
template float residual_scale(const VelocityProblem<float>&);
template double residual_scale(const VelocityProblem<double>&);
template long double residual_scale(const VelocityProblem<long double>&);
template float row_velocity_error(const VelocityProblem<float>&, int);
template double row_velocity_error(const VelocityProblem<double>&, int);
template long double row_velocity_error(const VelocityProblem<long double>&, int);
template float natural_correction(const VelocityProblem<float>&, int);
template double natural_correction(const VelocityProblem<double>&, int);
template long double natural_correction(const VelocityProblem<long double>&, int);
template Residual<float> residual(const VelocityProblem<float>&, float);
template Residual<double> residual(const VelocityProblem<double>&, double);
template Residual<long double> residual(const VelocityProblem<long double>&, long double);

}  // namespace cairn
