// What a step does when it would leave the numbers, or begin worse than from nothing.
#include <doctest/doctest.h>

#include <limits>

#include "constraints/revolute_joint.hpp"
#include "solvers/impulse_energy.hpp"
#include "solvers/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

const double guard_huge = std::numeric_limits<double>::max();

/// A disc in flight, and a body that the next step would throw out of the numbers.
Scene scene_with_runaway(int substeps, StabilizationPolicy policy) {
  Scene scene({.dt = 1, .substeps = substeps, .stabilization = {.policy = policy}});
  scene.add({.shapes = {circle(1)}, .position = {5, 0}, .velocity = {1, 0}});
  scene.add({.position = {0, 0.75 * guard_huge},
             .velocity = {0, 0.75 * guard_huge},
             .mass = 1,
             .fixed_rotation = true});
  return scene;
}

/// A box that has come to rest on the ground.
World<double> box_at_rest(bool watches) {
  Scene scene({.watches_warm_start = watches});
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 50});
  for (int step = 0; step < 60; ++step) world.step(solver);
  return world;
}

}  // namespace

TEST_CASE("a step that would leave the numbers moves nothing, names the body, and lets time go on") {
  for (const StabilizationPolicy policy : {StabilizationPolicy::none, StabilizationPolicy::baumgarte,
                                           StabilizationPolicy::soft, StabilizationPolicy::split_impulse}) {
    World<double> world(scene_with_runaway(1, policy));
    SequentialImpulse<double> solver;
    for (int step = 1; step <= 3; ++step) {
      const StepReport report = world.step(solver);
      CHECK(report.not_finite == BodyId{2});
      CHECK(world.bodies().pose[1].position == Vec2<double>(5, 0));
      CHECK(world.bodies().velocity[1] == Vec3<double>(1, 0, 0));
      CHECK(world.bodies().pose[2].position.y() == 0.75 * guard_huge);
      CHECK(world.time() == step);
      CHECK(world.steps() == step);
    }
    world.set_velocity({2}, {0, 0, 0});
    CHECK_FALSE(world.step(solver).not_finite.has_value());
    CHECK(world.bodies().pose[1].position.x() == 6);
  }
}

TEST_CASE("of a step with substeps those before the bad one are done") {
  World<double> world(scene_with_runaway(4, StabilizationPolicy::none));
  SequentialImpulse<double> solver;
  // 0.75 + 0.25 * 0.75 = 0.9375 of the largest number after one substep, 1.125 after two.
  CHECK(world.step(solver).not_finite == BodyId{2});
  CHECK(world.bodies().pose[1].position.x() == 5.25);
  CHECK(world.bodies().pose[2].position.y() == 0.9375 * guard_huge);
}

TEST_CASE("a body beyond the numbers of a scalar type, or no longer than their spacing there, is refused") {
  const auto make = [](double place, double speed) {
    Scene scene;
    scene.add({.shapes = {box(1, 1)}, .position = {place, 0}, .velocity = {0, speed}});
    return scene;
  };
  // A float has 24 bits: neighbours are 2^-23 of a power of two apart, and so 1 m from 2^23 m on.
  const double far = 8388608;
  CHECK_NOTHROW(World<float>(make(far - 1, 0)));
  CHECK_THROWS_AS(World<float>(make(far, 0)), std::invalid_argument);
  CHECK_NOTHROW(World<double>(make(far, 0)));
  CHECK_THROWS_AS(World<double>(make(far * 536870912, 0)), std::invalid_argument);  // 2^52
  CHECK_NOTHROW(World<float>(make(0, 1e38)));
  CHECK_THROWS_AS(World<float>(make(0, 1e39)), std::invalid_argument);
}

TEST_CASE("the energy of impulses is that of the bodies after them, beside what the rows ask for") {
  // One body of 2 kg, one row on its speed: D = p^2 / (2 m) + p (v - bias) + softness p^2 / 2.
  VelocityProblem<double> problem;
  problem.velocity = {{0, 0, 0}, {0, -3, 0}};
  problem.inverse_mass = {{0, 0, 0}, {0.5, 0.5, 1}};
  problem.rows.push_back({.a = ground, .b = {1}, .jacobian_b = {0, 1, 0}, .bias = 0.25, .softness = 0.125});
  problem.impulse = {4};
  std::vector<Vec3<double>> scratch;
  CHECK(impulse_energy(problem, scratch) == 4 * 4 * 0.25 + 4 * (-3 - 0.25) + 0.125 * 4 * 4 / 2);
  problem.impulse = {0};
  CHECK(impulse_energy(problem, scratch) == 0);
}

TEST_CASE("impulses that hold a box at rest are kept, and dropped once it leaves the ground by itself") {
  SequentialImpulse<double> no_sweeps({.iterations = 0});
  const double dt = 1.0 / 60, gravity = 10;
  World<double> resting = box_at_rest(true);
  CHECK(resting.step(no_sweeps).dropped_warm_starts == 0);
  CHECK(std::abs(resting.bodies().velocity[1].y()) < 1e-6);  // what 60 steps of 50 sweeps have left

  // Thrown up with 1 m/s, it needs no impulse; the last one, m g dt, would make it faster by g dt.
  for (const bool watches : {false, true}) {
    World<double> world = box_at_rest(watches);
    world.set_velocity({1}, {0, 1, 0});
    const StepReport report = world.step(no_sweeps);
    CHECK(report.dropped_warm_starts == (watches ? 1 : 0));
    const double expected = watches ? 1 - gravity * dt : 1;
    CHECK(world.bodies().velocity[1].y() == doctest::Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("the plan says that warm starts are watched, and watches none where there are none") {
  Scene scene({.watches_warm_start = true});
  CHECK(make_plan(scene).watches_warm_start);
  CHECK(explain(make_plan(scene)).find("unless they add energy") != std::string::npos);
  CHECK_FALSE(make_plan(Scene({.warm_start = false, .watches_warm_start = true})).watches_warm_start);
}

TEST_CASE("a body of a tenth of a millimetre may sink in by a share of itself, not by the slop") {
  const double size = 1e-4;  // [m]; the slop of 5 mm is 50 times as much
  Scene scene;
  scene.add_ground();
  const BodyId small = scene.add({.shapes = {box(size, size)}, .density = 1000});  // half in the ground
  World<double> world(scene);
  SequentialImpulse<double> solver;
  for (int step = 0; step < 120; ++step) {
    world.step(solver);
    world.set_velocity(small, {0, 0, 0});  // what Baumgarte leaves would throw it up
  }
  // A twentieth of it is left alone: every step takes a fifth of what is above that.
  const double depth = size / 2 - world.bodies().pose[1].position.y();
  CHECK(depth < 0.06 * size);
  CHECK(depth > -0.05 * size);
}
