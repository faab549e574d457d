// Floor 3. What rows of contacts and the law of sliding share: Jacobians at a point, and speeds of surfaces.
#pragma once

#include <cairn/constraints/row.hpp>

namespace cairn {

/// j of the first body for the relative velocity along `direction` of what the two have at a point.
template <Scalar Real>
Vec3<Real> jacobian_of_a(const Contact<Real>& contact, const Vec2<Real>& point, const Vec2<Real>& direction) {
  const Vec2<Real> arm = point - contact.center_a;
  return {-direction.x(), -direction.y(), -cross(arm, direction)};
}

/// That of the second body.
template <Scalar Real>
Vec3<Real> jacobian_of_b(const Contact<Real>& contact, const Vec2<Real>& point, const Vec2<Real>& direction) {
  const Vec2<Real> arm = point - contact.center_b;
  return {direction.x(), direction.y(), cross(arm, direction)};
}

/// [m/s] With which the surfaces of a contact run along each other. Those that face each other run along the
/// tangent in opposite directions.
template <Scalar Real>
Real surface_speed(const Contact<Real>& contact, const VelocityProblem<Real>& problem) {
  const PerBody<Real>& of = problem.surface_speed;
  return of.empty() ? Real(0) : of[contact.a] + of[contact.b];
}

/// [m] Of the points of a manifold.
template <Scalar Real>
Vec2<Real> middle_of(const Manifold<Real>& manifold) {
  if (manifold.count == 1) return manifold.points[0].position;
  return (manifold.points[0].position + manifold.points[1].position) / 2;
}

}  // namespace cairn
