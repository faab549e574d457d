// Servos, springs and ratchets along what a joint leaves free; soft welds, slots, wheels, racks, least
// lengths.
#include <cairn/measure/energy.hpp>
#include <cairn/world/plan.hpp>
#include <cairn/world/scene_snapshot.hpp>

#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double drive_mass = 3;       // [kg]
const double drive_inertia = 0.5;  // [kg m^2]

/// A wheel on a hinge in its centre: gravity does not turn it.
Scene driven_wheel(const RevoluteJoint::Spec& spec, double inertia = drive_inertia, double spin = 0,
                   double dt = joint_dt) {
  Scene scene({.dt = dt});
  RevoluteJoint::Spec complete = spec;
  BodySpec body = disc({0, 0}, drive_mass, inertia);
  body.angular_velocity = spin;
  complete.b = scene.add(body);
  scene.join<RevoluteJoint>(complete);
  return scene;
}

RevoluteJoint::Spec servo_spec(double target, double max_torque, double rate = 10, double speed = 2) {
  return {.motor =
              RevoluteJoint::Motor{.speed = speed, .max_torque = max_torque, .target = target, .rate = rate}};
}

/// With the events of the scene.
void run_often(World<double>& world, int steps) {
  for (int step = 0; step < steps; ++step) {
    do_events(world);
    step_often(world, 1);
  }
}

template <Scalar Real>
double angle_of(const World<Real>& world, BodyId body = {1}) {
  return static_cast<double>(world.bodies().pose[body].angle);
}

}  // namespace

TEST_CASE_TEMPLATE("a servo comes to its target at any rate, step and inertia, and never goes beyond", Real,
                   float, double) {
  const double target = -1;
  for (const double rate : {2.0, 10.0, 1e9}) {
    for (const double dt : {1.0 / 20, 1.0 / 60, 1.0 / 1000}) {
      for (const double inertia : {1e-6, 1.0, 1e6}) {
        CAPTURE(rate);
        CAPTURE(dt);
        CAPTURE(inertia);
        World<Real> world(driven_wheel(servo_spec(target, 1e12 * inertia, rate), inertia, 0, dt));
        double least = 0;
        for (int step = 0; step < 8 / dt; ++step) {
          step_often(world, 1, 10);
          least = std::min(least, angle_of(world));
        }
        // What is left of a float's angle moves it no more.
        const double unmoved = static_cast<double>(std::numeric_limits<Real>::epsilon()) / (rate * dt);
        CHECK(angle_of(world) == doctest::Approx(target).epsilon(1e-6 + unmoved));
        CHECK(least >= target - 1e-6);
      }
    }
  }
}

TEST_CASE("a servo begins to brake so soon that half of its force stops what it moves, an arm with it") {
  for (const double max_torque : {0.1, 1.0, 100.0}) {
    for (const double arm : {0.0, 2.0}) {
      CAPTURE(max_torque);
      CAPTURE(arm);
      Scene scene({.gravity = {0, 0}});
      const BodyId body = scene.add(disc({arm, 0}, drive_mass, drive_inertia));
      RevoluteJoint::Spec spec = servo_spec(1, max_torque, 50, 5);
      spec.b = body;
      scene.join<RevoluteJoint>(spec);
      World world(scene);
      double most = 0;
      for (int step = 0; step < 3600; ++step) {
        step_often(world, 1, 200);
        most = std::max(most, angle_of(world));
      }
      CHECK(angle_of(world) == doctest::Approx(1).epsilon(1e-6));
      CHECK(most <= 1 + 1e-6);
    }
  }
}

TEST_CASE("a light arm on a servo carries a load a thousand times as heavy") {
  Scene scene;
  const BodyId arm = scene.add({.position = {0.5, 0}, .mass = 0.1, .inertia = 0.01});
  const BodyId load = scene.add({.position = {1, 0}, .mass = 100, .inertia = 1});
  scene.join<RevoluteJoint>(
      {.b = arm, .motor = RevoluteJoint::Motor{.speed = 1, .max_torque = 2000, .target = pi / 2}});
  scene.join<WeldJoint>({.a = arm, .b = load, .anchor = {1, 0}});
  World world(scene);
  step_often(world, 600, 2000);
  CHECK(angle_of(world, arm) == doctest::Approx(pi / 2).epsilon(1e-4));
  CHECK((world.bodies().pose[load].position - Vec2<double>(0, 1)).norm() < 1e-3);
}

TEST_CASE("an event gives a servo another target, and a motor that had none becomes a servo") {
  for (const bool is_servo : {true, false}) {
    RevoluteJoint::Spec spec = servo_spec(1, 10);
    if (!is_servo) spec.motor->target.reset();
    Scene scene = driven_wheel(spec);
    const JointId joint = scene.joints().id(0);
    scene.add(
        {.time = 1, .action = SwitchMotor{joint, JointMotor{.speed = 2, .max_force = 10, .target = -0.5}}});
    World world(scene);
    run_often(world, 600);
    CHECK(angle_of(world) == doctest::Approx(-0.5).epsilon(1e-6));
    CHECK(world.scene().joints()[0]->motor()->target == -0.5);
  }
}

TEST_CASE("the energy of a torsion spring and of a spring along a slide is k C^2 / 2") {
  const JointSpring spring{.softness = SpringSoftness{.stiffness = 6}, .rest = 0.5};
  Scene scene({.gravity = {0, 0}});
  const BodyId body = scene.add(disc({0, 0}, drive_mass, drive_inertia));
  scene.join<RevoluteJoint>({.b = body, .spring = spring});
  CHECK(potential_energy(snapshot(scene)) == doctest::Approx(6 * 0.25 / 2).epsilon(1e-12));
  Scene slide({.gravity = {0, 0}});
  const BodyId slider = slide.add(disc({0, 0}, drive_mass, drive_inertia));
  slide.join<PrismaticJoint>({.b = slider, .spring = spring});
  CHECK(potential_energy(snapshot(slide)) == doctest::Approx(6 * 0.25 / 2).epsilon(1e-12));
  World world(slide);
  step_often(world, 1);
  CHECK(world.bodies().velocity[slider].x() > 0);  // towards its rest
}

TEST_CASE_TEMPLATE("a ratchet lets a wheel turn on and holds it at the last tooth for ever", Real, float,
                   double) {
  for (const double tooth : {0.25, 0.001, -0.25}) {
    CAPTURE(tooth);
    const double side = tooth > 0 ? 1 : -1;
    RevoluteJoint::Spec spec{.ratchet = tooth};
    // A load that turns it back, always: a motor without end.
    spec.motor = RevoluteJoint::Motor{.speed = -side * 1e6, .max_torque = 2};
    World<Real> world(driven_wheel(spec, drive_inertia, side * 3));
    double most = 0, least_after = 1e9;
    for (int step = 0; step < 600; ++step) {
      step_often(world, 1, 20);
      most = std::max(most, side * angle_of(world));
      if (step > 300) least_after = std::min(least_after, side * angle_of(world));
    }
    CHECK(most > 0.9);  // I w^2 / 2 of 2.25 J against 2 N m, and roundings
    const double held = std::floor(most / std::abs(tooth)) * std::abs(tooth);
    CHECK(side * angle_of(world) <= most);
    CHECK(least_after >= held - 0.021 * std::abs(tooth) - 1e-6);
    CHECK(side * angle_of(world) == doctest::Approx(least_after).epsilon(1e-3));
  }
}

TEST_CASE("a ratchet along a slide is a jack: it goes up by its motor, and stays up when that is off") {
  Scene scene;
  const BodyId load = scene.add(disc({0, 0}, drive_mass, drive_inertia));
  scene.join<PrismaticJoint>({.b = load,
                              .axis = {0, 1},
                              .motor = PrismaticJoint::Motor{.speed = 0.5, .max_force = 100},
                              .ratchet = 0.1});
  scene.add({.time = 1.07, .action = SwitchMotor{scene.joints().id(0), {}}});
  World world(scene);
  run_often(world, 300);
  CHECK(world.bodies().pose[load].position.y() == doctest::Approx(0.5).epsilon(1e-9));
}

TEST_CASE("a slot keeps a point on its line and leaves the angle alone; a wheel's motor turns it") {
  Scene scene({.gravity = {0, 0}});
  BodySpec pin = disc({0, 0}, drive_mass, drive_inertia);
  pin.velocity = {1, 5};
  pin.angular_velocity = 2;
  const BodyId body = scene.add(pin);
  scene.join<PrismaticJoint>({.b = body, .kind = PrismaticJoint::Kind::slot, .upper = 0.5});
  World world(scene);
  step_often(world, 120);
  CHECK(world.bodies().pose[body].position.x() == doctest::Approx(0.5).epsilon(1e-9));
  CHECK(std::abs(world.bodies().pose[body].position.y()) < 1e-9);
  CHECK(world.bodies().velocity[body].z() == doctest::Approx(2).epsilon(1e-12));

  Scene turning({.gravity = {0, 0}});
  const BodyId disc_on_spring = turning.add(disc({0, 0}, drive_mass, drive_inertia));
  turning.join<PrismaticJoint>({.b = disc_on_spring,
                                .axis = {0, 1},
                                .kind = PrismaticJoint::Kind::wheel,
                                .motor = PrismaticJoint::Motor{.speed = 7, .max_force = 2},
                                .spring = JointSpring{.softness = SpringSoftness{.stiffness = 100}}});
  World turned(turning);
  step_often(turned, 30);
  CHECK(turned.bodies().velocity[disc_on_spring].z() == doctest::Approx(2 / drive_inertia / 2).epsilon(1e-9));
  CHECK(turned.bodies().pose[disc_on_spring].position.norm() < 1e-12);
}

TEST_CASE("a soft weld gives way without being off, and a rigid one has no spring") {
  Scene scene;
  const BodyId arm = scene.add(disc({1, 0}, drive_mass, drive_inertia));
  scene.join<WeldJoint>({.b = arm, .bending = SpringSoftness{.stiffness = 1000, .damping = 50}});
  World world(scene);
  step_often(world, 600, 300);
  const Snapshot now = snapshot(world);
  CHECK(now.joints[0].drift < 1e-6);
  const double bent = angle_of(world), moment = drive_mass * joint_gravity * std::cos(bent);
  CHECK(bent == doctest::Approx(-moment / 1000).epsilon(1e-4));
  CHECK(now.joints[0].energy == doctest::Approx(1000 * bent * bent / 2).epsilon(1e-9));
}

TEST_CASE("a rack goes along its axis as its wheel turns counterclockwise") {
  Scene scene({.gravity = {0, 0}});
  BodySpec pinion = disc({0, 0}, drive_mass, drive_inertia);
  pinion.angular_velocity = 2;
  const BodyId gear = scene.add(pinion), rack = scene.add(disc({0, -1}, drive_mass, drive_inertia));
  scene.join<RevoluteJoint>({.b = gear});
  scene.join<PrismaticJoint>({.b = rack, .anchor = {0, -1}, .axis = {0, 1}});
  scene.join<GearJoint>(
      {.a = gear, .b = rack, .radius_a = 0.25, .mesh = GearJoint::Mesh::rack, .axis = {0, -3}});
  World world(scene);
  step_often(world, 60, 1000);
  CHECK(angle_of(world, gear) > 1);
  CHECK(world.bodies().pose[rack].position.y() + 1 ==
        doctest::Approx(-0.25 * angle_of(world, gear)).epsilon(1e-9));
}

TEST_CASE("a joint without servo, spring or ratchet has no row for one, and the plan says nothing of them") {
  Scene plain = driven_wheel({}), full = driven_wheel(servo_spec(1, 2));
  CHECK(joint_row_count(World(plain)) == 2);
  CHECK(joint_row_count(World(full)) == 3);
  const std::string without = explain(make_plan(plain)), with = explain(make_plan(full));
  for (const std::string word : {"servos", "joint springs", "ratchets"})
    CHECK(without.find(word) == std::string::npos);
  CHECK(with.find("servos        1: a row each") != std::string::npos);
  const Scene sprung = driven_wheel({.spring = JointSpring{}, .ratchet = 1});
  CHECK(explain(make_plan(sprung)).find("joint springs 1: ") != std::string::npos);
  CHECK(explain(make_plan(sprung)).find("ratchets      1: ") != std::string::npos);
}

TEST_CASE("servos, springs, ratchets, wheels, racks and least lengths out of range are refused by name") {
  CHECK(refusal_of<RevoluteJoint>({.b = {1}, .motor = servo_spec(1, 2, 0).motor}) ==
        "RevoluteJoint: motor rate must be a finite number > 0 1/s, got 0");
  CHECK(refusal_of<RevoluteJoint>({.b = {1}, .motor = servo_spec(1, 2, 10, -1).motor}) ==
        "RevoluteJoint: motor speed must be > 0 rad/s where there is a target, got -1");
  CHECK(refusal_of<PrismaticJoint>(
            {.b = {1}, .motor = PrismaticJoint::Motor{.speed = 1, .max_force = 1, .target = 1.0 / 0.0}})
            .starts_with("PrismaticJoint: motor target must be a finite number"));
  CHECK(refusal_of<RevoluteJoint>({.b = {1}, .ratchet = 0}) ==
        "RevoluteJoint: ratchet must be from 1e-9 to 1e9 rad, or the same below 0, got 0");
  CHECK(refusal_of<RevoluteJoint>({.b = {1}, .spring = JointSpring{.softness = SpringSoftness{}}})
            .starts_with("RevoluteJoint: softness stiffness must be > 0"));
  CHECK(refusal_of<PrismaticJoint>({.b = {1}, .kind = PrismaticJoint::Kind::wheel}) ==
        "PrismaticJoint: spring must be given for a wheel, got none");
  CHECK(refusal_of<WeldJoint>({.b = {1}, .bending = SwingSoftness{.frequency = 0}})
            .starts_with("WeldJoint: softness frequency must be from 1e-6 to 1e6 Hz"));
  CHECK(refusal_of<GearJoint>({.a = {0}, .b = {1}, .c = {2}, .mesh = GearJoint::Mesh::rack, .axis = {0, 0}})
            .starts_with("GearJoint: axis must be of a finite length > 0 m"));
  using Kind = DistanceJoint::Kind;
  CHECK(refusal_of<DistanceJoint>({.b = {1}, .length = 1, .kind = Kind::rope, .least = 1}) ==
        "DistanceJoint: least must be >= 0 m and < the length, 1 m, got 1");
  CHECK(refusal_of<DistanceJoint>({.b = {1}, .length = 1, .least = 0.5}) ==
        "DistanceJoint: least must be left out but for a rope, got 0.5");
}
