// Floor 3. Baumgarte stabilization, slack rows, restitution, springs and motors: one line each.
#include "constraints/stabilization.hpp"

namespace cairn {

namespace {

template <Scalar Real>
Real spec_velocity(const RowSpec<Real>& spec, const std::vector<Vec3<Real>>& velocity) {
  Real jv = spec.jacobian_a.dot(velocity[static_cast<std::size_t>(spec.a.index)]) +
            spec.jacobian_b.dot(velocity[static_cast<std::size_t>(spec.b.index)]);
  for (int k = 0; k < spec.extra_count; ++k) {
    const RowTerm<Real>& term = spec.extra[static_cast<std::size_t>(k)];
    jv += term.jacobian.dot(velocity[static_cast<std::size_t>(term.body.index)]);
  }
  return jv;
}

}  // namespace

template <Scalar Real>
Real bias_velocity(const RowSpec<Real>& spec, const Stabilization& stabilization, Real dt,
                   const std::vector<Vec3<Real>>& velocity) {
  const auto return_speed = [&](Real error) {
    if (spec.softness) return error * return_rate(*spec.softness, dt);
    return static_cast<Real>(stabilization.baumgarte) * error / dt;
  };
  if (!spec.bounds.is_unilateral()) return spec.speed - return_speed(spec.error);

  const bool has_slop = spec.keeps_slop && !spec.softness;
  const Real slop = has_slop ? static_cast<Real>(stabilization.slop) : Real(0);
  Real bias = -spec.error / dt;
  if (spec.error < 0) bias = return_speed(std::max(Real(0), -spec.error - slop));
  const bool meets = spec.error + dt * spec_velocity(spec, velocity) < 0;
  return spec.rebound > 0 && meets ? std::max(bias, spec.rebound) : bias;
}

template <Scalar Real>
ConstraintRow<Real> stabilized_row(const RowSpec<Real>& spec, const Stabilization& stabilization,
                                   VelocityProblem<Real>& problem, std::uint64_t source, int first_row) {
  ConstraintRow<Real> row{.a = spec.a,
                          .b = spec.b,
                          .jacobian_a = spec.jacobian_a,
                          .jacobian_b = spec.jacobian_b,
                          .bias = bias_velocity(spec, stabilization, problem.dt, problem.velocity),
                          .softness = 0,
                          .bounds = spec.bounds,
                          .key = {.source = source, .part = spec.part},
                          .first_extra = static_cast<int>(problem.extra_terms.size()),
                          .extra_count = spec.extra_count};
  for (int k = 0; k < spec.extra_count; ++k) {
    problem.extra_terms.push_back(spec.extra[static_cast<std::size_t>(k)]);
  }
  if (row.bounds.is_friction()) row.bounds.normal_row += first_row;
  if (spec.max_force) row.bounds = Bounds<Real>::at_most(*spec.max_force * problem.dt);
  if (spec.softness) {
    // The row is still rigid here: this is j M^-1 j^T alone.
    const Real inverse_mass = inverse_effective_mass(problem, row);
    row.softness = row_softness(*spec.softness, inverse_mass, problem.dt);
  }
  return row;
}

template float bias_velocity(const RowSpec<float>&, const Stabilization&, float,
                             const std::vector<Vec3<float>>&);
template double bias_velocity(const RowSpec<double>&, const Stabilization&, double,
                              const std::vector<Vec3<double>>&);
template long double bias_velocity(const RowSpec<long double>&, const Stabilization&, long double,
                                   const std::vector<Vec3<long double>>&);
template ConstraintRow<float> stabilized_row(const RowSpec<float>&, const Stabilization&,
                                             VelocityProblem<float>&, std::uint64_t, int);
template ConstraintRow<double> stabilized_row(const RowSpec<double>&, const Stabilization&,
                                              VelocityProblem<double>&, std::uint64_t, int);
template ConstraintRow<long double> stabilized_row(const RowSpec<long double>&, const Stabilization&,
                                                   VelocityProblem<long double>&, std::uint64_t, int);

}  // namespace cairn
