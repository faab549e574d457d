// Floor 3. Which contacts slide, and which stick.
#include <cmath>

#include <cairn/constraints/contact_jacobians.hpp>
#include <cairn/constraints/contact_rows.hpp>

namespace cairn {

template <Scalar Real>
bool slides(const Contact<Real>& contact, const VelocityProblem<Real>& problem, Real kinetic, Real load) {
  const Vec2<Real> point = middle_of(contact.manifold), tangent = -perpendicular(contact.manifold.normal);
  ConstraintRow<Real> row;
  row.a = contact.a;
  row.b = contact.b;
  row.jacobian_a = jacobian_of_a(contact, point, tangent);
  row.jacobian_b = jacobian_of_b(contact, point, tangent);
  const Real speed = row_velocity(problem, row) - surface_speed(contact, problem);
  return std::abs(speed) > kinetic * load * inverse_effective_mass(problem, row);
}

template <Scalar Real>
bool comes_sliding(const Contact<Real>& contact, const VelocityProblem<Real>& problem,
                   const PerBody<Vec3<Real>>& velocity) {
  const Vec2<Real> point = middle_of(contact.manifold), normal = contact.manifold.normal;
  const auto speed_along = [&](const Vec2<Real>& way) {
    return dot(jacobian_of_a(contact, point, way), velocity[contact.a]) +
           dot(jacobian_of_b(contact, point, way), velocity[contact.b]);
  };
  const Real sliding = speed_along(-perpendicular(normal)) - surface_speed(contact, problem);
  return std::abs(sliding) > contact.friction * std::abs(speed_along(normal));
}

template bool slides(const Contact<float>&, const VelocityProblem<float>&, float, float);
template bool slides(const Contact<double>&, const VelocityProblem<double>&, double, double);
template bool comes_sliding(const Contact<float>&, const VelocityProblem<float>&,
                            const PerBody<Vec3<float>>&);
template bool comes_sliding(const Contact<double>&, const VelocityProblem<double>&,
                            const PerBody<Vec3<double>>&);

}  // namespace cairn
