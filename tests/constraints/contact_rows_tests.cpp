// The rows of a contact as a problem has them.
#include "geometry/random_shapes.hpp"
#include "testing.hpp"

using namespace cairn;

namespace {

/// Two bodies that touch in two points, of which body 0 is immovable and body 1 turns about the origin.
struct Touching {
  Contact<double> contact = {.a = {0}, .b = {1}, .center_a = {0.5, -1}, .center_b = {0, 1}, .friction = 0.5};
  double threshold = 0;  // [m/s] of rebounds
  PerBody<Vec3<double>> velocity_before = {{0, 0, 0}, {0, -2, 0}};
  VelocityProblem<double> problem = {};

  Touching() {
    Manifold<double>& manifold = contact.manifold;
    manifold.collider_a = 5;
    manifold.collider_b = 7;
    manifold.normal = {0, 1};
    manifold.count = 2;
    manifold.points[0] = {.position = {-0.5, 0}, .separation = 0.25, .feature = 3};
    manifold.points[1] = {.position = {0.5, 0}, .separation = -0.001, .feature = 4};
    problem.velocity = velocity_before;
    problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>::Ones()};
    problem.dt = 0.01;
    problem.rule = contact_rule<double>({}, StabilizationPass::velocity, 0.01, 10);
  }
  /// Behind three rows of something else, over `old` others.
  int write(int old, List<SecondRow<double>>* second_rows = nullptr) {
    problem.rows.resize(3 + old);
    for (ConstraintRow<double>& row : problem.rows)
      row = {.bias = 9, .softness = 9, .first_extra = 9, .extra_count = 9};
    int next = 3;
    meet(contact, velocity_before, threshold, problem);
    write_contact_rows(contact, problem, next, second_rows);
    CHECK(next - 3 == contact_row_count(contact, problem));
    for (int i = 3; i < next; ++i)
      CHECK(problem.rows[i].key.part == contact_part(contact.manifold, next - 3, i - 3));
    return next - 3;
  }
  const ConstraintRow<double>& row(int k) const { return problem.rows[3 + k]; }
};

}  // namespace

TEST_CASE("a contact has rows of its points, normal before friction, and every member of an old row is set") {
  for (const int old : {0, 2, 7}) {
    Touching touching;
    REQUIRE(touching.write(old) == 4);
    const Vec2<double> tangent(1, 0);
    for (int k = 0; k < 4; ++k) {
      const ManifoldPoint<double>& point = touching.contact.manifold.points[k / 2];
      const Vec2<double> direction = k % 2 == 0 ? touching.contact.manifold.normal : tangent;
      const ConstraintRow<double>& row = touching.row(k);
      CHECK(row.a == BodyId{0});
      CHECK(row.b == BodyId{1});
      const Vec2<double> r_a = point.position - touching.contact.center_a;
      const Vec2<double> r_b = point.position - touching.contact.center_b;
      CHECK(row.jacobian_a == Vec3<double>(-direction.x(), -direction.y(), -cross(r_a, direction)));
      CHECK(row.jacobian_b == Vec3<double>(direction.x(), direction.y(), cross(r_b, direction)));
      CHECK(row.key.source == (std::uint64_t{1} << 63 | std::uint64_t{5} << 31 | 7));
      CHECK(row.key.part == (k % 2 == 0 ? normal_part(point.feature) : friction_part(point.feature)));
      CHECK(row.softness == 0);
      CHECK(row.extra_count == 0);
      CHECK(row.first_extra == 0);
      CHECK(row.bounds.is_unilateral() == (k % 2 == 0));
      CHECK(row.bounds.normal_row == (k % 2 == 0 ? -1 : 3 + k - 1));
    }
    CHECK(touching.row(0).bias == -0.25 / 0.01);
    CHECK(touching.row(1).bias == 0);
  }
}

TEST_CASE("one friction row for two points acts between them, and has the loads of both") {
  Touching touching;
  touching.problem.friction_rows = FrictionRows::per_manifold;
  REQUIRE(touching.write(0) == 3);
  const ConstraintRow<double>& row = touching.row(2);
  CHECK(row.bounds.normal_row == 3);
  CHECK(row.bounds.second_normal_row == 4);
  CHECK(row.jacobian_b == Vec3<double>(1, 0, 1));  // (0, 0) - (0, 1) crossed with (1, 0)
  touching.contact.friction = 0;
  CHECK(touching.write(0) == 2);
}

TEST_CASE("a contact rebounds by the share e of the speed with which bodies came, where that is enough") {
  Touching touching;
  touching.contact.restitution = 0.5;
  touching.threshold = 1;
  List<SecondRow<double>> second_rows;
  touching.write(0, &second_rows);
  CHECK(touching.row(0).bias == -0.25 / 0.01);  // 0.25 m away at 2 m/s: not in this step
  CHECK(touching.row(2).bias == 0.5 * 2);
  REQUIRE(second_rows.size() == 4);
  CHECK(second_rows[2].bias == 0.5 * 2);
  touching.threshold = 3;
  touching.write(0);
  CHECK(touching.row(2).bias == 0);
}

TEST_CASE("where only positions are corrected, friction does nothing") {
  Touching touching;
  touching.problem.rule = contact_rule<double>({.policy = StabilizationPolicy::split_impulse},
                                               StabilizationPass::position, 0.01, 10);
  REQUIRE(touching.write(0) == 4);
  CHECK(touching.row(1).bounds.upper == 0);
  CHECK(touching.row(1).bounds.lower == 0);
}

TEST_CASE("between bodies that nothing moves no contact row is written") {
  Touching touching;
  touching.problem.inverse_mass.assign(2, Vec3<double>::Zero());
  CHECK(touching.write(5) == 0);
}
