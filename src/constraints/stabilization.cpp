// Floor 3. Baumgarte stabilization, slack rows and restitution: one line each.
#include "constraints/stabilization.hpp"

namespace cairn {

namespace {

template <Scalar Real>
Real spec_velocity(const RowSpec<Real>& spec, const std::vector<Vec3<Real>>& velocity) {
  return spec.jacobian_a.dot(velocity[static_cast<std::size_t>(spec.a.index)]) +
         spec.jacobian_b.dot(velocity[static_cast<std::size_t>(spec.b.index)]);
}

}  // namespace

template <Scalar Real>
Real bias_velocity(const RowSpec<Real>& spec, const Stabilization& stabilization, Real dt,
                   const std::vector<Vec3<Real>>& velocity) {
  const Real beta = static_cast<Real>(stabilization.baumgarte);
  if (!spec.bounds.is_unilateral()) return -beta * spec.error / dt;

  const Real slop = static_cast<Real>(stabilization.slop);
  Real bias = -spec.error / dt;
  if (spec.error < 0) bias = beta * std::max(Real(0), -spec.error - slop) / dt;
  const bool meets = spec.error + dt * spec_velocity(spec, velocity) < 0;
  return spec.rebound > 0 && meets ? std::max(bias, spec.rebound) : bias;
}

template <Scalar Real>
ConstraintRow<Real> stabilized_row(const RowSpec<Real>& spec, const Stabilization& stabilization, Real dt,
                                   const std::vector<Vec3<Real>>& velocity, std::uint64_t source,
                                   int first_row) {
  Bounds<Real> bounds = spec.bounds;
  if (bounds.is_friction()) bounds.normal_row += first_row;
  return {.a = spec.a,
          .b = spec.b,
          .jacobian_a = spec.jacobian_a,
          .jacobian_b = spec.jacobian_b,
          .bias = bias_velocity(spec, stabilization, dt, velocity),
          .softness = 0,
          .bounds = bounds,
          .key = {.source = source, .part = spec.part}};
}

template float bias_velocity(const RowSpec<float>&, const Stabilization&, float,
                             const std::vector<Vec3<float>>&);
template double bias_velocity(const RowSpec<double>&, const Stabilization&, double,
                              const std::vector<Vec3<double>>&);
template long double bias_velocity(const RowSpec<long double>&, const Stabilization&, long double,
                                   const std::vector<Vec3<long double>>&);
template ConstraintRow<float> stabilized_row(const RowSpec<float>&, const Stabilization&, float,
                                             const std::vector<Vec3<float>>&, std::uint64_t, int);
template ConstraintRow<double> stabilized_row(const RowSpec<double>&, const Stabilization&, double,
                                              const std::vector<Vec3<double>>&, std::uint64_t, int);
template ConstraintRow<long double> stabilized_row(const RowSpec<long double>&, const Stabilization&,
                                                   long double, const std::vector<Vec3<long double>>&,
                                                   std::uint64_t, int);

}  // namespace cairn
