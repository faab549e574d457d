// The soft pull of a hand on a body.
#include "constraints/drag_joint.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE("a dragged body swings to its target as implicit Euler says, on each axis by itself") {
  const double frequency = 2, damping_ratio = 0.4, mass = 3;
  Scene scene({.gravity = {0, 0}});
  const BodyId body = scene.add(disc({1, -2}, mass));
  scene.join<DragJoint>({.body = body,
                         .anchor = {1, -2},
                         .target = {0.5, 1},
                         .softness = SwingSoftness{frequency, damping_ratio},
                         .max_force = 1e9});
  World world(scene);
  const double omega = 2 * pi * frequency;
  Vec2<double> offset(0.5, -3), velocity(0, 0);  // from the target
  for (int step = 0; step < 10; ++step) {
    step_often(world, 1, 1);
    // v' = (v - h w^2 x) / (1 + 2 zeta w h + h^2 w^2), x' = x + h v'
    const double h = joint_dt;
    velocity =
        (velocity - h * omega * omega * offset) / (1 + 2 * damping_ratio * omega * h + h * h * omega * omega);
    offset += h * velocity;
    const Vec2<double> found = world.bodies().velocity[{1}].head<2>();
    CHECK((found - velocity).norm() <= 1e-12);  // the rounding of a few steps at up to 20 m/s
  }
}

TEST_CASE("a drag is never stronger than max_force on an axis") {
  const double mass = 2, limit = 6;
  Scene scene({.gravity = {0, 0}});
  const BodyId body = scene.add(disc({0, 0}, mass));
  scene.join<DragJoint>({.body = body, .anchor = {0, 0}, .target = {1000, -500}, .max_force = limit});
  World world(scene);
  step_often(world, 30, 1);
  const double speed = limit / mass * 30 * joint_dt;
  CHECK(world.bodies().velocity[{1}].x() == doctest::Approx(speed).epsilon(1e-13));
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(-speed).epsilon(1e-13));
}

TEST_CASE("a drag off the middle turns its body, holds it against gravity, and never counts as drift") {
  Scene scene;
  const double mass = 1, stiffness = 200;
  BodySpec swinging = disc({0, 0}, mass, 0.1);
  swinging.angular_damping = 5;  // nothing else would bring the pendulum to rest
  const BodyId body = scene.add(swinging);
  scene.join<DragJoint>({.body = body,
                         .anchor = {0.5, 0},
                         .target = {0.5, 0},
                         .softness = SpringSoftness{stiffness, 20},
                         .max_force = 100});
  World world(scene);
  step_often(world, 1);
  CHECK(world.bodies().velocity[{1}].z() > 0);  // the middle sinks, the anchor is held
  step_often(world, 3000);
  // At rest the body hangs under its anchor, the spring longer by m g / k. In 50 s the swings have lost more
  // than 1 - 1e-6 of their size: the pendulum takes e^-1 of it off in a second or less.
  const Pose<double>& pose = world.bodies().pose[{1}];
  CHECK(pose.world({0.5, 0}).y() == doctest::Approx(-mass * joint_gravity / stiffness).epsilon(1e-6));
  CHECK(pose.angle == doctest::Approx(pi / 2).epsilon(1e-6));
  CHECK(snapshot(world).joints[0].drift == 0);
}

TEST_CASE("a drag of the ground, to nowhere, or without a force is refused") {
  CHECK(refusal_of<DragJoint>({.body = ground}) ==
        "DragJoint: body must be the id of a body of this scene, and not the ground, got 0");
  CHECK(refusal_of<DragJoint>({.body = {2}}) ==
        "DragJoint: body must be the id of a body of this scene, and not the ground, got 2");
  CHECK(refusal_of<DragJoint>({.body = {1}, .target = {0, std::nan("")}}) ==
        "DragJoint: target must be finite numbers of m, got (0, nan)");
  CHECK(refusal_of<DragJoint>({.body = {1}, .anchor = {std::nan(""), 0}}) ==
        "DragJoint: anchor must be finite numbers of m, got (nan, 0)");
  CHECK(refusal_of<DragJoint>({.body = {1}, .softness = SwingSoftness{.frequency = 0}}) ==
        "DragJoint: softness frequency must be from 1e-6 to 1e6 Hz, got 0");
  CHECK(refusal_of<DragJoint>({.body = {1}, .max_force = 0}) ==
        "DragJoint: max_force must be a finite number > 0 N, got 0");
}
