// Two bodies as one: where a weld holds, what it carries, what it refuses.
#include "geometry/random_shapes.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE("a weld has no error where it was made, however its bodies stand, and sees every drift") {
  test::Random random(31);
  for (int round = 0; round < 20; ++round) {
    PerBody<Pose<double>> poses = {
        {}, {random.point(3), random.uniform(-9, 9)}, {random.point(3), random.uniform(-9, 9)}};
    const WeldJoint weld({.a = {1}, .b = {2}, .anchor = random.point(3)}, poses);
    RowSpecs<double> rows = rows_of(weld, poses);
    REQUIRE(rows.size() == 3);
    const double tolerance = 64 * std::numeric_limits<double>::epsilon() * 10;  // of numbers below 10
    for (const RowSpec<double>& row : rows) CHECK(std::abs(row.error) <= tolerance);

    // b moves by (0.25, -0.5) m and turns by two and a half turns about the anchor.
    const Vec2<double> moved(0.25, -0.5);
    const double turned = 5 * pi;
    const Vec2<double> anchor = poses[{2}].world(weld.attachments()[1].anchor);
    poses[{2}].position =
        anchor + Rotation<double>(turned) * Vec2<double>(poses[{2}].position - anchor) + moved;
    poses[{2}].angle += turned;
    rows = rows_of(weld, poses);
    CHECK(std::abs(rows[0].error - moved.x()) <= tolerance);
    CHECK(std::abs(rows[1].error - moved.y()) <= tolerance);
    CHECK(std::abs(rows[2].error - turned) <= 4 * tolerance);  // of numbers below 40
  }
}

TEST_CASE("two welded bodies fall and turn as one body of their common mass and inertia") {
  // A bar of mass 1 and inertia 1/2 at the left, one of mass 3 and inertia 1/4 at the right, 2 m apart. A
  // blow on the right one, of 3 m/s upward, gives the pair P / M and L / I about the common centre of mass.
  const double mass_a = 1, mass_b = 3, inertia_a = 0.5, inertia_b = 0.25, speed = 3;
  Scene scene({.gravity = {0, 0}});
  const BodyId a = scene.add(disc({0, 0}, mass_a, inertia_a));
  BodySpec struck = disc({2, 0}, mass_b, inertia_b);
  struck.velocity = {0, speed};
  const BodyId b = scene.add(struck);
  scene.join<WeldJoint>({.a = a, .b = b, .anchor = {1, 0}});
  World world(scene);
  step_often(world, 1, 2000);
  const double mass = mass_a + mass_b;
  const double centre = 2 * mass_b / mass;  // [m] from a
  const double inertia =
      inertia_a + inertia_b + mass_a * centre * centre + mass_b * (2 - centre) * (2 - centre);
  const double spin = mass_b * speed * (2 - centre) / inertia;
  const Vec3<double>& velocity_a = world.bodies().velocity[{1}];
  const Vec3<double>& velocity_b = world.bodies().velocity[{2}];
  CHECK(velocity_a.z() == doctest::Approx(spin).epsilon(1e-10));
  CHECK(velocity_b.z() == doctest::Approx(spin).epsilon(1e-10));
  CHECK(velocity_a.y() == doctest::Approx(mass_b * speed / mass - spin * centre).epsilon(1e-10));
  CHECK(velocity_b.y() == doctest::Approx(mass_b * speed / mass + spin * (2 - centre)).epsilon(1e-10));
}

TEST_CASE("a weld between one body and itself or at no place is refused") {
  CHECK(refusal_of<WeldJoint>({.a = {1}, .b = {1}}) == "WeldJoint: b must be another body than a, got 1");
  CHECK(refusal_of<WeldJoint>({.a = {0}, .b = {1}, .anchor = {0, std::nan("")}}) ==
        "WeldJoint: anchor must be finite numbers of m, got (0, nan)");
}
