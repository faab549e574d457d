// Floor 3. How contacts push bodies back as these turn.
#include <cairn/constraints/contact_stiffness.hpp>

namespace cairn {

template <Scalar Real>
void add_contact_stiffness(const Contact<Real>& contact, Real radius_a, Real radius_b,
                           const RowForces<Real>& forces, PerBody<Vec3<Real>>& stiffness) {
  const Manifold<Real>& manifold = contact.manifold;
  const Vec2<Real>& normal = manifold.normal;
  Real mean = 0;  // [m] of the separations: the points lie half of it from the surface of the face
  for (int i = 0; i < manifold.count; ++i)
    mean += manifold.points[i].separation / static_cast<Real>(manifold.count);
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    const Real force = forces.of(normal_part(point.feature)), beyond = point.separation - mean / 2;
    const Vec2<Real> core_a = point.position - normal * (beyond + radius_a);
    const Vec2<Real> core_b = point.position + normal * (beyond + radius_b);
    const FeatureKind kind = feature_kind(point.feature);
    const Vec2<Real> arm_a = (kind == FeatureKind::face_of_a ? core_b : core_a) - contact.center_a;
    const Vec2<Real> arm_b = (kind == FeatureKind::face_of_b ? core_a : core_b) - contact.center_b;
    stiffness[contact.a].z() += (kind == FeatureKind::face_of_a ? force : -force) * normal.dot(arm_a);
    stiffness[contact.b].z() += (kind == FeatureKind::face_of_b ? -force : force) * normal.dot(arm_b);
  }
}

template void add_contact_stiffness(const Contact<float>&, float, float, const RowForces<float>&,
                                    PerBody<Vec3<float>>&);
template void add_contact_stiffness(const Contact<double>&, double, double, const RowForces<double>&,
                                    PerBody<Vec3<double>>&);

}  // namespace cairn
