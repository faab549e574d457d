// Surfaces that run like belts.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double mu = 0.5;

/// A box of 2 kg on something static of surface speed `belt`, with a surface speed of its own, mu being 0.5.
Scene box_on_belt(double belt, double own = 0, const SceneSettings& settings = {}) {
  Scene scene(settings);
  scene.add_ground({.material = {.friction = mu, .surface_speed = belt}});
  scene.add({.shapes = {box(1, 0.5)},
             .position = {0, 0.25},
             .mass = 2,
             .material = {.friction = mu, .surface_speed = own}});
  return scene;
}

Vec3<double> velocity_after(const Scene& scene, int steps, Solver<double>&& solver) {
  World<double> world(scene);
  take_steps(world, solver, steps);
  return velocity_of(world, {1});
}

// Sums of 60 steps, each solved to a few roundings.
const double sums = 1e-9;

}  // namespace

TEST_CASE("a belt takes along what lies on it, by its friction and up to its speed, under every solver") {
  for (const FrictionRows rows : {FrictionRows::per_point, FrictionRows::per_manifold}) {
    for (const StabilizationPolicy policy :
         {StabilizationPolicy::relaxed, StabilizationPolicy::soft, StabilizationPolicy::baumgarte,
          StabilizationPolicy::split_impulse}) {
      CAPTURE(static_cast<int>(policy));
      const Scene scene = box_on_belt(3, 0, {.stabilization = {.policy = policy}, .friction_rows = rows});
      // mu g t after 30 steps; after 60, the belt's own speed.
      const auto check = [&](Solver<double>&& solver) {
        CHECK(velocity_after(scene, 30, std::move(solver)).x() == doctest::Approx(2.5).epsilon(sums));
        CHECK(velocity_after(scene, 60, std::move(solver)).x() == doctest::Approx(3).epsilon(sums));
      };
      check(SequentialImpulse<double>({.iterations = 60}));
      check(SparseProjectedGaussSeidel<double>({.iterations = 60}));
      check(NewtonSolver<double>({.iterations = 50, .tolerance = 1e-12}));
    }
  }
}

TEST_CASE("a belt runs for lanes, too, to their precision") {
  const Scene scene = box_on_belt(3);
  // Lanes count in float what changes in a sweep.
  CHECK(velocity_after(scene, 30, WideSequentialImpulse<double>({.iterations = 60})).x() ==
        doctest::Approx(2.5).epsilon(1e-5));
  CHECK(velocity_after(scene, 60, WideSequentialImpulse<double>({.iterations = 60})).x() ==
        doctest::Approx(3).epsilon(1e-5));
}

TEST_CASE("a surface runs to the right where it faces up, whichever of the two bodies has it") {
  const auto velocity = [](const Scene& scene) {
    return velocity_after(scene, 90, SequentialImpulse<double>({.iterations = 60})).x();
  };
  CHECK(velocity(box_on_belt(-2)) == doctest::Approx(-2).epsilon(sums));
  // A tracked vehicle: its lower side faces down, runs to the left, and drives it to the right.
  CHECK(velocity(box_on_belt(0, 2)) == doctest::Approx(2).epsilon(sums));
  CHECK(velocity(box_on_belt(-2, 2)) == doctest::Approx(0).epsilon(sums));
  CHECK(velocity(box_on_belt(1, 2)) == doctest::Approx(3).epsilon(sums));
}

TEST_CASE("a ball on a belt rolls off it: a third of the belt's speed, and the rest in its turning") {
  Scene scene;
  scene.add_ground({.material = {.friction = mu, .surface_speed = 3}});
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}, .mass = 2, .material = {.friction = mu}});
  const Vec3<double> v = velocity_after(scene, 60, SequentialImpulse<double>({.iterations = 60}));
  // Friction F for a time: m v = F t, I w = F t r with I = m r^2 / 2, until v + w r = s: v = s / 3.
  CHECK(v.x() == doctest::Approx(1).epsilon(sums));
  CHECK(v.z() == doctest::Approx(2 / 0.5).epsilon(sums));
}

TEST_CASE("what a belt pushes against a wall gets the friction that slides under it") {
  Scene scene = box_on_belt(3);
  const BodyId wall = scene.add({.type = BodyType::static_body,
                                 .shapes = {box(0.2, 2)},
                                 .position = {0.6, 1},
                                 .material = {.friction = 0}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 200});
  take_steps(world, solver, 60);
  CHECK(std::abs(velocity_of(world, {1}).x()) <= sums);
  const Snapshot now = snapshot(world);
  CHECK(normal_impulse_between(now, wall, {1}) / now.dt == doctest::Approx(mu * 2 * 10).epsilon(1e-6));
}

TEST_CASE("surfaces that run are explained and counted as a drive, and cost nothing where there are none") {
  const Plan still = make_plan(box_on_belt(0)), running = make_plan(box_on_belt(1));
  CHECK_FALSE(still.extras.surface_speed);
  CHECK(running.extras.surface_speed);
  CHECK(explain(still).find("surfaces") == std::string::npos);
  CHECK(explain(running).find("surfaces") != std::string::npos);
  CHECK(is_driven(box_on_belt(1)));
  CHECK_FALSE(is_driven(box_on_belt(0)));
  CHECK(World<double>(box_on_belt(0)).velocity_problem().surface_speed.empty());
  Scene slippery;
  slippery.add_ground({.material = {.friction = 0, .surface_speed = 1}});
  slippery.add({.shapes = {circle(1)}, .position = {0, 1}});
  CHECK_FALSE(make_plan(slippery).extras.surface_speed);
}

TEST_CASE("a body may be given another surface speed while a world runs") {
  World<double> world(box_on_belt(0));
  SequentialImpulse<double> solver({.iterations = 60});
  take_steps(world, solver, 10);
  CHECK(std::abs(velocity_of(world, {1}).x()) <= sums);
  world.edit([](Scene& scene) {
    BodySpec spec = scene.bodies()[{1}].spec;
    spec.material.surface_speed = 1;
    scene.change({1}, spec);
  });
  take_steps(world, solver, 60);
  CHECK(velocity_of(world, {1}).x() == doctest::Approx(1).epsilon(sums));
}
