// Both engines tell what they did in the same words: masses, contacts, impulses, joints.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

constexpr double mass = 3;  // [kg]
constexpr double g = 10;    // [m/s^2]

/// Relative error of a sum of impulses: a few roundings a sweep, over the last sweeps that matter.
constexpr double impulse_tolerance = 100 * float_rounding;

/// Box2D no longer corrects a position where a fifth of the error is lost in rounding: 2.5e-6 m at 10 m.
constexpr double settled = 1e-5;  // [m]

double total_normal(const Snapshot& snapshot) {
  double sum = 0;
  for (const SnapshotContact& contact : snapshot.contacts) sum += contact.normal_impulse;
  return sum;
}

double total_friction(const Snapshot& snapshot) {
  double sum = 0;
  for (const SnapshotContact& contact : snapshot.contacts) sum += contact.friction_impulse;
  return sum;
}

TEST_CASE("masses, inertias, centres of mass and poses are Cairn's in Box2D, to the precision of a float") {
  Scene scene;
  scene.add({.shapes = {polygon({{0, 0}, {2, 0}, {0, 1}})}, .position = {1, 2}, .angle = 0.3, .density = 2});
  scene.add({.shapes = {circle(0.5, {1, 0}), box(1, 2)}, .position = {-3, 2}, .mass = 7});
  scene.add({.shapes = {box(1, 1)}, .position = {-6, 0}, .inertia = 5});
  scene.add({.shapes = {box(1, 1)}, .position = {6, 0}, .fixed_rotation = true});
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}, .position = {9, 0}});
  scene.remove(scene.add({.shapes = {box(1, 1)}, .position = {12, 0}}));
  const Snapshot cairn = snapshot(World<double>(scene));
  const Snapshot box2d = Box2DWorld(scene).snapshot();
  REQUIRE(cairn.bodies.size() == box2d.bodies.size());
  for (const BodyId body : cairn.bodies.indices()) {
    CAPTURE(body.index);
    const double tolerance = 4 * float_rounding;
    CHECK(box2d.bodies[body].type == cairn.bodies[body].type);
    CHECK(box2d.bodies[body].removed == cairn.bodies[body].removed);
    CHECK(box2d.bodies[body].mass == doctest::Approx(cairn.bodies[body].mass).epsilon(tolerance));
    CHECK(box2d.bodies[body].inertia == doctest::Approx(cairn.bodies[body].inertia).epsilon(tolerance));
    CHECK((box2d.bodies[body].pose.position - cairn.bodies[body].pose.position).norm() < 10 * tolerance);
    CHECK(std::abs(box2d.bodies[body].pose.angle - cairn.bodies[body].pose.angle) < tolerance);
    CHECK(box2d.bodies[body].shapes.size() == cairn.bodies[body].shapes.size());
  }
}

TEST_CASE("a box at rest is carried by two contacts that add up to m g dt, from the ground to the box") {
  Scene scene;
  scene.add_ground({.material = {.friction = 0.4}});
  const BodyId resting =
      scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = mass, .material = {.friction = 0.9}});
  Engines engines(scene, {.velocity_iterations = 100});  // the first frame converges, and the box stays
  engines.step();
  CHECK(snapshot(engines.cairn).contacts.front().is_new);
  CHECK(engines.box2d.snapshot().contacts.front().is_new);
  engines.step(119);
  for (const Snapshot& seen : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
    CHECK(seen.step == 120);
    CHECK(seen.time == doctest::Approx(2));
    CHECK(seen.dt == scene.settings().dt);
    REQUIRE(seen.contacts.size() == 2);
    CHECK(total_normal(seen) == doctest::Approx(mass * g * seen.dt).epsilon(impulse_tolerance));
    for (const SnapshotContact& contact : seen.contacts) {
      CHECK(contact.a == ground);
      CHECK(contact.b == resting);
      CHECK((contact.normal - Vec2<double>(0, 1)).norm() < float_rounding);
      CHECK(contact.friction == doctest::Approx(std::sqrt(0.4 * 0.9)).epsilon(4 * float_rounding));
      CHECK_FALSE(contact.is_new);
      // Where the step found the two surfaces, without any skins: half way between them.
      const double bottom = body(seen, resting).pose.position.y() - 0.5;
      CHECK(std::abs(contact.separation - bottom) < settled);
      CHECK(std::abs(contact.position.y() - bottom / 2) < settled);
      // At a corner, where Box2D may add the skins.
      CHECK(std::abs(contact.position.x()) > 0.5 - settled);
      CHECK(std::abs(contact.position.x()) < 0.5 + 2 * box2d_skin + settled);
    }
  }
  // Cairn lets it rest where it was put, Box2D a gap above, which it reaches a fifth of the way each step.
  CHECK(std::abs(body(snapshot(engines.cairn), resting).pose.position.y() - 0.5) < 1e-9);
  CHECK(std::abs(body(engines.box2d.snapshot(), resting).pose.position.y() - 0.5 - box2d_polygon_gap) <
        settled);
}

TEST_CASE("friction on a box that slides to the right is -mu m g dt, whichever body comes first") {
  enum class Order { box_last, box_first };
  using Creation = Box2DSettings::Creation;
  for (const Order order : {Order::box_last, Order::box_first}) {
    for (const Creation creation : {Creation::first_first, Creation::last_first}) {
      const BodySpec sliding = {.shapes = {box(1, 1)},
                                .position = {0, 0.5},
                                .velocity = {5, 0},
                                .mass = mass,
                                .material = {.friction = 0.3}};
      const BodySpec floor = {.type = BodyType::static_body,
                              .shapes = {box(40, 1)},
                              .position = {0, -0.5},
                              .material = {.friction = 0.3}};
      Scene scene;
      scene.add(order == Order::box_first ? sliding : floor);
      scene.add(order == Order::box_first ? floor : sliding);
      Engines engines(scene, {.velocity_iterations = 50, .creation = creation});
      engines.step(80);  // Box2D lifts the box out of the skins first, then it slides evenly
      const double up = order == Order::box_first ? -1 : 1;  // the way of the normal, from body 1 to body 2
      for (const Snapshot& seen : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
        REQUIRE(seen.contacts.size() == 2);
        CHECK(seen.contacts[0].a == BodyId{1});
        CHECK(seen.contacts[0].b == BodyId{2});
        CHECK(seen.contacts[0].normal.y() == doctest::Approx(up));
        // On b, along the normal turned by -90 degrees: the two signs change together when a and b do.
        CHECK(total_friction(seen) == doctest::Approx(-0.3 * mass * g * seen.dt).epsilon(impulse_tolerance));
        CHECK(total_normal(seen) == doctest::Approx(mass * g * seen.dt).epsilon(impulse_tolerance));
      }
    }
  }
}

TEST_CASE("a rod and a pin that carry a weight each give it m g dt upwards in both engines") {
  Scene scene;
  const BodyId on_rod = scene.add({.shapes = {box(1, 1)}, .position = {0, -2}, .mass = mass});
  const BodyId on_pin = scene.add({.shapes = {box(1, 1)}, .position = {5, -2}, .mass = mass});
  scene.join<DistanceJoint>({.a = ground, .b = on_rod, .anchor_a = {0, 0}, .anchor_b = {0, -1.5}});
  scene.join<RevoluteJoint>({.a = on_pin, .b = ground, .anchor = {5, 0}});
  Engines engines(scene);
  engines.step(60);
  for (const Snapshot& seen : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
    REQUIRE(seen.joints.size() == 2);
    const double weight = mass * g * seen.dt;
    CHECK(seen.joints[0].name == "rod");
    CHECK(seen.joints[0].a == ground);
    CHECK(seen.joints[0].b == on_rod);
    CHECK((seen.joints[0].anchor_b - Vec2<double>(0, -1.5)).norm() < settled);
    CHECK(seen.joints[0].drift < settled);
    CHECK((seen.joints[0].impulse - Vec2<double>(0, weight)).norm() < impulse_tolerance);
    CHECK(seen.joints[1].name == "revolute");
    CHECK((seen.joints[1].anchor_a - Vec2<double>(5, 0)).norm() < settled);
    CHECK((seen.joints[1].impulse - Vec2<double>(0, -weight)).norm() < impulse_tolerance);  // on the ground
  }
}

TEST_CASE("bodies that a joint holds together do not collide, in both engines") {
  Scene scene;
  const BodyId first = scene.add({.shapes = {box(1, 1)}});
  const BodyId second = scene.add({.shapes = {box(1, 1)}, .position = {0.5, 0}});
  scene.join<RevoluteJoint>({.a = first, .b = second, .anchor = {0.25, 0}});
  Engines engines(scene);
  engines.step(10);
  CHECK(snapshot(engines.cairn).contacts.empty());
  CHECK(engines.box2d.snapshot().contacts.empty());
}

TEST_CASE("a disc and a segment touch in both engines, and the separation is that of the shapes") {
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {segment({-5, 0}, {5, 0})}});
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}, .mass = mass});
  Engines engines(scene);
  engines.step(120);
  for (const Snapshot& seen : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
    REQUIRE(seen.contacts.size() == 1);
    CHECK(total_normal(seen) == doctest::Approx(mass * g * seen.dt).epsilon(impulse_tolerance));
    CHECK(seen.contacts[0].normal.y() == doctest::Approx(1));
  }
  CHECK(std::abs(snapshot(engines.cairn).contacts[0].separation) < 1e-9);
  CHECK(std::abs(engines.box2d.snapshot().contacts[0].separation - (box2d_skin - box2d_slop)) < settled);
}

TEST_CASE("a box that Box2D has put to sleep keeps its contacts, and stays awake where sleeping is off") {
  Scene scene;
  scene.add_ground();
  const BodyId resting = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = mass});
  Box2DWorld sleepy(scene, {.sleeping = true});
  Box2DWorld awake(scene);
  for (int step = 0; step < 120; ++step) {
    sleepy.step();
    awake.step();
    // Half a second of rest is what it takes.
    if (step == 15) CHECK(sleepy.is_awake(resting));
  }
  CHECK_FALSE(sleepy.is_awake(resting));
  CHECK(awake.is_awake(resting));
  const Snapshot seen = sleepy.snapshot();
  CHECK(seen.contacts.size() == 2);
  CHECK_FALSE(seen.contacts.front().is_new);
  CHECK_FALSE(seen.bodies[resting].awake);
  CHECK(awake.snapshot().bodies[resting].awake);
  CHECK(total_normal(seen) == doctest::Approx(mass * g * seen.dt).epsilon(impulse_tolerance));
}

}  // namespace

}  // namespace cairn::reference_tests
