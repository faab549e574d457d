// What is slow because it is driven slowly, and must not fall asleep; and a pile that must.
#include "geometry/random_shapes.hpp"
#include <cairn/samples/samples.hpp>
#include "sleeping_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE("a motor keeps its bodies awake, however slow it is, and a brake does not") {
  for (const double speed : {0.02, 1e-4, 1e-7, 0.0}) {
    CAPTURE(speed);
    Scene scene({.gravity = {0, 0}, .sleeping = usual_sleeping});
    const BodyId hand = scene.add({.shapes = {box(1, 0.1)}, .position = {0.5, 0}});
    scene.join<RevoluteJoint>({.a = ground,
                               .b = hand,
                               .anchor = {0, 0},
                               .motor = RevoluteJoint::Motor{.speed = speed, .max_torque = 100}});
    World<double> world(scene);
    sleep_steps(world, 600, 10);
    CHECK(world.is_awake(hand) == (speed > 0));
    CHECK(world.bodies().pose[hand].angle == doctest::Approx(10 * speed).epsilon(1e-3));
  }
}

TEST_CASE("what nothing unmovable holds falls, however weak gravity is, alone and together") {
  for (const double gravity : {0.05, 1e-3, 1e-6}) {
    CAPTURE(gravity);
    Scene scene({.gravity = {0, -gravity}, .sleeping = usual_sleeping});
    const BodyId alone = scene.add({.shapes = {circle(0.2)}, .position = {0, 2}});
    const BodyId lower = scene.add({.shapes = {box(1, 1)}, .position = {5, 2}});
    const BodyId upper = scene.add({.shapes = {box(1, 1)}, .position = {5, 3}});
    const BodyId weightless = scene.add({.shapes = {circle(0.2)}, .position = {9, 2}, .gravity_scale = 0});
    World<double> world(scene);
    const int steps = 480;
    sleep_steps(world, steps, 10);
    const double fall = gravity / 3600 * steps * (steps + 1) / 2;
    for (const BodyId body : {alone, lower, upper}) {
      CHECK(world.is_awake(body));
      const double from = body == upper ? 3 : 2;
      CHECK(from - world.bodies().pose[body].position.y() == doctest::Approx(fall).epsilon(1e-6));
    }
    CHECK_FALSE(world.is_awake(weightless));
  }
}

TEST_CASE("a pole that stands nearly upright falls over, and one that hangs sleeps") {
  for (const double angle : {1e-3, pi}) {
    CAPTURE(angle);
    Scene scene({.sleeping = usual_sleeping});
    const Vec2<double> middle(-0.5 * std::sin(angle), 0.5 * std::cos(angle));
    const BodyId pole = scene.add({.shapes = {box(0.1, 1)}, .position = middle, .angle = angle});
    scene.join<RevoluteJoint>({.a = ground, .b = pole, .anchor = {0, 0}});
    World<double> world(scene);
    // angle cosh(w t) with w^2 = m g l / I = 3 g / (2 L) = 15: past 1 rad after 2 s.
    sleep_steps(world, 120, 10);
    CHECK(world.is_awake(pole) == (angle < 1));
    if (angle < 1) CHECK(world.bodies().pose[pole].angle > 1);
  }
}

TEST_CASE("a strongly damped spring draws its load home before it sleeps") {
  Scene scene({.gravity = {0, 0}, .sleeping = usual_sleeping});
  const double stiffness = 4, damping = 100;
  const BodyId sledge = scene.add({.shapes = {box(0.4, 0.4)}, .position = {1, 0}, .mass = 1});
  samples::hang(scene, sledge, {-3, 0},
                samples::spring(3, SpringSoftness{.stiffness = stiffness, .damping = damping}));
  World<double> world(scene);
  sleep_steps(world, 1200, 1);
  const double rate = (damping - std::sqrt(damping * damping - 4 * stiffness)) / 2;  // [1/s], about k / c
  CHECK(world.is_awake(sledge));
  CHECK(world.bodies().pose[sledge].position.x() == doctest::Approx(std::exp(-20 * rate)).epsilon(0.01));
  REQUIRE(steps_until_asleep(world, 12000) < 12000);
  // It sleeps once it goes two thousandths of its size in half a second: x rate = 2e-3 * 0.2 sqrt(2) / 0.5.
  CHECK(world.bodies().pose[sledge].position.x() <= 2e-3 * 0.2 * std::sqrt(2.0) / 0.5 / rate);
}

TEST_CASE("a pile of sixty boxes or discs sleeps within two seconds of coming to rest") {
  for (const double side : {0.05, 0.5}) {
    for (const bool round : {false, true}) {
      CAPTURE(side);
      CAPTURE(round);
      Scene scene({.sleeping = usual_sleeping});
      scene.add_ground();
      for (const double x : {-5.5, 5.5})
        scene.add(
            {.type = BodyType::static_body, .shapes = {box(side, 40 * side)}, .position = {x * side, 0}});
      test::Random random(3);
      const Shape<double> shape = round ? Shape<double>(circle(side / 2)) : Shape<double>(box(side, side));
      for (int i = 0; i < 60; ++i)
        scene.add({.shapes = {shape},
                   .position = {(1.3 * (i % 5) - 2.6) * side, (1 + 1.2 * (i / 5)) * side},
                   .angle = random.uniform(-0.2, 0.2)});
      World<double> world(scene);
      NewtonSolver<double> solver({.iterations = 20});
      int last_moving = 0, asleep = 0;
      for (int step = 1; step <= 2400 && asleep == 0; ++step) {
        if (world.step(solver).awake.bodies == 0) asleep = step;
        for (const Vec3<double>& v : world.bodies().velocity)
          if (v.head<2>().norm() + side * std::abs(v.z()) > 0.005 * side) last_moving = step;
      }
      CAPTURE(last_moving);
      CHECK(asleep > 0);
      CHECK(asleep - last_moving <= 120);
    }
  }
}
