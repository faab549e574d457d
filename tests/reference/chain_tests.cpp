// Chains in two engines: the same side, and the same smooth corners.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

BodySpec chain_body(const List<Vec2<double>>& points, const ChainEnds& ends = {}) {
  return {.type = BodyType::static_body, .shapes = {chain(points, ends)}, .material = {.friction = 0}};
}

}  // namespace

TEST_CASE("a box slides over the links of a chain at its speed in both engines") {
  Scene scene;
  List<Vec2<double>> points;
  for (int i = 20; i >= -2; --i) points.push_back({0.5 * i, 0});
  scene.add(chain_body(points));
  const BodyId box_id = scene.add(
      {.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {3, 0}, .material = {.friction = 0}});
  Engines engines(scene);
  engines.step(120);
  CHECK(body(snapshot(engines.cairn), box_id).velocity.x() == doctest::Approx(3).epsilon(1e-12));
  // Box2D computes in float, in 120 steps.
  CHECK(body(engines.box2d.snapshot(), box_id).velocity.x() ==
        doctest::Approx(3).epsilon(120 * float_rounding));
}

TEST_CASE(
    "a closed chain that runs clockwise is a room in both engines, with a contact on each of two walls") {
  Scene scene({.gravity = {10, -10}});
  scene.add(chain_body({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}, {.closed = true}));
  const BodyId ball = scene.add({.shapes = {circle(0.2)}, .position = {0, 0}, .material = {.friction = 0}});
  Engines engines(scene);
  engines.step(240);
  for (const Snapshot& seen : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
    // In the corner at the right below, but for the slop and Box2D's skin.
    CHECK((body(seen, ball).pose.position - Vec2<double>(0.8, -0.8)).norm() < 2 * (box2d_skin + box2d_slop));
    REQUIRE(seen.contacts.size() == 2);
    for (const SnapshotContact& contact : seen.contacts) {
      CHECK(contact.a == BodyId{1});
      CHECK(std::abs(contact.normal.x() + contact.normal.y()) == doctest::Approx(1).epsilon(1e-5));
      CHECK(contact.normal.dot(Vec2<double>(-1, 1)) > 0);
    }
  }
}

TEST_CASE("a chain with links too short for Box2D is refused there") {
  Scene scene;
  scene.add(chain_body({{0.004, 0}, {0, 0}, {-1, 0}}));
  CHECK_THROWS_WITH_AS(
      Box2DWorld(scene, {}),
      "Box2DWorld: chain link length must be > 0.005 m, the shortest in Box2D 2.4.1, got 0.004",
      std::invalid_argument);
}

}  // namespace cairn::reference_tests
