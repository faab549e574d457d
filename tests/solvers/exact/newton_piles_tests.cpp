// Newton's method on piles: what rests is solved once, whatever moves beside it.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;

TEST_CASE("a pile at rest is solved once: no contact changes sides by what is left over") {
  for (const int base : {2, 5, 10, 15}) {
    CAPTURE(base);
    World<double> world(samples::pyramid({.base = base}));
    NewtonSolver<double> solver({.iterations = 50, .tolerance = 1e-6});
    CHECK(world.step(solver).solve.converged);
    for (int step = 1; step < 100; ++step) CHECK(world.step(solver).solve.iterations == 0);
  }
}

TEST_CASE("a ball that rolls over a pile at rest moves no contact of the pile to its other side") {
  // Its rows change a little in each step, and so does the answer; as rigid as rows begin at rest, that
  // little took ten systems in each.
  Scene scene = samples::pyramid({.base = 10});
  scene.add(
      {.shapes = {circle(0.1)}, .position = {-4.9, 1.1}, .velocity = {0.05, 0}, .angular_velocity = -0.5});
  World<double> world(scene);
  NewtonSolver<double> solver({.iterations = 20, .tolerance = 1e-6});
  int steps_with_systems = 0;
  for (int step = 0; step < 100; ++step) {
    const StepReport report = world.step(solver);
    CHECK(report.unfinished == 0);
    steps_with_systems += report.solve.iterations > 0;
  }
  CHECK(steps_with_systems <= 10);
}

TEST_CASE("a large pile at rest stays at its answer, whichever way it was found") {
  // What is left over of each step grew from step to step where the next one began as rigid as the one that
  // had failed: six systems a step, and no end of it. Systems are counted by rows and rounded up, so that the
  // pendulum's are one a step.
  Scene scene = samples::pyramid({.base = 28});
  scene.set_settings({.contact_search = ContactSearch::when_moved});
  const BodyId bob = scene.add({.shapes = {box(1, 1)}, .position = {502, 20}});
  scene.join<RevoluteJoint>({.a = ground, .b = bob, .anchor = {500, 20}});
  World<double> world(scene);
  NewtonSolver<double> solver({.iterations = 50, .tolerance = 1e-6});
  int systems = 0;
  const int steps = 100;
  for (int step = 0; step < steps; ++step) {
    const StepReport report = world.step(solver);
    CHECK(report.unfinished == 0);
    if (step > 0) systems += report.solve.iterations;
  }
  CHECK(systems <= 2 * steps);
}
