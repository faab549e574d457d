// Penetration, drift, cones and gaps of states written by hand, where the answer is known.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Boxes of 1 m at the given places, dynamic or static.
Snapshot boxes_at(const List<Vec2<double>>& places, BodyType type = BodyType::dynamic) {
  Snapshot snapshot;
  for (const Vec2<double>& place : places) {
    snapshot.bodies.push_back({.type = type, .pose = {place, 0}, .shapes = {box(1, 1)}});
  }
  return snapshot;
}

const double overlap_rounding = 8 * std::numeric_limits<double>::epsilon();  // of numbers below 2 m

}  // namespace

TEST_CASE("the penetration of two overlapping boxes is their overlap along the shorter way out") {
  CHECK(worst_penetration(boxes_at({{0, 0}, {0.25, 0.9}})) == doctest::Approx(0.1).epsilon(overlap_rounding));
  CHECK(worst_penetration(boxes_at({{0, 0}, {0.75, 0.1}})) ==
        doctest::Approx(0.25).epsilon(overlap_rounding));
}

TEST_CASE("the worst of several overlaps counts, and boxes that are apart do not") {
  CHECK(worst_penetration(boxes_at({{0, 0}, {0, 0.9}, {0, 1.7}})) ==
        doctest::Approx(0.2).epsilon(2 * overlap_rounding));
  CHECK(worst_penetration(boxes_at({{0, 0}, {0, 1.5}, {3, 0}})) == 0);
  CHECK(worst_penetration(boxes_at({})) == 0);
}

TEST_CASE("the deepest overlap says whose it is") {
  const Overlap deepest = deepest_overlap(boxes_at({{0, 0}, {0, 0.9}, {0, 1.7}}));
  CHECK(deepest.depth == doctest::Approx(0.2).epsilon(2 * overlap_rounding));
  CHECK(std::min(deepest.a, deepest.b) == BodyId{1});
  CHECK(std::max(deepest.a, deepest.b) == BodyId{2});
}

TEST_CASE("what goes through the ground unseen is a body that is joined to it") {
  Snapshot snapshot = boxes_at({{0, 0}, {0, 0.75}, {0, 0.5}});
  CHECK(deepest_in_ground(snapshot).depth == 0);
  snapshot.apart = {{{0}, {1}}, {{1}, {2}}};
  CHECK(deepest_in_ground(snapshot).depth == doctest::Approx(0.25).epsilon(overlap_rounding));
  CHECK(deepest_in_ground(snapshot).b == BodyId{1});
}

TEST_CASE("bodies of which none is dynamic, and bodies that a joint keeps apart, do not penetrate") {
  CHECK(worst_penetration(boxes_at({{0, 0}, {0, 0.5}}, BodyType::static_body)) == 0);
  Snapshot joined = boxes_at({{0, 0}, {0, 0.5}});
  joined.apart.push_back({{0}, {1}});
  CHECK(worst_penetration(joined) == 0);
}

TEST_CASE("sensors, and bodies whose categories exclude each other, do not penetrate") {
  Snapshot sensing = boxes_at({{0, 0}, {0, 0.5}});
  sensing.bodies[{1}].sensor = true;
  CHECK(worst_penetration(sensing) == 0);
  Snapshot sorted = boxes_at({{0, 0}, {0, 0.5}});
  sorted.bodies[{0}].filter.category = 2;
  sorted.bodies[{1}].filter.collides_with = 1;
  CHECK(worst_penetration(sorted) == 0);
  sorted.bodies[{1}].filter.collides_with = 3;
  CHECK(worst_penetration(sorted) == doctest::Approx(0.5).epsilon(overlap_rounding));
}

TEST_CASE("the drift of a rod is its stretch, that of a pin the distance of its two points") {
  Scene scene({.gravity = {0, 0}, .stabilization = {.baumgarte = 0}});
  const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = {3, 4}});
  const BodyId bar = scene.add({.shapes = {box(1, 0.1)}, .position = {10, 0}});
  scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_b = {3, 4}, .length = 4.75});
  scene.join<RevoluteJoint>({.a = ground, .b = bar, .anchor = {10, 0}});
  World world(scene);
  CHECK(worst_joint_drift(snapshot(world)) == doctest::Approx(0.25).epsilon(4 * overlap_rounding));
  // Without stabilization, and without a single sweep, the pin is left behind at (3, 4) m/s for one step.
  world.set_velocity(bar, {3, 4, 0});
  take_steps(world, 1, 0);
  const Snapshot moved = snapshot(world);
  CHECK(moved.joints[1].drift == doctest::Approx(5.0 / 60).epsilon(1e-13));
  CHECK(worst_joint_drift(moved) == doctest::Approx(0.25).epsilon(4 * overlap_rounding));
  CHECK(worst_joint_drift(boxes_at({{0, 0}})) == 0);
}

TEST_CASE("a cone is violated by the friction above mu times the normal impulse, to either side") {
  Snapshot snapshot;
  CHECK(worst_cone_violation(snapshot) == 0);
  snapshot.contacts.push_back({.normal_impulse = 4, .friction_impulse = 1.5, .friction = 0.5});
  CHECK(worst_cone_violation(snapshot) == 0);
  snapshot.contacts.push_back({.normal_impulse = 4, .friction_impulse = -2.25, .friction = 0.5});
  CHECK(worst_cone_violation(snapshot) == 0.25);
}

TEST_CASE("the normal impulse between two bodies is summed over their contacts, whichever is named first") {
  Snapshot snapshot;
  snapshot.contacts.push_back({.a = {1}, .b = {2}, .normal_impulse = 3});
  snapshot.contacts.push_back({.a = {1}, .b = {2}, .normal_impulse = 4});
  snapshot.contacts.push_back({.a = {0}, .b = {2}, .normal_impulse = 16});
  CHECK(normal_impulse_between(snapshot, {1}, {2}) == 7);
  CHECK(normal_impulse_between(snapshot, {2}, {1}) == 7);
  CHECK(normal_impulse_between(snapshot, {2}, {0}) == 16);
  CHECK(normal_impulse_between(snapshot, {0}, {1}) == 0);
}

TEST_CASE("the velocity gap of two snapshots is their largest difference in any component") {
  Snapshot first = boxes_at({{0, 0}, {5, 0}});
  Snapshot second = first;
  second.bodies[{1}].velocity = {0.5, 0, -2};
  CHECK(largest_velocity_gap(first, second) == 2);
  CHECK(largest_velocity_gap(first, first) == 0);
  CHECK_THROWS_AS(largest_velocity_gap(first, boxes_at({{0, 0}})), std::invalid_argument);
}
