// A slide along a line: what it lets go, what it holds, what it refuses.
#include "geometry/random_shapes.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double slide_infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a slide has no error anywhere on its line, which turns with its first body") {
  test::Random random(41);
  for (int round = 0; round < 20; ++round) {
    const PerBody<Pose<double>> start = {
        {}, {random.point(3), random.uniform(-3, 3)}, {random.point(3), random.uniform(-3, 3)}};
    const Vec2<double> axis = Rotation<double>(random.uniform(-pi, pi)) * Vec2<double>(7, 0);
    const PrismaticJoint slide({.a = {1}, .b = {2}, .anchor = random.point(3), .axis = axis}, start);
    // Both bodies turn about the origin, and b moves along the axis, which has turned as well.
    const double turned = random.uniform(-pi, pi), along = random.uniform(-2, 2);
    const Rotation<double> turn(turned);
    PerBody<Pose<double>> poses = start;
    for (const BodyId body : {BodyId{1}, BodyId{2}}) {
      poses[body] = {turn * start[body].position, start[body].angle + turned};
    }
    poses[{2}].position += turn * Vec2<double>(axis / 7) * along;
    const RowSpecs<double> rows = rows_of(slide, poses);
    REQUIRE(rows.size() == 2);  // no limits, no motor: no rows for them
    const double tolerance = 64 * std::numeric_limits<double>::epsilon() * 10;  // [m] of numbers below 10 m
    for (const RowSpec<double>& row : rows) CHECK(std::abs(row.error) <= tolerance);
  }
}

TEST_CASE_TEMPLATE(
    "a body on a slope without friction gains g sin(angle) dt in every step and stays on its line", Real,
    float, double) {
  const double slope = 0.5, mass = 3;
  Scene scene;
  const Vec2<double> axis(std::cos(slope), std::sin(slope));
  const BodyId sled = scene.add(disc({1, 2}, mass, 0.25));
  scene.join<PrismaticJoint>({.a = ground, .b = sled, .anchor = {1, 2}, .axis = axis});
  World<Real> world(scene);
  const int steps = 60;
  step_often(world, steps, 20);
  const Vec3<Real>& velocity = world.bodies().velocity[{1}];
  // Rounding: each step leaves a few ulp of g dt and of the position over dt.
  const Real tolerance = 64 * std::numeric_limits<Real>::epsilon() * steps * 10;
  const Real expected = static_cast<Real>(-joint_gravity * std::sin(slope) * steps * joint_dt);
  CHECK(std::abs(velocity.x() - expected * static_cast<Real>(axis.x())) <= tolerance + Real(1e-15));
  CHECK(std::abs(velocity.y() - expected * static_cast<Real>(axis.y())) <= tolerance + Real(1e-15));
  CHECK(std::abs(velocity.z()) <= tolerance);
  // Semi-implicit Euler: n steps go n (n + 1) / 2 times g sin(angle) dt^2.
  const Vec2<Real> moved = world.bodies().pose[{1}].position - Vec2<Real>(1, 2);
  const Real way =
      static_cast<Real>(-joint_gravity * std::sin(slope) * joint_dt * joint_dt * steps * (steps + 1) / 2);
  CHECK(std::abs(moved.x() - way * static_cast<Real>(axis.x())) <= tolerance);
  CHECK(std::abs(moved.y() - way * static_cast<Real>(axis.y())) <= tolerance);
}

TEST_CASE("a slide carries the load across its line, and the moment of a load beside it") {
  // The centre of mass is 0.5 m to the right of the anchor, on a level line.
  const double mass = 2, offset = 0.5;
  Scene scene;
  const BodyId arm = scene.add(disc({offset, 0}, mass, 0.5));
  scene.join<PrismaticJoint>({.a = ground, .b = arm, .anchor = {0, 0}, .axis = {1, 0}});
  World world(scene);
  step_often(world, 1, 1000);
  const double weight = mass * joint_gravity * joint_dt;  // [N s]
  CHECK(joint_impulse(world, JointPart::y) == doctest::Approx(weight).epsilon(1e-12));
  CHECK(joint_impulse(world, JointPart::angle) == doctest::Approx(weight * offset).epsilon(1e-12));
  CHECK(world.bodies().velocity[{1}].norm() <= 1e-14);
}

TEST_CASE("two bodies on one slide turn as one, and part along it as if they were free") {
  // No gravity: they fly apart along their line, which turns ever more slowly, as angular momentum is kept.
  Scene scene(
      {.gravity = {0, 0}, .dt = 1.0 / 960, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  BodySpec left = disc({-1, 0}, 1, 0.5), right = disc({1, 0}, 1, 0.5);
  left.velocity = {-1, -2};
  right.velocity = {1, 2};
  left.angular_velocity = right.angular_velocity = 2;
  const BodyId a = scene.add(left), b = scene.add(right);
  scene.join<PrismaticJoint>({.a = a, .b = b, .anchor = {1, 0}, .axis = {1, 0}});
  World world(scene);
  const double momentum = 2 * (0.5 * 2 + 1 * 1 * 2);  // 2 (I w + m r v)
  step_often(world, 480);
  const Pose<double>& pose = world.bodies().pose[{2}];
  const Vec3<double>& velocity = world.bodies().velocity[{2}];
  CHECK(velocity.z() == doctest::Approx(world.bodies().velocity[{1}].z()).epsilon(1e-6));
  const double kept = 2 * (0.5 * velocity.z() + cross(pose.position, Vec2<double>(velocity.head<2>())));
  CHECK(kept == doctest::Approx(momentum).epsilon(1e-9));
  const double r = pose.position.norm();
  CHECK(velocity.z() == doctest::Approx(momentum / (2 * (0.5 + r * r))).epsilon(0.01));  // O(dt)
  CHECK(r > 1.5);
}

TEST_CASE("a slide's axis, limits and motor are refused by name when they cannot be") {
  using Spec = PrismaticJoint::Spec;
  const auto refused = [](Spec spec) {
    spec.b = {1};
    return refusal_of<PrismaticJoint>(spec);
  };
  const std::string place = "PrismaticJoint: ";
  CHECK(refused({}) == "");
  CHECK(refusal_of<PrismaticJoint>({}) == place + "b must be another body than a, got 0");
  CHECK(refused({.anchor = {slide_infinity, 0}}) ==
        place + "anchor must be finite numbers of m, got (inf, 0)");
  CHECK(refused({.axis = {0, 0}}) == place + "axis must be of a finite length > 0 m, got 0");
  CHECK(refused({.axis = {0, std::nan("")}}) == place + "axis must be finite numbers of m, got (0, nan)");
  CHECK(refused({.lower = std::nan("")}) == place + "lower must be a finite number of m, got nan");
  CHECK(refused({.upper = slide_infinity}) == place + "upper must be a finite number of m, got inf");
  CHECK(refused({.lower = 1, .upper = 0.5}) == place + "upper must be >= lower, 1 m, got 0.5");
  CHECK(refused({.lower = 1, .upper = 1}) == "");
  CHECK(refused({.limit_margin = -1}) == place + "limit_margin must be a finite number >= 0 m, got -1");
  CHECK(refused({.motor = {{.speed = slide_infinity, .max_force = 1}}}) ==
        place + "motor speed must be a finite number of m/s, got inf");
  for (const char* value : {"0", "-1", "nan", "inf"}) {
    CHECK(refused({.motor = {{.speed = 1, .max_force = std::stod(value)}}}) ==
          place + "motor max_force must be a finite number > 0 N, got " + value);
  }
}
