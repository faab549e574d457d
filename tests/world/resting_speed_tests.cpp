// What is too slow for numbers rests.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

TEST_CASE_TEMPLATE("what has no energy that a normal number could hold rests after a step", Real, float,
                   double) {
  const double slowest = std::sqrt(static_cast<double>(std::numeric_limits<Real>::min()));
  for (const double share : {0.5, 2.0}) {
    Scene scene({.gravity = {0, 0}});
    const BodyId body = scene.add({.shapes = {circle(0.5)}, .velocity = {share * slowest, 0}});
    World<Real> world(std::move(scene));
    SequentialImpulse<Real> solver;
    world.step(solver);
    CHECK((world.bodies().velocity[body].x() == 0) == (share < 1));
  }
}
