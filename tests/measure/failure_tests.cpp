// What no scene should show: seen where it happens, and nowhere else.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

using samples::spring;

/// Of a run of `seconds` at 60 Hz.
List<Failure> failures_of(const Scene& scene, double seconds, int sweeps) {
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = sweeps});
  FailureWatch watch(snapshot(world));
  for (int step = 1; step <= 60 * seconds; ++step) {
    world.step(solver);
    const Snapshot now = snapshot(world);
    watch.see(now, step / 60.0);
    watch.see(overlaps(now), now, step / 60.0);
  }
  return watch.failures();
}

/// A box of `mass` [kg] on one of 1 kg.
Scene heavy_on_light(double mass) {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 1});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 1.5}, .mass = mass});
  return scene;
}

/// Links of 0.5 m that hang from the ground at one end, level at first.
/// Nothing takes back what ten sweeps leave open.
Scene level_chain(int links) {
  Scene scene({.stabilization = {.policy = StabilizationPolicy::none}});
  samples::add_chain(scene, links, {.shapes = {box(0.5, 0.2)}, .position = {0.25, 0}}, {0.5, 0});
  return scene;
}

/// A box of 1 m over one that cannot move, as far above it as `gap` [m] says.
Snapshot box_over_box(double gap) {
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {box(4, 2)}, .position = {0, -1}});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + gap}});
  return snapshot(World<double>(scene));
}

}  // namespace

TEST_CASE("a scene in which nothing was removed has the floors that it had") {
  FailureWatch watch(box_over_box(0));
  const Snapshot fallen = box_over_box(-5);  // below the floor, which is 2 m thick
  watch.scene_changed(fallen);               // by an impulse, say
  watch.see(fallen, 1);
  REQUIRE(watch.failures().size() == 1);
  CHECK(watch.failures()[0].kind == FailureKind::fell_out);
}

TEST_CASE("a body that is in another by a quarter of the thinner one goes through it") {
  const auto seen = [](double gap) {
    FailureWatch watch(box_over_box(0));
    const Snapshot now = box_over_box(gap);
    watch.see(overlaps(now), now, 1);
    return watch.failures();
  };
  CHECK(seen(-0.24).empty());
  const List<Failure> failures = seen(-0.26);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::went_through);
  CHECK(failures[0].a == BodyId{1});
  CHECK(failures[0].b == BodyId{2});
  CHECK(failures[0].distance == doctest::Approx(0.26).epsilon(1e-12));
  CHECK(failure_text(failures[0], PerBody<std::string>{"ground", "floor", "box"}) ==
        "box is 0.26 m deep in floor after 1 s, more than a quarter of the thinner one");
  CHECK(failure_text(failures[0]) ==
        "body 2 is 0.26 m deep in body 1 after 1 s, more than a quarter of the thinner one");
}

TEST_CASE("a wall is as thick as it is along the normal of the contact, however it is turned") {
  // A disc of 1 m goes 0.3 m deep into a wall of 1 m, which may be 0.25 m deep; and into a line, where its
  // own half metre counts.
  for (const double angle : {0.0, 0.01, 0.3, pi / 4, 2.0}) {
    const auto seen = [angle](const Shape<double>& wall, double middle, double radius) {
      const Vec2<double> out = Rotation<double>(angle) * Vec2<double>(1, 0);
      const auto disc_at = [&](double distance) {
        Scene scene;
        scene.add({.type = BodyType::static_body, .shapes = {moved(wall, {0, 0}, angle)}});
        scene.add({.shapes = {circle(radius)}, .position = distance * out});
        return snapshot(World<double>(scene));
      };
      FailureWatch watch(disc_at(middle + 1));
      const Snapshot now = disc_at(middle);
      watch.see(overlaps(now), now, 1);
      return watch.failures();
    };
    const Polygon<double> wall = box(1, 20);
    CHECK(seen(wall, 0.5 + 1 - 0.24, 1).empty());
    REQUIRE(seen(wall, 0.5 + 1 - 0.26, 1).size() == 1);
    CHECK(seen(wall, 0.5 + 1 - 0.26, 1)[0].distance == doctest::Approx(0.26).epsilon(1e-9));
    const Segment<double> line = segment({0, -10}, {0, 10});
    CHECK(seen(line, 0.5 - 0.24, 0.5).empty());
    CHECK(seen(line, 0.5 - 0.26, 0.5).size() == 1);
  }
}

TEST_CASE("a ball that jumps through a chain from behind, and lands on it, fails at nothing") {
  Scene scene;
  scene.add_ground({.half_width = 5});
  scene.add({.type = BodyType::static_body, .shapes = {chain({{2, 2}, {-2, 2}})}});
  scene.add({.shapes = {circle(0.3)}, .position = {0, 0.3}, .velocity = {0, 9}});
  CHECK(failures_of(scene, 3, 10).empty());
}

TEST_CASE("what is behind a wall of two sides in one step has gone through it") {
  const auto ball_at = [](double x) {
    Scene scene;
    scene.add({.type = BodyType::static_body, .shapes = {box(0.1, 5)}});
    scene.add({.shapes = {circle(0.3)}, .position = {x, 0}});
    return snapshot(World<double>(scene));
  };
  FailureWatch watch(ball_at(-0.38));
  const Snapshot now = ball_at(0.2);
  watch.see(overlaps(now), now, 1);
  REQUIRE(watch.failures().size() == 1);
  CHECK(watch.failures()[0].distance == doctest::Approx(0.15).epsilon(1e-12));
}

TEST_CASE("a body that had a floor falls out of the scene below all that cannot be moved") {
  const auto seen = [](double from, double to) {
    FailureWatch watch(box_over_box(from));
    watch.see(box_over_box(to), 2);
    return watch.failures();
  };
  CHECK(seen(0.5, -2.9).empty());  // its upper side is 0.1 m above the lower side of the floor
  const List<Failure> failures = seen(0.5, -3.1);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::fell_out);
  CHECK(failure_text(failures[0]) == "body 2 has fallen out of the scene after 2 s");
  CHECK(seen(-4, -9).empty());  // it began below
}

TEST_CASE("what slides off the end of a line has fallen out of the scene") {
  Scene scene;
  scene.add(
      {.type = BodyType::static_body, .shapes = {segment({-5, 0}, {5, 0})}, .material = {.friction = 0}});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {5, 0}, .material = {.friction = 0}});
  CHECK(failures_of(scene, 1, 10).empty());  // it comes to the end
  const List<Failure> failures = failures_of(scene, 3, 10);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::fell_out);
}

TEST_CASE("1 t presses 1 kg into the ground under ten sweeps, and 1 kg does not") {
  const List<Failure> failures = failures_of(heavy_on_light(1000), 1, 10);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::went_through);
  CHECK(failures_of(heavy_on_light(1), 1, 10).empty());
}

TEST_CASE("a level chain of 200 links comes apart under ten sweeps, and one of five does not") {
  const List<Failure> failures = failures_of(level_chain(200), 2, 10);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::came_apart);
  CHECK(failures[0].joint == "revolute");
  CHECK(failures_of(level_chain(5), 2, 10).empty());
}

TEST_CASE("what never had a floor, or feels no gravity, may go anywhere") {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body, .shapes = {box(4, 2)}, .position = {0, -1}});
  scene.add({.shapes = {circle(0.5)}, .position = {5, 1}, .velocity = {0, -10}});
  CHECK(failures_of(scene, 2, 10).empty());
  Scene beside;
  beside.add({.type = BodyType::static_body, .shapes = {box(4, 2)}, .position = {0, -1}});
  beside.add({.shapes = {circle(0.5)}, .position = {5, 1}});
  CHECK(failures_of(beside, 2, 10).empty());
}

TEST_CASE("a rise of energy by a quarter of its scale comes from nowhere, and is told once") {
  FailureWatch watch(box_over_box(0));
  watch.see_gain(0.25, 1);
  CHECK(watch.failures().empty());
  watch.see_gain(0.5, 2);
  watch.see_gain(3, 3);
  REQUIRE(watch.failures().size() == 1);
  CHECK(watch.failures()[0].kind == FailureKind::gained_energy);
  CHECK(failure_text(watch.failures()[0]) == "energy came from nowhere: 50 % of its scale after 2 s");
}

TEST_CASE(
    "motors, bodies that move by themselves and events that switch motors on drive a scene; springs do not") {
  const auto pinned = [](const RevoluteJoint::Spec& joint, BodyType type, double speed) {
    Scene scene;
    scene.add({.shapes = {box(1, 1)}});
    scene.add({.type = type, .shapes = {box(1, 1)}, .position = {3, 0}, .velocity = {speed, 0}});
    RevoluteJoint::Spec spec = joint;
    spec.b = {1};
    scene.join<RevoluteJoint>(spec);
    return scene;
  };
  CHECK_FALSE(is_driven(pinned({}, BodyType::dynamic, 1)));
  CHECK_FALSE(is_driven(pinned({}, BodyType::kinematic, 0)));
  CHECK(is_driven(pinned({}, BodyType::kinematic, 1)));
  CHECK_FALSE(
      is_driven(pinned({.motor = RevoluteJoint::Motor{.speed = 0, .max_torque = 1}}, BodyType::dynamic, 0)));
  CHECK(
      is_driven(pinned({.motor = RevoluteJoint::Motor{.speed = 2, .max_torque = 1}}, BodyType::dynamic, 0)));
  Scene switched = pinned({}, BodyType::dynamic, 0);
  switched.add({.time = 1, .action = RemoveJoint{{0}}});
  CHECK_FALSE(is_driven(switched));
  switched.add({.time = 0.5, .action = SwitchMotor{{0}, JointMotor{.speed = 2, .max_force = 1}}});
  CHECK(is_driven(switched));
  Scene on_spring = pinned({}, BodyType::dynamic, 0);
  samples::hang(on_spring, {1}, {0, 1}, spring(-1, SwingSoftness{.frequency = 1}));
  CHECK_FALSE(is_driven(on_spring));
}

TEST_CASE(
    "a joint whose error never halves for a second has stayed off, and one that is taken back has not") {
  // The box is 2 m long: an error counts from 0.1 m on.
  const auto ended = [](double length, StabilizationPolicy policy, double seconds) {
    Scene scene({.gravity = {0, 0}, .stabilization = {.policy = policy}});
    scene.add({.shapes = {box(2, 2)}, .position = {0, -3}});
    scene.join<DistanceJoint>({.a = ground, .b = {1}, .anchor_b = {0, -3}, .length = length});
    World<double> world(scene);
    SequentialImpulse<double> solver({.iterations = 10});
    FailureWatch watch(snapshot(world));
    const int steps = static_cast<int>(60 * seconds);
    for (int step = 1; step <= steps; ++step) {
      world.step(solver);
      watch.see(snapshot(world), step / 60.0);
    }
    watch.end(snapshot(world), steps / 60.0);
    return watch.failures();
  };
  using enum StabilizationPolicy;
  CHECK(ended(2.5, baumgarte, 2).empty());
  CHECK(ended(2.95, none, 2).empty());
  CHECK(ended(2.5, none, 0.9).empty());
  const List<Failure> failures = ended(2.5, none, 2);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::stayed_off);
  CHECK(failures[0].since == 0);
  CHECK(failures[0].distance == doctest::Approx(0.5).epsilon(1e-9));
  CHECK(failure_text(failures[0], PerBody<std::string>{"ground", "box"}) ==
        "rod joint of ground and box ends 0.5 m off, as it was from 0 s on");
}
