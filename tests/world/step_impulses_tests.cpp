// What contacts and joints give in a whole step, held against the momentum that bodies got.
#include "testing.hpp"

#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A ball of 2 kg that falls on the ground and rebounds, and one of 3 kg on a rod that swings.
Scene ball_and_pendulum(int substeps, ContactSearch search) {
  Scene scene({.substeps = substeps, .contact_search = search});
  scene.add_ground({.material = {.friction = 0.4}});
  scene.add({.shapes = {circle(0.5)},
             .position = {0, 0.8},
             .velocity = {3, 0},
             .mass = 2,
             .material = {.restitution = 0.5}});
  const BodyId bob = scene.add({.shapes = {circle(0.25)}, .position = {8, 5}, .mass = 3});
  scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_a = {6, 5}, .anchor_b = {8, 5}});
  return scene;
}

Vec2<double> given_by_contacts(const Snapshot& now, BodyId body) {
  Vec2<double> sum = {0, 0};
  for (const SnapshotContact& contact : now.contacts) {
    const Vec2<double> along(contact.normal.y(), -contact.normal.x());
    const Vec2<double> push = contact.normal_impulse * contact.normal + contact.friction_impulse * along;
    if (contact.b == body) sum += push;
    if (contact.a == body) sum -= push;
  }
  return sum;
}

}  // namespace

TEST_CASE("a step gives bodies the momentum that they gain, beside gravity, however many substeps it has") {
  for (const ContactSearch search : {ContactSearch::every_substep, ContactSearch::every_step}) {
    for (const int substeps : {1, 4, 16}) {
      CAPTURE(substeps);
      World<double> world(ball_and_pendulum(substeps, search));
      SequentialImpulse<double> solver({.iterations = 30});
      StepImpulses impulses;
      double largest = 0;
      for (int step = 0; step < 120; ++step) {
        const PerBody<Vec3<double>> before = world.bodies().velocity;
        world.step(solver, impulses);
        const Snapshot now = impulses.in(snapshot(world));
        const double dt = world.scene().settings().dt;
        CHECK(now.dt == doctest::Approx(dt).epsilon(16 * std::numeric_limits<double>::epsilon()));
        const Vec2<double> weight(0, -10 * dt);  // [m/s]
        const auto gain = [&](BodyId body, double mass) -> Vec2<double> {
          return mass * ((now.bodies[body].velocity - before[body]).head<2>() - weight);
        };
        // Each substep rounds a velocity of some 10 m/s of some kilograms a few times.
        const double rounding = substeps * 200 * std::numeric_limits<double>::epsilon();
        CHECK((given_by_contacts(now, {1}) - gain({1}, 2)).norm() <= rounding);
        CHECK((now.joints[0].impulse - gain({2}, 3)).norm() <= rounding);
        largest = std::max(largest, given_by_contacts(now, {1}).norm());
      }
      CHECK(largest > 2);  // [N s]: it fell by 0.3 m, and turned round
    }
  }
}

TEST_CASE("what rests is pushed by its weight times the step") {
  for (const int substeps : {1, 4, 16}) {
    Scene scene({.substeps = substeps});
    scene.add_ground();
    scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 6});
    World<double> world(scene);
    SequentialImpulse<double> solver({.iterations = 100});
    StepImpulses impulses;
    for (int step = 0; step < 60; ++step) world.step(solver, impulses);
    const Snapshot now = impulses.in(snapshot(world));
    REQUIRE(now.contacts.size() == 2);
    // Sweeps halve the error of two points a box apart at least.
    CHECK(given_by_contacts(now, {1}).y() == doctest::Approx(6 * 10 / 60.0).epsilon(1e-9));
    CHECK(normal_impulse_between(now, ground, {1}) / now.dt == doctest::Approx(60).epsilon(1e-9));
  }
}

TEST_CASE("a contact that is gone before the step ends is among those of the step") {
  // The ball is 1 mm above the ground and comes down at 8 m/s: a 16th of a step later it has turned.
  Scene scene({.gravity = {0, 0}, .substeps = 16});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)},
             .position = {0, 0.501},
             .velocity = {0, -8},
             .mass = 2,
             .material = {.restitution = 1}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 10});
  StepImpulses impulses;
  world.step(solver, impulses);
  const Snapshot end = snapshot(world), whole = impulses.in(end);
  CHECK(end.contacts.empty());
  REQUIRE(whole.contacts.size() == 1);
  CHECK(whole.contacts[0].normal_impulse == doctest::Approx(2 * 2 * 8).epsilon(1e-12));
  CHECK(whole.contacts[0].is_new);
}

TEST_CASE("a world steps to the same bits whether its impulses are added up or not") {
  Scene scene = samples::pyramid({.base = 6}, {.substeps = 4, .contact_search = ContactSearch::every_step});
  World<double> watched(scene), alone(scene);
  WideSequentialImpulse<double> one({.iterations = 5}), other({.iterations = 5});
  StepImpulses impulses;
  for (int step = 0; step < 60; ++step) {
    watched.step(one, impulses);
    alone.step(other);
  }
  CHECK(same_motion(watched, alone));
}
