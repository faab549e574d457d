// Floor 3. The rows of one manifold.
#include "constraints/contact.hpp"

namespace cairn {

namespace {

/// The Jacobian of the relative velocity along `direction` of what two bodies have at a point.
template <Scalar Real, typename Row>
void set_jacobians(const Vec2<Real>& r_a, const Vec2<Real>& r_b, const Vec2<Real>& direction, Row& row) {
  row.jacobian_a = {-direction.x(), -direction.y(), -cross(r_a, direction)};
  row.jacobian_b = {direction.x(), direction.y(), cross(r_b, direction)};
}

/// Makes every row of a manifold, each by sink.row(part), and ends it by sink.end_normal(row, point, rebound)
/// or by sink.end_friction(row, normal_row, second_normal_row); sink.last() is the number of the last one.
template <Scalar Real, typename Sink>
void make_contact_rows(const Manifold<Real>& manifold, const Pose<Real>& pose_a, const Pose<Real>& pose_b,
                       const Vec3<Real>& velocity_a, const Vec3<Real>& velocity_b,
                       const ContactMaterial<Real>& material, Sink sink) {
  const Vec2<Real> tangent = -perpendicular(manifold.normal);
  const auto make = [&](const Vec2<Real>& position, const Vec2<Real>& direction,
                        std::uint64_t part) -> auto& {
    auto& row = sink.row(part);
    set_jacobians<Real>(position - pose_a.position, position - pose_b.position, direction, row);
    return row;
  };
  const bool has_friction = material.friction > 0;
  const bool is_shared = material.friction_rows == FrictionRows::per_manifold && manifold.count == 2;
  int normal_rows[2] = {Bounds<Real>::none, Bounds<Real>::none};
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    auto& normal = make(point.position, manifold.normal, normal_part(point.feature));
    Real rebound = 0;
    if (material.restitution > 0) {
      const Real approach = -normal.jacobian_a.dot(velocity_a) - normal.jacobian_b.dot(velocity_b);
      if (approach > material.restitution_threshold) rebound = material.restitution * approach;
    }
    sink.end_normal(normal, point, rebound);
    normal_rows[i] = sink.last();
    if (!has_friction || is_shared) continue;
    auto& friction = make(point.position, tangent, friction_part(point.feature));
    sink.end_friction(friction, normal_rows[i], Bounds<Real>::none);
  }
  if (has_friction && is_shared) {
    const auto& points = manifold.points;
    const Vec2<Real> middle = (points[0].position + points[1].position) / 2;
    auto& friction = make(middle, tangent, friction_part(points[0].feature));
    sink.end_friction(friction, normal_rows[0], normal_rows[1]);
  }
}

/// States the rows.
template <Scalar Real>
struct SpecSink {
  BodyId a, b;
  const ContactMaterial<Real>& material;
  RowSpecs<Real>& rows;

  RowSpec<Real>& row(std::uint64_t part) {
    RowSpec<Real>& row = rows.emplace_back();
    row.a = a;
    row.b = b;
    row.part = part;
    return row;
  }
  int last() const { return rows.size() - 1; }
  void end_normal(RowSpec<Real>& row, const ManifoldPoint<Real>& point, Real rebound) const {
    row.error = point.separation;
    row.bounds = Bounds<Real>::unilateral();
    row.slop_limit = material.slop_limit;
    row.gravity = material.gravity;
    row.rebound = rebound;
  }
  void end_friction(RowSpec<Real>& row, int normal_row, int second) const {
    row.bounds = Bounds<Real>::coulomb(material.friction, normal_row, second);
  }
};

/// Writes the rows as a solver sees them, over old ones where there are any: every member is set.
template <Scalar Real>
struct ProblemSink {
  BodyId a, b;
  const ContactMaterial<Real>& material;
  const ContactStabilization<Real>& stabilization;
  std::uint64_t source;
  VelocityProblem<Real>& problem;
  int& next;
  List<RelaxedRow<Real>>* relaxed;

  ConstraintRow<Real>& row(std::uint64_t part) {
    if (next == problem.row_count()) problem.rows.emplace_back();
    ConstraintRow<Real>& row = problem.rows[next++];
    row.a = a;
    row.b = b;
    row.softness = 0;
    row.key = {.source = source, .part = part};
    row.first_extra = problem.extra_terms.size();
    row.extra_count = 0;
    return row;
  }
  int last() const { return next - 1; }
  void end_normal(ConstraintRow<Real>& row, const ManifoldPoint<Real>& point, Real rebound) const {
    row.bounds = Bounds<Real>::unilateral();
    const RelaxedRow<Real> second = stabilization.stabilize(
        {point.separation, rebound, material.slop_limit, material.gravity}, problem, row);
    if (relaxed) relaxed->push_back(second);
  }
  void end_friction(ConstraintRow<Real>& row, int normal_row, int second) const {
    row.bias = 0;
    row.bounds = stabilization.has_friction() ? Bounds<Real>::coulomb(material.friction, normal_row, second)
                                              : Bounds<Real>::at_most(0);
    if (relaxed) relaxed->push_back({});
  }
};

}  // namespace

template <Scalar Real>
void append_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                         const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                         const PerBody<Vec3<Real>>& velocity, RowSpecs<Real>& rows) {
  make_contact_rows(manifold, poses[a], poses[b], velocity[a], velocity[b], material,
                    SpecSink<Real>{a, b, material, rows});
}

template <Scalar Real>
void write_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                        const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                        const PerBody<Vec3<Real>>& velocity, const ContactStabilization<Real>& stabilization,
                        std::uint64_t source, VelocityProblem<Real>& problem, int& next,
                        List<RelaxedRow<Real>>* relaxed) {
  if (problem.inverse_mass[a].isZero(0) && problem.inverse_mass[b].isZero(0)) return;
  make_contact_rows(manifold, poses[a], poses[b], velocity[a], velocity[b], material,
                    ProblemSink<Real>{a, b, material, stabilization, source, problem, next, relaxed});
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

template void append_contact_rows(const Manifold<float>&, BodyId, BodyId, const ContactMaterial<float>&,
                                  const PerBody<Pose<float>>&, const PerBody<Vec3<float>>&, RowSpecs<float>&);
template void append_contact_rows(const Manifold<double>&, BodyId, BodyId, const ContactMaterial<double>&,
                                  const PerBody<Pose<double>>&, const PerBody<Vec3<double>>&,
                                  RowSpecs<double>&);
template void append_contact_rows(const Manifold<long double>&, BodyId, BodyId,
                                  const ContactMaterial<long double>&, const PerBody<Pose<long double>>&,
                                  const PerBody<Vec3<long double>>&, RowSpecs<long double>&);

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
                                 const ContactStabilization<float>&, std::uint64_t, VelocityProblem<float>&,
                                 int&, List<RelaxedRow<float>>*);
template void write_contact_rows(const Manifold<double>&, BodyId, BodyId, const ContactMaterial<double>&,
                                 const PerBody<Pose<double>>&, const PerBody<Vec3<double>>&,
                                 const ContactStabilization<double>&, std::uint64_t, VelocityProblem<double>&,
                                 int&, List<RelaxedRow<double>>*);
template void write_contact_rows(const Manifold<long double>&, BodyId, BodyId,
                                 const ContactMaterial<long double>&, const PerBody<Pose<long double>>&,
                                 const PerBody<Vec3<long double>>&, const ContactStabilization<long double>&,
                                 std::uint64_t, VelocityProblem<long double>&, int&,
                                 List<RelaxedRow<long double>>*);

}  // namespace cairn
