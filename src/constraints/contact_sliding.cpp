// Floor 3. Which contacts slide, and which stick.
#include <cmath>

#include <cairn/constraints/contact_jacobians.hpp>
#include <cairn/constraints/contact_rows.hpp>

namespace cairn {

namespace {

// Of a speed or an impulse: less is not told apart from nothing by solvers in the middle of their work.
template <Scalar Real>
constexpr Real slip_share = Real(1e-3);

}  // namespace

template <Scalar Real>
bool slides(const Contact<Real>& contact, const VelocityProblem<Real>& problem, Real friction, Real load) {
  const Real limit = contact.friction * load;
  if (std::abs(friction) < (1 - slip_share<Real>)*limit) return false;
  const Vec2<Real> point = middle_of(contact.manifold), tangent = -perpendicular(contact.manifold.normal);
  ConstraintRow<Real> row;
  row.a = contact.a;
  row.b = contact.b;
  row.jacobian_a = jacobian_of_a(contact, point, tangent);
  row.jacobian_b = jacobian_of_b(contact, point, tangent);
  Real speed = row_velocity(problem, row);
  if (!problem.surface_speed.empty())
    speed -= problem.surface_speed[contact.a] + problem.surface_speed[contact.b];
  return std::abs(speed) > slip_share<Real> * limit * inverse_effective_mass(problem, row);
}

template <Scalar Real>
bool comes_sliding(const Contact<Real>& contact, const VelocityProblem<Real>& problem,
                   const PerBody<Vec3<Real>>& velocity) {
  const Vec2<Real> point = middle_of(contact.manifold), normal = contact.manifold.normal;
  const auto speed_along = [&](const Vec2<Real>& way) {
    return dot(jacobian_of_a(contact, point, way), velocity[contact.a]) +
           dot(jacobian_of_b(contact, point, way), velocity[contact.b]);
  };
  Real sliding = speed_along(-perpendicular(normal));
  if (!problem.surface_speed.empty())
    sliding -= problem.surface_speed[contact.a] + problem.surface_speed[contact.b];
  return std::abs(sliding) > slip_share<Real> * std::abs(speed_along(normal));
}

template bool slides(const Contact<float>&, const VelocityProblem<float>&, float, float);
template bool slides(const Contact<double>&, const VelocityProblem<double>&, double, double);
template bool comes_sliding(const Contact<float>&, const VelocityProblem<float>&,
                            const PerBody<Vec3<float>>&);
template bool comes_sliding(const Contact<double>&, const VelocityProblem<double>&,
                            const PerBody<Vec3<double>>&);

}  // namespace cairn
