// Manifolds that last longer than a substep: what stays the same to the bit, and what differs by how much.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

namespace cairn {
namespace {

using namespace testing;

/// Boxes on each other, tilted, that slide and fall over; a disc that rolls.
Scene tumbling_scene(ContactSearch search, int substeps, double dt = 1.0 / 60) {
  Scene scene({.dt = dt, .substeps = substeps, .contact_search = search});
  scene.add_ground();
  for (int i = 0; i < 5; ++i) {
    scene.add({.shapes = {box(1, 0.6)}, .position = {0.25 * i, 0.4 + 0.65 * i}, .angle = 0.02 * i});
  }
  scene.add({.shapes = {circle(0.4)}, .position = {-2, 0.4}, .velocity = {1, 0}, .angular_velocity = -2.5});
  return scene;
}

Scene resting_pyramid(ContactSearch search, int substeps) {
  return samples::pyramid({.base = 5}, {.substeps = substeps, .contact_search = search});
}

/// [m] The farthest that a body stands apart in two worlds.
double farthest_apart(const World<double>& one, const World<double>& other) {
  double most = 0;
  for (const BodyId body : one.bodies().pose.indices()) {
    most = std::max(most, (one.bodies().pose[body].position - other.bodies().pose[body].position).norm());
  }
  return most;
}

}  // namespace

TEST_CASE("looking for contacts every step is looking every substep where a step has one") {
  CHECK(same_state(world_after(tumbling_scene(ContactSearch::every_step, 1), 120, 20),
                   world_after(tumbling_scene(ContactSearch::every_substep, 1), 120, 20)));
}

TEST_CASE("one search a step and one a substep differ by the second order of the step at least") {
  // From one state, and over one step: to the third order in positions.
  double before = 0;
  for (const double dt : {1.0 / 50, 1.0 / 100, 1.0 / 200}) {
    CAPTURE(dt);
    // Exactly solved, so that nothing but the search differs; rods and a disc that slide, turn and keep on
    // touching with what touches at first.
    const auto run = [&](ContactSearch search) {
      Scene scene({.dt = dt, .substeps = 4, .contact_search = search});
      scene.add_ground();
      scene.add({.shapes = {box(1, 0.2)},
                 .position = {0, 0.1 * std::cos(0.3) + 0.5 * std::sin(0.3)},
                 .angle = 0.3,
                 .velocity = {1, 0.4},
                 .angular_velocity = -0.8});
      scene.add({.shapes = {circle(0.5)}, .position = {3, 0.5}, .velocity = {2, 0}});
      World<double> world(std::move(scene));
      NewtonSolver<double> solver({.tolerance = 1e-13});
      world.step(solver);
      return world;
    };
    const double apart = farthest_apart(run(ContactSearch::every_step), run(ContactSearch::every_substep));
    if (before > 0) CHECK(apart < before / 3.5);  // a second order gives a quarter
    before = std::max(apart, 1e-15);              // below it is rounding
  }
}

TEST_CASE("a pyramid that rests stands as high whatever the search, and as still") {
  for (const int substeps : {1, 4}) {
    CAPTURE(substeps);
    const World<double> reference =
        world_after(resting_pyramid(ContactSearch::every_substep, substeps), 180, 20);
    for (const ContactSearch search : {ContactSearch::every_step, ContactSearch::when_moved}) {
      // Less than the slop of 5 mm, within which nothing says where a body stands.
      CHECK(farthest_apart(world_after(resting_pyramid(search, substeps), 180, 20), reference) < 0.001);
    }
  }
}

TEST_CASE("a copy of a world that keeps its manifolds goes on with the same bits") {
  World<double> world = world_after(tumbling_scene(ContactSearch::when_moved, 2), 40, 20);
  World<double> twin = world;
  take_steps(world, 40, 20);
  take_steps(twin, 40, 20);
  CHECK(same_state(world, twin));
}

TEST_CASE("the problem that a world tells of is the one that its next step solves, manifolds kept or not") {
  for (const ContactSearch search : every_search) {
    World<double> world = world_after(tumbling_scene(search, 1), 25, 20);
    const VelocityProblem<double> told = world.velocity_problem();
    take_steps(world, 1, 0);
    const VelocityProblem<double>& solved = world.last_step().problem;
    REQUIRE(told.row_count() == solved.row_count());
    CHECK(told.impulse == solved.impulse);
    for (int i = 0; i < told.row_count(); ++i) {
      // The second solve asks for no overlap back.
      CHECK(std::min(told.rows[i].bias, 0.0) == solved.rows[i].bias);
    }
  }
}

TEST_CASE("what arrives within a step is met in the substep in which it arrives") {
  // At 6 m/s a ball comes 0.1 m in a step and 0.025 m in a substep: it may sink in by that much, and no more.
  for (const ContactSearch search : {ContactSearch::every_substep, ContactSearch::every_step}) {
    Scene scene({.substeps = 4, .contact_search = search});
    scene.add_ground();
    const BodyId ball = scene.add({.shapes = {circle(0.2)}, .position = {0, 0.36}, .velocity = {0, -6}});
    const World<double> world = world_after(scene, 2);
    CHECK(pose_of(world, ball).position.y() > 0.2 - 0.026);
    CHECK(velocity_of(world, ball).y() > -0.5);
  }
}

}  // namespace cairn
