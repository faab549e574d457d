// Floor 3. From contacts to rows.
#include <cairn/constraints/contact_rows.hpp>

#include <algorithm>

namespace cairn {

namespace {

// RowKey::source of contacts: joints have their ids.
constexpr std::uint64_t contact_source_bit = std::uint64_t{1} << 63;

template <Scalar Real>
std::uint64_t contact_source(const Manifold<Real>& manifold) {
  return contact_source_bit | static_cast<std::uint64_t>(manifold.collider_a) << 31 |
         static_cast<std::uint64_t>(manifold.collider_b);
}

/// One friction row for both points.
template <Scalar Real>
bool shares_friction(const Contact<Real>& contact, FrictionRows rows) {
  return rows == FrictionRows::per_manifold && contact.manifold.count == 2;
}

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

/// [m] The larger one of the two bodies.
template <Scalar Real>
Real rolling_resistance(const Contact<Real>& contact, const VelocityProblem<Real>& problem) {
  const PerBody<Real>& of = problem.rolling_resistance;
  return of.empty() ? Real(0) : std::max(of[contact.a], of[contact.b]);
}

template <Scalar Real>
bool has_rolling_row(const Contact<Real>& contact, const VelocityProblem<Real>& problem) {
  return contact.manifold.count == 1 && rolling_resistance(contact, problem) > 0 &&
         problem.inverse_mass[contact.a].z() + problem.inverse_mass[contact.b].z() > 0;
}

/// [m/s] With which the surfaces of a contact run along each other. Those that face each other run along the
/// tangent in opposite directions.
template <Scalar Real>
Real surface_speed(const Contact<Real>& contact, const VelocityProblem<Real>& problem) {
  const PerBody<Real>& of = problem.surface_speed;
  return of.empty() ? Real(0) : of[contact.a] + of[contact.b];
}

/// Of the points of a manifold.
template <Scalar Real>
Vec2<Real> middle_of(const Manifold<Real>& manifold) {
  if (manifold.count == 1) return manifold.points[0].position;
  return (manifold.points[0].position + manifold.points[1].position) / 2;
}

/// Where the rows of one contact go: over old ones where there are any, so every member is set.
template <Scalar Real>
struct ContactRows {
  const Contact<Real>& contact;
  VelocityProblem<Real>& problem;
  int& next;
  List<SecondRow<Real>>* second_rows;

  ConstraintRow<Real>& add(const Vec2<Real>& point, const Vec2<Real>& direction, std::uint64_t part) {
    if (next == problem.row_count()) problem.rows.emplace_back();
    ConstraintRow<Real>& row = problem.rows[next++];
    row.a = contact.a;
    row.b = contact.b;
    row.jacobian_a = jacobian_of_a(contact, point, direction);
    row.jacobian_b = jacobian_of_b(contact, point, direction);
    row.bias = row.softness = 0;
    row.key = {.source = contact_source(contact.manifold), .part = part};
    row.first_extra = problem.extra_terms.size();
    row.extra_count = 0;
    return row;
  }
  /// The number of the row.
  int add_normal(int i) {
    const ManifoldPoint<Real>& point = contact.manifold.points[i];
    const RowRule<Real>& rule = problem.rule;
    ConstraintRow<Real>& row = add(point.position, contact.manifold.normal, normal_part(point.feature));
    row.bounds = Bounds<Real>::unilateral();
    const bool on_spring = rule.has_springs && !(point.separation >= 0) && !contact.rigid[i];
    const Real rebound = rule.only_corrects ? Real(0) : contact.rebound[i];
    const auto bias = [&](bool is_second) {
      return contact_bias(rule, point.separation, contact.slop_limit, rebound, on_spring, is_second);
    };
    row.bias = bias(problem.is_second);
    if (on_spring && !problem.is_second)
      row.softness = spring_softness(rule, inverse_effective_mass(problem, row));
    if (rule.only_corrects) row.bias -= row_velocity(problem, row);
    if (second_rows) second_rows->push_back({.bias = bias(true)});
    return next - 1;
  }
  void add_friction(const Vec2<Real>& point, std::uint32_t feature, int normal_row, int second) {
    const Vec2<Real> tangent = -perpendicular(contact.manifold.normal);
    ConstraintRow<Real>& row = add(point, tangent, friction_part(feature));
    row.bounds = problem.rule.only_corrects ? Bounds<Real>::at_most(0)
                                            : Bounds<Real>::coulomb(contact.friction, normal_row, second);
    if (!problem.rule.only_corrects) row.bias = surface_speed(contact, problem);
    if (second_rows) second_rows->push_back({.bias = row.bias});
  }
  void add_rolling(int normal_row) {
    const ManifoldPoint<Real>& point = contact.manifold.points[0];
    ConstraintRow<Real>& row = add(point.position, Vec2<Real>::Zero(), rolling_part(point.feature));
    row.jacobian_a = {0, 0, -1};
    row.jacobian_b = {0, 0, 1};
    row.bounds = problem.rule.only_corrects
                     ? Bounds<Real>::at_most(0)
                     : Bounds<Real>::coulomb(rolling_resistance(contact, problem), normal_row);
    if (second_rows) second_rows->push_back({});
  }
};

}  // namespace

template <Scalar Real>
int contact_row_count(const Contact<Real>& contact, const VelocityProblem<Real>& problem) {
  if (problem.inverse_mass[contact.a].isZero(0) && problem.inverse_mass[contact.b].isZero(0)) return 0;
  const int points = contact.manifold.count;
  if (!(contact.friction > 0)) return points;
  if (shares_friction(contact, problem.friction_rows)) return points + 1;
  return 2 * points + (has_rolling_row(contact, problem) ? 1 : 0);
}

template <Scalar Real>
void meet(Contact<Real>& contact, const PerBody<Vec3<Real>>& before, Real threshold,
          const VelocityProblem<Real>& problem) {
  const RowRule<Real>& rule = problem.rule;
  for (int i = 0; i < contact.manifold.count; ++i) {
    const ManifoldPoint<Real>& point = contact.manifold.points[i];
    contact.rebound[i] = 0;
    contact.rigid[i] = false;
    if (!(contact.restitution > 0) && !(rule.has_springs && !(point.separation >= 0))) continue;
    const Vec3<Real> j_a = jacobian_of_a(contact, point.position, contact.manifold.normal);
    const Vec3<Real> j_b = jacobian_of_b(contact, point.position, contact.manifold.normal);
    const Real parting = dot(j_a, problem.velocity[contact.a]) + dot(j_b, problem.velocity[contact.b]);
    const Real approach = -j_a.dot(before[contact.a]) - j_b.dot(before[contact.b]);
    const bool meets = point.separation + rule.dt * parting < 0;
    if (contact.restitution > 0 && approach > threshold && meets)
      contact.rebound[i] = contact.restitution * approach;
    contact.rigid[i] = contact.rebound[i] > 0 || -parting > rule.most_speed;
  }
}

template <Scalar Real>
void add_contact_blocks(VelocityProblem<Real>& problem, int& next) {
  for (const Contact<Real>& contact : problem.contacts) {
    const int count = contact_row_count(contact, problem);
    const bool per_point = (problem.friction_rows == FrictionRows::per_point || !(contact.friction > 0)) &&
                           count <= 2 * contact.manifold.count;
    problem.blocks.push_back({next, count, per_point});
    next += count;
  }
}

template <Scalar Real>
void write_contact_rows(const Contact<Real>& contact, VelocityProblem<Real>& problem, int& next,
                        List<SecondRow<Real>>* second_rows) {
  const int count = contact_row_count(contact, problem);
  if (count == 0) return;
  ContactRows<Real> rows{contact, problem, next, second_rows};
  const auto& points = contact.manifold.points;
  const bool per_point = count >= 2 * contact.manifold.count;
  int normal_rows[2] = {Bounds<Real>::none, Bounds<Real>::none};
  for (int i = 0; i < contact.manifold.count; ++i) {
    normal_rows[i] = rows.add_normal(i);
    if (per_point)
      rows.add_friction(points[i].position, points[i].feature, normal_rows[i], Bounds<Real>::none);
  }
  if (count > 2 * contact.manifold.count) rows.add_rolling(normal_rows[0]);
  if (per_point || count == contact.manifold.count) return;
  rows.add_friction(middle_of(contact.manifold), points[0].feature, normal_rows[0], normal_rows[1]);
}

template <Scalar Real>
void write_contact_rows(VelocityProblem<Real>& problem, List<SecondRow<Real>>* second_rows) {
  int next = problem.joint_rows();
  make_room(problem.rows, problem.rows_in(problem.blocks.size()));
  for (const Contact<Real>& contact : problem.contacts)
    write_contact_rows(contact, problem, next, second_rows);
  problem.rows.resize(next);
}

template int contact_row_count(const Contact<float>&, const VelocityProblem<float>&);
template void meet(Contact<float>&, const PerBody<Vec3<float>>&, float, const VelocityProblem<float>&);
template void add_contact_blocks(VelocityProblem<float>&, int&);
template void write_contact_rows(const Contact<float>&, VelocityProblem<float>&, int&,
                                 List<SecondRow<float>>*);
template void write_contact_rows(VelocityProblem<float>&, List<SecondRow<float>>*);
template int contact_row_count(const Contact<double>&, const VelocityProblem<double>&);
template void meet(Contact<double>&, const PerBody<Vec3<double>>&, double, const VelocityProblem<double>&);
template void add_contact_blocks(VelocityProblem<double>&, int&);
template void write_contact_rows(const Contact<double>&, VelocityProblem<double>&, int&,
                                 List<SecondRow<double>>*);
template void write_contact_rows(VelocityProblem<double>&, List<SecondRow<double>>*);

}  // namespace cairn
