// Wheels that roll on each other, and three that share their turning.
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

double turning(const World<double>& world, BodyId body) { return world.bodies().velocity[body].z(); }

}  // namespace

TEST_CASE("a planet that rolls about a fixed sun turns (r_a + r_b) / r_b times as fast as its carrier") {
  const double sun = 2, planet_radius = 1, arm = sun + planet_radius;  // [m]
  const double carrier_inertia = 4, planet_mass = 2, planet_inertia = 0.5, start = 1.5;
  Scene scene({.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  BodySpec turning_carrier = disc({0, 0}, 1, carrier_inertia);
  turning_carrier.angular_velocity = start;
  BodySpec moving_planet = disc({arm, 0}, planet_mass, planet_inertia);
  moving_planet.velocity = {0, start * arm};
  const BodyId carrier = scene.add(turning_carrier), planet = scene.add(moving_planet);
  scene.join<RevoluteJoint>({.a = ground, .b = carrier, .anchor = {0, 0}});
  scene.join<RevoluteJoint>({.a = carrier, .b = planet, .anchor = {arm, 0}});
  scene.join<GearJoint>({.a = ground, .b = planet, .c = carrier, .radius_a = sun, .radius_b = planet_radius});
  World world(scene);
  step_often(world, 1, 3000);
  // The planet did not turn: the teeth take from the carrier's motion what the planet's turning needs.
  const double ratio = arm / planet_radius;
  const double carried = carrier_inertia + planet_mass * arm * arm;
  const double speed = start * carried / (carried + planet_inertia * ratio * ratio);
  CHECK(turning(world, carrier) == doctest::Approx(speed).epsilon(1e-10));
  CHECK(turning(world, planet) == doctest::Approx(ratio * speed).epsilon(1e-10));
}

TEST_CASE("gears have no error where they were made, and see what slipped, many turns later too") {
  PerBody<Pose<double>> poses = {{}, {{0, 0}, 0.7}, {{3, 0}, -2}, {{0, 0}, 5}};
  const GearJoint gear({.a = {1}, .b = {2}, .radius_a = 1, .radius_b = 2}, poses);
  const DifferentialJoint shafts({.a = {1}, .b = {2}, .c = {3}}, poses);
  const double tolerance = 1e-13;  // of angles below 100 rad
  const auto error = [&](const Constraint& joint) {
    const RowSpecs<double> rows = rows_of(joint, poses);
    REQUIRE(rows.size() == 1);
    return rows[0].error;
  };
  CHECK(std::abs(error(gear)) <= tolerance);
  CHECK(std::abs(error(shafts)) <= tolerance);
  poses[{1}].angle += 20 * pi;
  poses[{2}].angle -= 10 * pi - 0.25;
  poses[{3}].angle += 5 * pi;
  CHECK(std::abs(error(gear) - 2 * 0.25) <= tolerance);
  CHECK(std::abs(error(shafts) - 0.25) <= tolerance);
}

TEST_CASE("gears on one body, and wheels without a radius, are refused") {
  CHECK(refusal_of<GearJoint>({.a = {1}, .b = {1}}) == "GearJoint: b must be another body than a, got 1");
  CHECK(refusal_of<GearJoint>({.a = {1}, .b = ground}) ==
        "GearJoint: c must be another body than a and b, got 0");
  CHECK(refusal_of<DifferentialJoint>({.a = {1}, .b = {1}}) ==
        "DifferentialJoint: b must be another body than a, got 1");
  CHECK(refusal_of<DifferentialJoint>({.a = {1}, .b = {0}, .c = {1}}) ==
        "DifferentialJoint: c must be another body than a and b, got 1");
  const PerBody<Pose<double>> three(3);
  CHECK_THROWS_WITH(GearJoint({.a = {1}, .b = {2}, .radius_a = 0}, three),
                    "GearJoint: radius_a must be > 0 m and finite, got 0");
  CHECK_THROWS_WITH(GearJoint({.a = {1}, .b = {2}, .radius_b = std::nan("")}, three),
                    "GearJoint: radius_b must be > 0 m and finite, got nan");
}
