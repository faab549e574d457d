// Joints whose forces turn with what they hold: light links under heavy loads, and what swings on a rope.
// pins.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "measure/energy.hpp"
#include "measure/violation.hpp"
#include "solvers/exact/newton_solver.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

struct Gaps {
  double worst = 0;  // [m] of a joint
  double gain = 0;   // [J] of energy above the start
};

Gaps gaps_of(const Scene& scene, Solver<double>& solver, double seconds) {
  World<double> world(scene);
  const double start = total_energy(snapshot(world));
  Gaps gaps;
  for (int step = 0; step < std::lround(60 * seconds); ++step) {
    world.step(solver);
    const Snapshot now = snapshot(world);
    gaps.worst = std::max(gaps.worst, worst_joint_drift(now));
    gaps.gain = std::max(gaps.gain, total_energy(now) - start);
  }
  return gaps;
}

/// Planks of 0.1 kg between two walls, each on a rod of 0.2 m from the one before; one of them is heavier.
Scene plank_bridge(double heavy, int substeps) {
  Scene scene({.substeps = substeps});
  BodyId before = ground;
  Vec2<double> end = {0, 0};
  for (int i = 0; i < 6; ++i) {
    const BodyId plank = scene.add({.shapes = {box(0.8, 0.1)},
                                    .position = {0.6 + i, 0},
                                    .mass = i == 2 ? heavy : 0.1,
                                    .collides_with = 0});
    scene.join<DistanceJoint>(
        {.a = before, .b = plank, .anchor_a = end, .anchor_b = Vec2<double>(0.2 + i, 0)});
    end = {1.0 + i, 0};
    before = plank;
  }
  scene.join<DistanceJoint>(
      {.a = before, .b = ground, .anchor_a = end, .anchor_b = end + Vec2<double>(0.2, 0)});
  return scene;
}

/// Links of 1 kg on pins, level, between two walls.
Scene chain_between_walls(int links, int substeps) {
  Scene scene({.substeps = substeps});
  BodyId before = ground;
  for (int i = 0; i <= links; ++i) {
    const BodyId next =
        i < links ? scene.add({.shapes = {box(0.5, 0.1)}, .position = {0.25 + 0.5 * i, 0}, .mass = 1})
                  : ground;
    scene.join<RevoluteJoint>({.a = before, .b = next, .anchor = {0.5 * i, 0}});
    before = next;
  }
  return scene;
}

}  // namespace

TEST_CASE("light planks carry a heavy one under an exact solver, with one substep and with four") {
  for (const auto& bridge : {std::pair(1.0, 1), {1.0, 4}, {10.0, 1}, {10.0, 4}, {100.0, 4}}) {
    const double heavy = bridge.first;
    const int substeps = bridge.second;
    CAPTURE(heavy);
    CAPTURE(substeps);
    NewtonSolver<double> newton({.iterations = 20});
    const Gaps gaps = gaps_of(plank_bridge(heavy, substeps), newton, 4);
    CHECK(gaps.worst <= 0.025);             // a quarter of a plank's thickness: past that a joint has failed
    CHECK(gaps.gain <= 0.01 * heavy * 10);  // [J] as of a centimetre of its fall
  }
}

TEST_CASE("the more exactly a level chain is solved, the better its pins hold") {
  for (const int links : {20, 40, 80}) {
    for (const int substeps : {1, 4}) {
      CAPTURE(links);
      CAPTURE(substeps);
      SequentialImpulse<double> ten({.iterations = 10}), hundred({.iterations = 100});
      NewtonSolver<double> newton({.iterations = 20});
      const Scene scene = chain_between_walls(links, substeps);
      const double by_ten = gaps_of(scene, ten, 2).worst, by_hundred = gaps_of(scene, hundred, 2).worst;
      const double exactly = gaps_of(scene, newton, 2).worst;
      CHECK(exactly <= by_hundred);
      CHECK(by_hundred <= by_ten);
      CHECK(exactly <= 0.001);
    }
  }
}

TEST_CASE(
    "a body takes part with its mass, or with what its joint's stiffness makes of it where that is more") {
  for (const double length : {0.001, 1.0}) {
    CAPTURE(length);
    Scene scene;
    const BodyId bob = scene.add({.position = {0, -length}, .mass = 2, .fixed_rotation = true});
    scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_b = {0, -length}});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    world.step(solver);
    world.set_velocity(bob, {3, 0, 0});
    const double h = world.dt(), tension = 2 * 10;  // [N] its weight
    // At rest in the line of the rod: K of an end is 2 T / L.
    const double mass = std::max(2.0, h * h * 2 * tension / length);
    const VelocityProblem<double> problem = world.velocity_problem();
    CHECK(1 / problem.inverse_mass[bob].x() == doctest::Approx(mass).epsilon(1e-12));
    CHECK(problem.velocity[bob].x() == doctest::Approx(3 * 2 / mass).epsilon(1e-12));  // the same momentum
    if (length == 1) CHECK(problem.inverse_mass[bob].x() == 0.5);
  }
}

TEST_CASE("a pendulum on a rope that stays taut swings as far as one on a rod") {
  const double angle = std::numbers::pi / 3, w_dt = std::sqrt(10.0) / 240;
  for (const auto kind : {DistanceJoint::Kind::rod, DistanceJoint::Kind::rope}) {
    Scene scene({.substeps = 4});
    const Vec2<double> place = {std::sin(angle), -std::cos(angle)};
    const BodyId bob = scene.add({.shapes = {circle(0.05)}, .position = place, .mass = 1});
    scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_b = place, .kind = kind});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    const double start = total_energy(snapshot(world)), swing = 10 * (1 - std::cos(angle));
    double worst = 0;
    for (int step = 0; step < 60 * 20; ++step) {
      world.step(solver);
      worst = std::max(worst, std::abs(total_energy(snapshot(world)) - start));
    }
    // Semi-implicit Euler shows w dt / 2 of a swing's energy and takes it back.
    CHECK(worst <= w_dt * swing);
  }
}
