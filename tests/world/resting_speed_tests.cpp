// What is too slow for numbers rests.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

TEST_CASE_TEMPLATE("what has no energy that a normal number could hold rests after a step", Real, float,
                   double) {
  const double slowest = std::sqrt(static_cast<double>(std::numeric_limits<Real>::min()));
  for (const double share : {0.5, 2.0}) {
    Scene scene({.gravity = {0, 0}});
    const BodyId body = scene.add({.shapes = {circle(0.5)}, .velocity = {share * slowest, 0}});
    World<Real> world = world_after<Real>(std::move(scene), 1);
    CHECK((world.bodies().velocity[body].x() == 0) == (share < 1));
  }
}
