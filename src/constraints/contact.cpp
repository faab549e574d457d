// Floor 3. The rows of one manifold.
#include "constraints/contact.hpp"

namespace cairn {

namespace {

/// The Jacobian of the relative velocity of two material points along `direction`.
template <Scalar Real>
RowSpec<Real> relative_velocity_row(BodyId a, BodyId b, const Vec2<Real>& r_a, const Vec2<Real>& r_b,
                                    const Vec2<Real>& direction) {
  RowSpec<Real> row;
  row.a = a;
  row.b = b;
  row.jacobian_a = {-direction.x(), -direction.y(), -cross(r_a, direction)};
  row.jacobian_b = {direction.x(), direction.y(), cross(r_b, direction)};
  return row;
}

}  // namespace

template <Scalar Real>
void append_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                         const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                         const PerBody<Vec3<Real>>& velocity, RowSpecs<Real>& rows) {
  const Vec2<Real> tangent = -perpendicular(manifold.normal);
  const auto friction_row = [&](const Vec2<Real>& position) {
    return relative_velocity_row(a, b, Vec2<Real>(position - poses[a].position),
                                 Vec2<Real>(position - poses[b].position), tangent);
  };
  const bool has_friction = material.friction > 0;
  const bool is_shared = material.friction_rows == FrictionRows::per_manifold && manifold.count == 2;
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    const Vec2<Real> r_a = point.position - poses[a].position;
    const Vec2<Real> r_b = point.position - poses[b].position;

    RowSpec<Real> normal = relative_velocity_row(a, b, r_a, r_b, manifold.normal);
    normal.error = point.separation;
    normal.bounds = Bounds<Real>::unilateral();
    normal.part = normal_part(point.feature);
    normal.slop_limit = material.slop_limit;
    normal.gravity = material.gravity;
    const Real approach = -normal.jacobian_a.dot(velocity[a]) - normal.jacobian_b.dot(velocity[b]);
    if (approach > material.restitution_threshold) normal.rebound = material.restitution * approach;
    const int normal_row = rows.size();
    rows.push_back(normal);

    if (!has_friction || is_shared) continue;
    RowSpec<Real> friction = friction_row(point.position);
    friction.bounds = Bounds<Real>::coulomb(material.friction, normal_row);
    friction.part = friction_part(point.feature);
    rows.push_back(friction);
  }
  if (has_friction && is_shared) {
    const auto& points = manifold.points;
    RowSpec<Real> friction = friction_row((points[0].position + points[1].position) / 2);
    const int normals_end = rows.size();
    friction.bounds = Bounds<Real>::coulomb(material.friction, normals_end - 2, normals_end - 1);
    friction.part = friction_part(points[0].feature);
    rows.push_back(friction);
  }
}

template void append_contact_rows(const Manifold<float>&, BodyId, BodyId, const ContactMaterial<float>&,
                                  const PerBody<Pose<float>>&, const PerBody<Vec3<float>>&, RowSpecs<float>&);
template void append_contact_rows(const Manifold<double>&, BodyId, BodyId, const ContactMaterial<double>&,
                                  const PerBody<Pose<double>>&, const PerBody<Vec3<double>>&,
                                  RowSpecs<double>&);
template void append_contact_rows(const Manifold<long double>&, BodyId, BodyId,
                                  const ContactMaterial<long double>&, const PerBody<Pose<long double>>&,
                                  const PerBody<Vec3<long double>>&, RowSpecs<long double>&);

}  // namespace cairn
