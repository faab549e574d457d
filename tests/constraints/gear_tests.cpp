// Wheels that roll on each other, and three that share their turning.
#include "constraints/differential_joint.hpp"
#include "constraints/gear_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double out_of_reach = 1e6;  // [rad/s] a motor of this speed gives all of its torque, always

/// A wheel on an axle that is fixed to the ground, at (x, 0); driven where the torque is not 0.
BodyId pinned_wheel(Scene& scene, double x, double inertia, double torque = 0) {
  const BodyId wheel = scene.add(disc({x, 0}, 1, inertia));
  RevoluteJoint::Spec axle{.a = ground, .b = wheel, .anchor = {x, 0}};
  if (torque != 0) axle.motor = RevoluteJoint::Motor{.speed = out_of_reach, .max_torque = torque};
  scene.join<RevoluteJoint>(axle);
  return wheel;
}

double turning(const World<double>& world, BodyId body) {
  return world.bodies().velocity[static_cast<std::size_t>(body.index)].z();
}

}  // namespace

// A18
TEST_CASE("a driven wheel with another one in mesh accelerates with tau / (I1 + I2 (r1 / r2)^2)") {
  const double torque = 3, inertia_a = 0.5, inertia_b = 8, radius_a = 1, radius_b = 2;
  for (const GearJoint::Mesh mesh : {GearJoint::Mesh::external, GearJoint::Mesh::internal}) {
    Scene scene;
    const BodyId a = pinned_wheel(scene, 0, inertia_a, torque), b = pinned_wheel(scene, 3, inertia_b);
    scene.join<GearJoint>({.a = a, .b = b, .radius_a = radius_a, .radius_b = radius_b, .mesh = mesh});
    World world(scene);
    const int steps = 60;
    step_often(world, steps, 20);
    const double ratio = radius_a / radius_b;
    const double speed = torque / (inertia_a + inertia_b * ratio * ratio) * steps * joint_dt;  // 1.2 rad/s
    const double sense = mesh == GearJoint::Mesh::external ? -1 : 1;
    CHECK(turning(world, a) == doctest::Approx(speed).epsilon(1e-9));  // as given for a long run
    CHECK(turning(world, b) == doctest::Approx(sense * speed * ratio).epsilon(1e-9));
    // The force between the teeth turns b alone.
    const double tooth = inertia_b * speed * ratio / (steps * joint_dt) / radius_b;
    CHECK(std::abs(joint_impulse(world, JointPart::x, 2)) / joint_dt == doctest::Approx(tooth).epsilon(1e-9));
  }
}

TEST_CASE("a planet that rolls about a fixed sun turns (r_a + r_b) / r_b times as fast as its carrier") {
  const double sun = 2, planet_radius = 1, arm = sun + planet_radius;  // [m]
  const double carrier_inertia = 4, planet_mass = 2, planet_inertia = 0.5, start = 1.5;
  Scene scene({.gravity = {0, 0}});
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

// B20
TEST_CASE("a differential keeps w_a + w_b = 2 w_c, and turns both shafts with the same torque") {
  const double torque = 5, inertia_a = 1, inertia_b = 3, inertia_c = 2;
  Scene scene;
  const BodyId a = pinned_wheel(scene, -3, inertia_a), b = pinned_wheel(scene, 3, inertia_b);
  const BodyId c = pinned_wheel(scene, 0, inertia_c, torque);
  scene.join<DifferentialJoint>({.a = a, .b = b, .c = c});
  World world(scene);
  for (int step = 1; step <= 60; ++step) {
    step_often(world, 1, 20);
    // The row is the last to be solved: what is left is rounding, of speeds below 10 rad/s.
    CHECK(std::abs(turning(world, a) + turning(world, b) - 2 * turning(world, c)) <= 1e-12);
  }
  // I_a alpha_a = I_b alpha_b = lambda, I_c alpha_c = tau - 2 lambda, and alpha_a + alpha_b = 2 alpha_c.
  const double lambda = 2 * torque / inertia_c / (1 / inertia_a + 1 / inertia_b + 4 / inertia_c);
  const double time = 60 * joint_dt;
  CHECK(turning(world, a) == doctest::Approx(lambda / inertia_a * time).epsilon(1e-9));
  CHECK(turning(world, b) == doctest::Approx(lambda / inertia_b * time).epsilon(1e-9));
  CHECK(turning(world, c) == doctest::Approx((torque - 2 * lambda) / inertia_c * time).epsilon(1e-9));
  CHECK(std::abs(joint_impulse(world, JointPart::x, 3)) / joint_dt == doctest::Approx(lambda).epsilon(1e-9));
}

TEST_CASE("gears have no error where they were made, and see what slipped, many turns later too") {
  std::vector<Pose<double>> poses = {{}, {{0, 0}, 0.7}, {{3, 0}, -2}, {{0, 0}, 5}};
  const GearJoint gear({.a = {1}, .b = {2}, .radius_a = 1, .radius_b = 2}, poses);
  const DifferentialJoint shafts({.a = {1}, .b = {2}, .c = {3}}, poses);
  const double tolerance = 1e-13;  // of angles below 100 rad
  const auto error = [&](const Constraint& joint) {
    RowSpecs<double> rows;
    joint.append_rows(poses, rows);
    REQUIRE(rows.size() == 1);
    return rows[0].error;
  };
  CHECK(std::abs(error(gear)) <= tolerance);
  CHECK(std::abs(error(shafts)) <= tolerance);
  poses[1].angle += 20 * pi;
  poses[2].angle -= 10 * pi - 0.25;
  poses[3].angle += 5 * pi;
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
  const std::vector<Pose<double>> three(3);
  CHECK_THROWS_WITH(GearJoint({.a = {1}, .b = {2}, .radius_a = 0}, three),
                    "GearJoint: radius_a must be > 0 m and finite, got 0");
  CHECK_THROWS_WITH(GearJoint({.a = {1}, .b = {2}, .radius_b = std::nan("")}, three),
                    "GearJoint: radius_b must be > 0 m and finite, got nan");
}
