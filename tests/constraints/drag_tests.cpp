// The soft pull of a hand on a body.
#include <cairn/constraints/stabilization.hpp>
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double hand_frequency = 2, hand_damping = 0.4;  // [Hz], damping ratio
constexpr double hand_omega = 2 * pi * hand_frequency;    // [rad/s]

/// Where a body [m] is after `seconds`, that began at rest at 0 when its target set out from there at
/// `speed`: in every step the scene is edited to hold what the world has come to, and the same grip with its
/// next target.
double dragged_along(double dt, int steps, double speed) {
  Scene scene({.gravity = {0, 0}, .dt = dt});
  const BodyId body = scene.add(disc({0, 0}, 3));
  const DragJoint grip({.body = body, .softness = SwingSoftness{hand_frequency, hand_damping}},
                       two_at_origin);
  JointId hand = scene.join(std::make_shared<const DragJoint>(grip));
  for (int step = 1; step <= steps; ++step) {
    scene.remove(hand);
    hand = scene.join(std::make_shared<const DragJoint>(grip.moved_to({speed * dt * step, 0})));
    World world(scene);
    step_often(world, 1, 1);
    scene.place(body, world.bodies().pose[body], world.bodies().velocity[body]);
  }
  return scene.bodies()[body].pose.position.x();
}

}  // namespace

TEST_CASE("a dragged body swings to its target as a damped spring does, on each axis by itself") {
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
  HandSwing x{.x = 0.5, .omega = omega, .zeta = damping_ratio};  // from the target
  HandSwing y{.x = -3, .omega = omega, .zeta = damping_ratio};
  for (int step = 0; step < 10; ++step) {
    step_often(world, 1, 1);
    x.step(joint_dt);
    y.step(joint_dt);
    const Vec2<double> found = world.bodies().velocity[{1}].head<2>();
    CHECK((found - Vec2<double>(x.v, y.v)).norm() <= 1e-12);  // the rounding of a few steps at up to 20 m/s
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
  swinging.damping.angular = 5;  // nothing else would bring the pendulum to rest
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

TEST_CASE_TEMPLATE("a body hangs below the target of a drag by as much as its spring gives way", Real, float,
                   double) {
  Scene scene;
  const BodyId body = scene.add(disc({0, 0}, 3));
  scene.join<DragJoint>({.body = body});
  World<Real> world(scene);
  step_often(world, 600,
             10);  // 5 Hz at a damping ratio of 0.7: the swing has lost exp(-0.7 w 10 s) of itself
  const double sag = spring_sag({.frequency = 5}, joint_dt, joint_gravity);
  const double tolerance = 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  // gravity, dt and w are those of double
  CHECK(static_cast<double>(world.bodies().pose[body].position.y()) ==
        doctest::Approx(-sag).epsilon(std::max(tolerance, 1e-14)));
}

TEST_CASE("a body follows the target of a drag as a damped oscillator, to the first order in dt") {
  // y = x - (u t - 2 zeta u / w) is the free oscillator that begins at 2 zeta u / w with the velocity -u.
  const double u = 3, t = 0.25;
  const double lag = 2 * hand_damping * u / hand_omega;
  const double damped = hand_omega * std::sqrt(1 - hand_damping * hand_damping);
  const double decay = hand_damping * hand_omega;
  const double swing =
      std::exp(-decay * t) * (lag * std::cos(damped * t) + (decay * lag - u) / damped * std::sin(damped * t));
  const double exact = u * t - lag + swing;
  const auto error = [&](int steps) { return dragged_along(t / steps, steps, u) - exact; };
  const double coarse = error(64), fine = error(128);
  CHECK(std::abs(coarse) < 0.1 * lag);
  CHECK(coarse / fine == doctest::Approx(2).epsilon(0.1));
  // Once the swing is over, the spring sees the body that far behind where the target has already come, and
  // the body then moves on by h u, of which a spring in the middle of the step sees the share a - b.
  const double s = std::pow(hand_omega * joint_dt, 2), seen = s * s / (1 + s * s);
  CHECK(u * 5 - dragged_along(joint_dt, 300, u) ==
        doctest::Approx(lag - (1 - seen) * joint_dt * u).epsilon(1e-9));
}

TEST_CASE("a drag of twenty times its weight does not pull a box through the wall that it touches") {
  for (const double size : {0.1, 1.0, 10.0}) {
    for (const double off : {-0.4, 0.0, 0.4}) {  // of its side, above its middle
      CAPTURE(size);
      CAPTURE(off);
      Scene scene;
      scene.add_ground();
      const double thickness = 0.02 * size;
      scene.add({.type = BodyType::static_body,
                 .shapes = {box(thickness, 40 * size)},
                 .position = {size / 2 + thickness / 2, 0}});
      const BodyId body = scene.add({.shapes = {box(size, size)}, .position = {0, size / 2}});
      scene.join<DragJoint>({.body = body,
                             .anchor = {0, (0.5 + off) * size},
                             .target = {20 * size, 5 * size},
                             .max_force = 20 * scene.bodies()[body].mass * joint_gravity});
      World world(scene);
      step_often(world, 150, 10);
      const Vec2<double>& position = world.bodies().pose[body].position;
      CHECK(position.x() < size / 2);
      CHECK(position.y() > 2 * size);  // it is drawn up along the wall
    }
  }
}

TEST_CASE("a grip that is moved to another target keeps its body and its anchor") {
  const PerBody<Pose<double>> start = {{}, {{1, 2}, 0.5}};
  const DragJoint drag({.body = {1}, .anchor = {3, 1}, .target = {4, 4}}, start);
  const DragJoint moved = drag.moved_to({-1, 7});
  CHECK(moved.attachments()[0].anchor == Vec2<double>(-1, 7));
  CHECK(moved.attachments()[1].body == BodyId{1});
  CHECK(moved.attachments()[1].anchor == drag.attachments()[1].anchor);
  CHECK(drag.attachments()[0].anchor == Vec2<double>(4, 4));
  CHECK_THROWS_WITH_AS(drag.moved_to({0, std::nan("")}),
                       "DragJoint::moved_to: target must be finite numbers of m, got (0, nan)",
                       std::invalid_argument);
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
