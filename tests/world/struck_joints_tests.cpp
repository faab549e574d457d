// Joints that hold angles come back when they were struck: sweeps spread moments slowly, an exact solve at
// once.
#include <doctest/doctest.h>

#include <algorithm>

#include "constraints/revolute_joint.hpp"
#include "constraints/weld_joint.hpp"
#include "measure/violation.hpp"
#include "solvers/exact/newton_solver.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

enum class Held { by_limits, by_welds };

/// Six bars in a row from the ground to the right.
Scene pole(Held held) {
  Scene scene({.gravity = {0, 0}, .substeps = 4});
  BodyId before = ground;
  for (int i = 0; i < 6; ++i) {
    const BodyId bar =
        scene.add({.shapes = {box(1, 0.2)}, .position = {0.5 + i, 0}, .mass = 0.2, .collides_with = 0});
    if (held == Held::by_welds) {
      scene.join<WeldJoint>({.a = before, .b = bar, .anchor = {1.0 * i, 0}});
    } else {
      scene.join<RevoluteJoint>({.a = before, .b = bar, .anchor = {1.0 * i, 0}, .lower = 0, .upper = 0});
    }
    before = bar;
  }
  return scene;
}

}  // namespace

TEST_CASE(
    "a pole that is struck at its end is straight again within 0.3 s, on limits of no width and welds") {
  for (const Held held : {Held::by_limits, Held::by_welds}) {
    CAPTURE(static_cast<int>(held));
    World<double> world(pole(held));
    NewtonSolver<double> newton({.iterations = 20});
    world.step(newton);
    const double impulse = 2, arm = 0.5, mass = 0.2, inertia = mass * (1 + 0.04) / 12;
    world.set_velocity({6}, {0, impulse / mass, arm * impulse / inertia});
    double worst = 0;
    for (int step = 0; step < 18; ++step) {
      world.step(newton);
      worst = std::max(worst, worst_joint_drift(snapshot(world)));
    }
    CHECK(worst > 1e-4);  // [m, rad] else the blow was none
    // A share of 0.2 of an error goes in each of 72 substeps, 1e-7 of it is left; the blow itself ends in the
    // first.
    CHECK(worst_joint_drift(snapshot(world)) <= 1e-6 * worst);
  }
}
