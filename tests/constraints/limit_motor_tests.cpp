// Limits and motors of hinges and slides: when they act, how hard, and what they refuse.
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double load_mass = 3;       // [kg]
const double load_inertia = 0.5;  // [kg m^2]

/// A body on an upright slide through the origin; s is its height.
Scene lift(const PrismaticJoint::Spec& spec) {
  Scene scene;
  PrismaticJoint::Spec complete = spec;
  complete.b = scene.add(disc({0, 0}, load_mass, load_inertia));
  complete.axis = {0, 1};
  scene.join<PrismaticJoint>(complete);
  return scene;
}

/// A wheel on a hinge in its centre: gravity does not turn it.
Scene wheel(const RevoluteJoint::Spec& spec, double angular_velocity = 0) {
  Scene scene;
  RevoluteJoint::Spec complete = spec;
  BodySpec body = disc({0, 0}, load_mass, load_inertia);
  body.angular_velocity = angular_velocity;
  complete.b = scene.add(body);
  scene.join<RevoluteJoint>(complete);
  return scene;
}

}  // namespace

TEST_CASE("a lower limit carries the weight m g of the load that rests on it") {
  World world(lift({.lower = 0}));
  step_often(world, 120);
  const double weight = load_mass * joint_gravity * joint_dt;  // [N s]
  CHECK(joint_impulse(world, JointPart::lower_limit) == doctest::Approx(weight).epsilon(1e-12));
  CHECK(std::abs(world.bodies().pose[{1}].position.y()) <= 1e-14);
}

TEST_CASE("an angular limit carries the moment m g l of a level arm") {
  const double arm = 0.75;
  for (const double side : {1.0, -1.0}) {
    Scene scene;
    const BodyId body = scene.add(disc({side * arm, 0}, load_mass, load_inertia));
    RevoluteJoint::Spec spec{.a = ground, .b = body, .anchor = {0, 0}};
    (side > 0 ? spec.lower : spec.upper) = 0;
    scene.join<RevoluteJoint>(spec);
    World world(scene);
    step_often(world, 30, 1000);
    const JointPart part = side > 0 ? JointPart::lower_limit : JointPart::upper_limit;
    const double moment = load_mass * joint_gravity * arm * joint_dt;  // [N m s]
    CHECK(joint_impulse(world, part) == doctest::Approx(moment).epsilon(1e-9));
    CHECK(std::abs(world.bodies().pose[{1}].angle) <= 1e-9);
  }
}

TEST_CASE_TEMPLATE("a load falls freely until its limit, and stops there without passing it", Real, float,
                   double) {
  const double drop = 1;
  World<Real> world(lift({.lower = -drop}));
  const Real tolerance = 64 * std::numeric_limits<Real>::epsilon();  // [m]
  SequentialImpulse<Real> solver({.iterations = 20});
  double height = 0, speed = 0;
  for (int step = 0; step < 60; ++step) {
    world.step(solver);
    speed -= joint_gravity * joint_dt;
    if (height + speed * joint_dt < -drop) speed = (-drop - height) / joint_dt;  // what room is left
    height += speed * joint_dt;
    CHECK(std::abs(world.bodies().pose[{1}].position.y() - static_cast<Real>(height)) <= 60 * tolerance);
  }
  CHECK(height == doctest::Approx(-drop));
}

TEST_CASE("a limit has a row within its margin only, and a joint without limits and motor has none") {
  CHECK(joint_row_count(World(lift({}))) == 2);
  CHECK(joint_row_count(World(lift({.lower = -0.25, .limit_margin = 0.5}))) == 3);
  CHECK(joint_row_count(World(lift({.lower = -0.75, .limit_margin = 0.5}))) == 2);
  CHECK(joint_row_count(World(lift({.lower = -0.75, .upper = 0.25, .limit_margin = 0.5}))) == 3);
  CHECK(joint_row_count(World(lift({.lower = -0.25, .upper = 0.25, .limit_margin = 0.5}))) == 4);
  CHECK(joint_row_count(World(lift({.lower = 2, .limit_margin = 0}))) == 3);  // violated
  CHECK(joint_row_count(World(lift({.motor = {{.speed = 1, .max_force = 1}}}))) == 3);
  CHECK(joint_row_count(World(wheel({}))) == 2);
  CHECK(joint_row_count(World(wheel({.lower = -1, .upper = 0.25}))) == 3);
  CHECK(joint_row_count(World(wheel({.motor = {{.speed = 1, .max_torque = 1}}}))) == 3);
}

TEST_CASE("a limit that is passed at the start takes a share beta of what is missing back in every step") {
  // Below g dt^2 / beta^2 = 0.069 m, gravity slows the load as fast as the limit asks: it does not fly off.
  const double missing = 0.05, beta = 0.2;
  World world(lift({.lower = missing}));
  SequentialImpulse<double> solver({.iterations = 20});
  for (int step = 1; step <= 20; ++step) {
    world.step(solver);
    const double left = missing - world.bodies().pose[{1}].position.y();
    CHECK(left == doctest::Approx(missing * std::pow(1 - beta, step)).epsilon(1e-11));
  }
}

TEST_CASE("two limits at one place hold a coordinate from both sides") {
  World world(wheel({.lower = 0, .upper = 0}, 4));
  step_often(world, 30);
  CHECK(std::abs(world.bodies().pose[{1}].angle) <= 1e-14);
  CHECK(std::abs(world.bodies().velocity[{1}].z()) <= 1e-14);
}

TEST_CASE_TEMPLATE("a motor turns a wheel up by max_torque / I, and then holds its speed", Real, float,
                   double) {
  const Real torque = Real(1.5), dt = static_cast<Real>(joint_dt);
  const Real acceleration = torque / static_cast<Real>(load_inertia);  // 3 rad/s^2: 2 rad/s in 2/3 s
  for (const double speed : {2.0, -2.0}) {
    World<Real> world(wheel({.motor = {{.speed = speed, .max_torque = 1.5}}}));
    SequentialImpulse<Real> solver({.iterations = 10});
    for (int step = 1; step <= 60; ++step) {
      world.step(solver);
      const Real steps = static_cast<Real>(step);
      const Real reached = std::min(acceleration * steps * dt, Real(2));
      const Real expected = std::copysign(reached, static_cast<Real>(speed));
      const Real tolerance = 8 * steps * std::numeric_limits<Real>::epsilon();
      CHECK(std::abs(world.bodies().velocity[{1}].z() - expected) <= tolerance);
      CHECK(std::abs(joint_impulse(world, JointPart::motor)) <= torque * dt);
    }
    CHECK(std::abs(joint_impulse(world, JointPart::motor)) <=
          torque * dt * Real(1e-5));  // nothing left to do
  }
}

TEST_CASE("a lift climbs with (F - m g) / m while its motor is at its limit, and then needs m g") {
  const double force = 45, speed = 1;  // 1.5 m g: 5 m/s^2
  World world(lift({.motor = {{.speed = speed, .max_force = force}}}));
  SequentialImpulse<double> solver({.iterations = 10});
  for (int step = 1; step <= 30; ++step) {
    world.step(solver);
    const double expected = std::min((force / load_mass - joint_gravity) * step * joint_dt, speed);
    CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(expected).epsilon(1e-12));
  }
  const double weight = load_mass * joint_gravity * joint_dt;
  CHECK(joint_impulse(world, JointPart::motor) == doctest::Approx(weight).epsilon(1e-12));
}

TEST_CASE("a lift whose motor is weaker than the load sinks with (m g - F) / m") {
  const double force = 12;
  World world(lift({.motor = {{.speed = 1, .max_force = force}}}));
  step_often(world, 30);
  const double expected = -(joint_gravity - force / load_mass) * 30 * joint_dt;
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(expected).epsilon(1e-12));
}

TEST_CASE("a motor's force does not depend on the step: half of dt, half of the impulse") {
  const double force = 45;
  World world(lift({.motor = {{.speed = 100, .max_force = force}}}));
  step_often(world, 5);
  CHECK(joint_impulse(world, JointPart::motor) == doctest::Approx(force * joint_dt).epsilon(1e-14));
  world.set_dt(joint_dt / 2);
  step_often(world, 1);
  CHECK(joint_impulse(world, JointPart::motor) == doctest::Approx(force * joint_dt / 2).epsilon(1e-14));
}

TEST_CASE("a motor drives a slide to its limit, which takes the force that is left over") {
  const double force = 45, upper = 0.25;
  World world(lift({.upper = upper, .motor = {{.speed = 2, .max_force = force}}}));
  step_often(world, 120, 2000);
  CHECK(world.bodies().pose[{1}].position.y() == doctest::Approx(upper).epsilon(1e-9));
  CHECK(joint_impulse(world, JointPart::motor) == doctest::Approx(force * joint_dt).epsilon(1e-9));
  const double left = (force - load_mass * joint_gravity) * joint_dt;
  CHECK(joint_impulse(world, JointPart::upper_limit) == doctest::Approx(left).epsilon(1e-9));
}

TEST_CASE("a motor between two free wheels turns them against each other, and nothing as a whole") {
  Scene scene({.gravity = {0, 0}});
  const double inertia_a = 0.5, inertia_b = 1.5, speed = 4;
  const BodyId a = scene.add(disc({0, 0}, 1, inertia_a)), b = scene.add(disc({0, 0}, 1, inertia_b));
  scene.join<RevoluteJoint>({.a = a, .b = b, .motor = {{.speed = speed, .max_torque = 100}}});
  World world(scene);
  step_often(world, 5);
  const double total = inertia_a + inertia_b;
  CHECK(world.bodies().velocity[{1}].z() == doctest::Approx(-speed * inertia_b / total).epsilon(1e-12));
  CHECK(world.bodies().velocity[{2}].z() == doctest::Approx(speed * inertia_a / total).epsilon(1e-12));
}

TEST_CASE("limits and motors are no drift of a joint") {
  World world(lift({.lower = -0.25, .motor = {{.speed = -1, .max_force = 10}}}));
  CHECK(snapshot(world).joints[0].drift <= 1e-15);
  World passed(lift({.lower = 0.25}));
  CHECK(snapshot(passed).joints[0].drift == doctest::Approx(0.25).epsilon(1e-14));  // but what is missing is
}

TEST_CASE("limits that coincide are one equality, as a weld's, however far the joint is from them") {
  for (const double range : {0.0, 0.3}) {
    const RevoluteJoint hinge({.b = {1}, .anchor = {0, 0}, .lower = range, .upper = range}, two_at_origin);
    const PrismaticJoint slide({.b = {1}, .axis = {1, 0}, .lower = range, .upper = range}, two_at_origin);
    for (const double off : {-2.0, 0.0, 2.0}) {
      RowSpecs<double> turned, slid;
      hinge.append_rows(PerBody<Pose<double>>{{}, {{0, 0}, off}}, turned);
      slide.append_rows(PerBody<Pose<double>>{{}, {{off, 0}, 0}}, slid);
      for (const RowSpecs<double>& rows : {turned, slid}) {
        REQUIRE(rows.size() == 3);
        CHECK(rows[0].bounds.is_equality());
        CHECK(rows[0].error == off - range);
      }
    }
  }
}

TEST_CASE("a hinge's limits and motor are refused by name when they cannot be") {
  const double inf = std::numeric_limits<double>::infinity();
  const auto refused = [](RevoluteJoint::Spec spec) {
    spec.b = {1};
    return refusal_of<RevoluteJoint>(spec);
  };
  const std::string place = "RevoluteJoint: ";
  CHECK(refused({.lower = -1, .upper = 1, .motor = {{.speed = -3, .max_torque = 2}}}) == "");
  CHECK(refused({.lower = -inf}) == place + "lower must be a finite number of rad, got -inf");
  CHECK(refused({.upper = std::nan("")}) == place + "upper must be a finite number of rad, got nan");
  CHECK(refused({.lower = 1, .upper = 0.5}) == place + "upper must be >= lower, 1 rad, got 0.5");
  CHECK(refused({.limit_margin = inf}) == place + "limit_margin must be a finite number >= 0 rad, got inf");
  CHECK(refused({.motor = {{.speed = inf, .max_torque = 1}}}) ==
        place + "motor speed must be a finite number of rad/s, got inf");
  for (const char* value : {"0", "-1", "nan", "inf"}) {
    CHECK(refused({.motor = {{.speed = 1, .max_torque = std::stod(value)}}}) ==
          place + "motor max_torque must be a finite number > 0 N m, got " + value);
  }
}
