// Floor 3. The rows of one manifold.
#include "constraints/contact.hpp"

namespace cairn {

namespace {

/// Where the rows of one contact go: over old ones where there are any, so every member is set.
template <Scalar Real>
struct ContactRows {
  BodyId a, b;
  Vec2<Real> center_a, center_b;  // [m] of mass
  const ContactMaterial<Real>& material;
  const RowRule<Real>& rule;
  std::uint64_t source;
  VelocityProblem<Real>& problem;
  int& next;
  List<RelaxedRow<Real>>* relaxed;

  /// The Jacobian is that of the relative velocity along `direction` of what the two have at a point.
  ConstraintRow<Real>& add(const Vec2<Real>& point, const Vec2<Real>& direction, std::uint64_t part) {
    if (next == problem.row_count()) problem.rows.emplace_back();
    ConstraintRow<Real>& row = problem.rows[next++];
    const Vec2<Real> r_a = point - center_a, r_b = point - center_b;
    row.a = a;
    row.b = b;
    row.jacobian_a = {-direction.x(), -direction.y(), -cross(r_a, direction)};
    row.jacobian_b = {direction.x(), direction.y(), cross(r_b, direction)};
    row.bias = row.softness = 0;
    row.key = {.source = source, .part = part};
    row.first_extra = problem.extra_terms.size();
    row.extra_count = 0;
    return row;
  }
  /// The number of the row.
  int add_normal(const ManifoldPoint<Real>& point, const Vec2<Real>& normal, const Vec3<Real>& velocity_a,
                 const Vec3<Real>& velocity_b) {
    ConstraintRow<Real>& row = add(point.position, normal, normal_part(point.feature));
    Real rebound = 0;
    if (material.restitution > 0) {
      const Real approach = -row.jacobian_a.dot(velocity_a) - row.jacobian_b.dot(velocity_b);
      if (approach > material.restitution_threshold) rebound = material.restitution * approach;
    }
    row.bounds = Bounds<Real>::unilateral();
    const RelaxedRow<Real> second =
        stabilize_contact({point.separation, rebound, material.slop_limit}, rule, problem, row);
    if (relaxed) relaxed->push_back(second);
    return next - 1;
  }
  void add_friction(const Vec2<Real>& point, const Vec2<Real>& tangent, std::uint32_t feature, int normal_row,
                    int second) {
    add(point, tangent, friction_part(feature)).bounds =
        rule.only_corrects ? Bounds<Real>::at_most(0)
                           : Bounds<Real>::coulomb(material.friction, normal_row, second);
    if (relaxed) relaxed->push_back({});
  }
};

}  // namespace

template <Scalar Real>
void write_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                        const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                        const PerBody<Vec3<Real>>& velocity, const RowRule<Real>& rule, std::uint64_t source,
                        VelocityProblem<Real>& problem, int& next, List<RelaxedRow<Real>>* relaxed) {
  if (problem.inverse_mass[a].isZero(0) && problem.inverse_mass[b].isZero(0)) return;
  ContactRows<Real> rows{a,    b,      poses[a].position, poses[b].position, material, rule, source, problem,
                         next, relaxed};
  const Vec2<Real> tangent = -perpendicular(manifold.normal);
  const bool has_friction = material.friction > 0;
  const bool is_shared = material.friction_rows == FrictionRows::per_manifold && manifold.count == 2;
  int normal_rows[2] = {Bounds<Real>::none, Bounds<Real>::none};
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    normal_rows[i] = rows.add_normal(point, manifold.normal, velocity[a], velocity[b]);
    if (has_friction && !is_shared)
      rows.add_friction(point.position, tangent, point.feature, normal_rows[i], Bounds<Real>::none);
  }
  if (!has_friction || !is_shared) return;
  const auto& points = manifold.points;
  const Vec2<Real> middle = (points[0].position + points[1].position) / 2;
  rows.add_friction(middle, tangent, points[0].feature, normal_rows[0], normal_rows[1]);
}

template <Scalar Real>
void add_contact_stiffness(const Manifold<Real>& manifold, BodyId a, BodyId b, Real radius_a, Real radius_b,
                           const PerBody<Pose<Real>>& poses, const RowForces<Real>& forces,
                           PerBody<Vec3<Real>>& stiffness) {
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
    const Vec2<Real> arm_a = (kind == FeatureKind::face_of_a ? core_b : core_a) - poses[a].position;
    const Vec2<Real> arm_b = (kind == FeatureKind::face_of_b ? core_a : core_b) - poses[b].position;
    stiffness[a].z() += (kind == FeatureKind::face_of_a ? force : -force) * normal.dot(arm_a);
    stiffness[b].z() += (kind == FeatureKind::face_of_b ? -force : force) * normal.dot(arm_b);
  }
}

template void add_contact_stiffness(const Manifold<float>&, BodyId, BodyId, float, float,
                                    const PerBody<Pose<float>>&, const RowForces<float>&,
                                    PerBody<Vec3<float>>&);
template void add_contact_stiffness(const Manifold<double>&, BodyId, BodyId, double, double,
                                    const PerBody<Pose<double>>&, const RowForces<double>&,
                                    PerBody<Vec3<double>>&);
template void add_contact_stiffness(const Manifold<long double>&, BodyId, BodyId, long double, long double,
                                    const PerBody<Pose<long double>>&, const RowForces<long double>&,
                                    PerBody<Vec3<long double>>&);

template void write_contact_rows(const Manifold<float>&, BodyId, BodyId, const ContactMaterial<float>&,
                                 const PerBody<Pose<float>>&, const PerBody<Vec3<float>>&,
                                 const RowRule<float>&, std::uint64_t, VelocityProblem<float>&, int&,
                                 List<RelaxedRow<float>>*);
template void write_contact_rows(const Manifold<double>&, BodyId, BodyId, const ContactMaterial<double>&,
                                 const PerBody<Pose<double>>&, const PerBody<Vec3<double>>&,
                                 const RowRule<double>&, std::uint64_t, VelocityProblem<double>&, int&,
                                 List<RelaxedRow<double>>*);
template void write_contact_rows(const Manifold<long double>&, BodyId, BodyId,
                                 const ContactMaterial<long double>&, const PerBody<Pose<long double>>&,
                                 const PerBody<Vec3<long double>>&, const RowRule<long double>&,
                                 std::uint64_t, VelocityProblem<long double>&, int&,
                                 List<RelaxedRow<long double>>*);

}  // namespace cairn
