// What falls, and has nothing to land on.
#include "testing.hpp"

using namespace cairn;

TEST_CASE("what has nothing to land on falls for ever, unless a joint or a lift holds it") {
  const auto fallen = [](double seconds, bool is_held, BodyType below, bool ends_are_stated) {
    Scene scene;
    scene.add({.shapes = {circle(0.5)}, .position = {0, 3}});
    scene.add({.type = below, .shapes = {box(1, 1)}, .position = {50, -900}});
    if (is_held) scene.join<DistanceJoint>({.a = ground, .b = {1}, .anchor_b = {0, 3}});
    World<double> world(scene);
    FailureWatch watch(snapshot(world), ends_are_stated);
    Snapshot later = snapshot(world);
    later.bodies[BodyId{1}].pose.position.y() -= 5 * seconds * seconds;
    watch.see(later, seconds);
    return watch.failures();
  };
  using enum BodyType;
  // A hundred of its lengths of 1 m: at 4.6 s, and at 14.2 s where a body stands still 903.5 m lower.
  CHECK(fallen(4, false, dynamic, false).empty());
  CHECK(fallen(15, false, static_body, false).size() == 1);  // that far below the other one
  CHECK(fallen(13.9, false, static_body, false).empty());
  CHECK(fallen(10, false, kinematic, false).empty());
  CHECK(fallen(15, true, static_body, false).empty());
  CHECK(fallen(15, false, static_body, true).empty());
}

TEST_CASE("a body begins below the ground only where the ground was to stop it") {
  const auto begins = [](double y, double x, bool is_held, bool has_shelf, std::uint32_t collides_with) {
    Scene scene;
    scene.add_ground({.half_width = 8});
    scene.add({.shapes = {box(1, 1)}, .position = {x, y}, .filter = {.collides_with = collides_with}});
    if (has_shelf) scene.add({.type = BodyType::static_body, .shapes = {box(20, 1)}, .position = {0, -9}});
    if (is_held) scene.join<RevoluteJoint>({.a = ground, .b = {1}, .anchor = {x, y}});
    return FailureWatch(snapshot(World<double>(scene))).failures();
  };
  const List<Failure> failures = begins(-4.5, 0, false, false, ~0u);
  REQUIRE(failures.size() == 1);
  CHECK(failures[0].kind == FailureKind::began_below);
  CHECK(failures[0].distance == doctest::Approx(4).epsilon(1e-12));
  CHECK(failure_text(failures[0], PerBody<std::string>{"ground", "box"}) ==
        "box begins 4 m below the top of the ground, with nothing to land on");
  CHECK(begins(0.5, 0, false, false, ~0u).empty());
  CHECK(begins(-4.5, 20, false, false, ~0u).empty());  // beside it
  CHECK(begins(-4.5, 0, true, false, ~0u).empty());
  CHECK(begins(-4.5, 0, false, true, ~0u).empty());
  CHECK(begins(-4.5, 0, false, false, 0).empty());
}
