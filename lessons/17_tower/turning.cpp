// Boxes that turn: a leaning stack falls over, under PGS with the whole A, PGS with a sparse A, and SI.
#include "lesson.hpp"

namespace cairn::tower {

namespace {

constexpr int steps = 120;

/// Five boxes, each 0.3 m to the right of the one below: they fall over, hit the ground and roll on.
Scene leaning_scene() {
  Scene scene({.gravity = {0, -10}, .dt = 0.02, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  for (int i = 0; i < 5; ++i)
    scene.add(
        {.shapes = {box(1, 1)}, .position = {0.3 * i, 0.5 + i}, .mass = 1, .material = {.friction = 0.5}});
  return scene;
}

Snapshot fallen(Solver<double>& solver, TurningRun& run) {
  World<double> world(leaning_scene());
  for (int k = 0; k < steps; ++k) {
    if (world.step(solver).not_finite)
      throw Diverged("lesson17: the stack under " + solver.name() + " blew up");
    const Snapshot now = snapshot(world);
    for (const SnapshotBody& body : now.bodies) run.turned = std::max(run.turned, std::abs(body.pose.angle));
  }
  return snapshot(world);
}

}  // namespace

TurningRun run_turning() {
  TurningRun run;
  const SolverSettings ten{.iterations = 10};
  SequentialImpulse<double> si(ten);
  ProjectedGaussSeidel<double> pgs(ten);
  SparseProjectedGaussSeidel<double> sparse(ten);
  const Snapshot by_si = fallen(si, run), by_pgs = fallen(pgs, run), by_sparse = fallen(sparse, run);
  for (const Snapshot* other : {&by_pgs, &by_sparse}) {
    for (const BodyId body : by_si.bodies.indices()) {
      const Pose<double>&here = by_si.bodies[body].pose, &there = other->bodies[body].pose;
      run.apart =
          std::max({run.apart, (here.position - there.position).norm(), std::abs(here.angle - there.angle)});
    }
  }
  return run;
}

void print_turning(Lesson& lesson, const TurningRun& run) {
  lesson.print(fmt::format(
      "Boxes that turn: five in a leaning stack fall over, by up to {:.0f}° in {} steps of ten sweeps.",
      run.turned * 180 / pi, steps));
  lesson.print(fmt::format("SI, PGS and PGS with a sparse A end at most {:.1e} (m, rad) apart.", run.apart));
}

void check_turning(Lesson& lesson, const TurningRun& run) {
  lesson.check_that("a stack that falls over: it turns by half a radian and more", run.turned > 0.5,
                    fmt::format("{:.2f}", run.turned));
  // Impacts and corners may multiply roundings of 1e-16 by a few powers of ten, not by ten.
  lesson.check_small("boxes that turn: SI, PGS and sparse PGS end in the same places (m, rad)", run.apart,
                     1e-9);
}

}  // namespace cairn::tower
