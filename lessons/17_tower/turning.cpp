// Scenes that turn, under PGS with the whole A, PGS with a sparse A, and SI: a leaning stack, a pyramid under
// a ball, and a chain that whips into boxes.
#include "lesson.hpp"

namespace cairn::tower {

namespace {

constexpr int steps = 120;

Scene empty_scene() {
  Scene scene({.gravity = {0, -10}, .dt = 0.02, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  return scene;
}

void add_box(Scene& scene, const Vec2<double>& position) {
  scene.add({.shapes = {box(1, 1)}, .position = position, .mass = 1, .material = {.friction = 0.5}});
}

/// Five boxes, each 0.3 m to the right of the one below: they fall over, hit the ground and roll on.
Scene leaning_stack() {
  Scene scene = empty_scene();
  for (int i = 0; i < 5; ++i) add_box(scene, {0.3 * i, 0.5 + i});
  return scene;
}

/// A ball flies into six boxes.
Scene struck_pyramid() {
  Scene scene = empty_scene();
  for (int level = 0; level < 3; ++level)
    for (int i = 0; i < 3 - level; ++i) add_box(scene, {1.1 * (i + 0.5 * level), 0.5 + level});
  scene.add({.shapes = {circle(0.5)}, .position = {-4, 2}, .velocity = {12, 0}, .mass = 5});
  return scene;
}

/// Four links and a ball swing down into two boxes.
Scene whipping_chain() {
  Scene scene = empty_scene();
  BodyId above = ground;
  for (int i = 0; i < 5; ++i) {
    const bool is_ball = i == 4;
    const BodyId body = scene.add({.shapes = {is_ball ? Shape<double>(circle(0.4)) : box(1, 0.2)},
                                   .position = {i + (is_ball ? 0.4 : 0.5), 5},
                                   .mass = is_ball ? 4 : 1});
    scene.join<RevoluteJoint>({.a = above, .b = body, .anchor = {static_cast<double>(i), 5}});
    above = body;
  }
  for (int i = 0; i < 2; ++i) add_box(scene, {-1, 0.5 + i});
  return scene;
}

Snapshot ended(const Scene& scene, Solver<double>& solver, TurningRun& run) {
  World<double> world(scene);
  for (int k = 0; k < steps; ++k) {
    if (world.step(solver).not_finite)
      throw Diverged("lesson17: the " + run.name + " under " + solver.name() + " blew up");
    const Snapshot now = snapshot(world);
    for (const SnapshotBody& body : now.bodies) run.turned = std::max(run.turned, std::abs(body.pose.angle));
  }
  return snapshot(world);
}

TurningRun run_scene(const std::string& name, const Scene& scene) {
  TurningRun run{.name = name};
  const SolverSettings ten{.iterations = 10};
  SequentialImpulse<double> si(ten);
  ProjectedGaussSeidel<double> pgs(ten);
  SparseProjectedGaussSeidel<double> sparse(ten);
  const Snapshot by_si = ended(scene, si, run), by_pgs = ended(scene, pgs, run),
                 by_sparse = ended(scene, sparse, run);
  for (const Snapshot* other : {&by_pgs, &by_sparse}) {
    for (const BodyId body : by_si.bodies.indices()) {
      const Pose<double>&here = by_si.bodies[body].pose, &there = other->bodies[body].pose;
      run.apart =
          std::max({run.apart, (here.position - there.position).norm(), std::abs(here.angle - there.angle)});
    }
  }
  return run;
}

}  // namespace

List<TurningRun> run_turning() {
  return {run_scene("leaning stack", leaning_stack()), run_scene("struck pyramid", struck_pyramid()),
          run_scene("whipping chain", whipping_chain())};
}

void print_turning(Lesson& lesson, const List<TurningRun>& runs) {
  lesson.print(
      fmt::format("Scenes that turn, {} steps of ten sweeps: by how much, and how far apart SI, PGS and "
                  "PGS with a sparse A end.",
                  steps));
  for (const TurningRun& run : runs)
    lesson.print(
        fmt::format("  {:<16}{:>5.0f}°{:>12.1e} (m, rad)", run.name, run.turned * 180 / pi, run.apart));
}

void check_turning(Lesson& lesson, const List<TurningRun>& runs) {
  double turned = std::numeric_limits<double>::infinity(), apart = 0;
  for (const TurningRun& run : runs) {
    turned = std::min(turned, run.turned);
    apart = std::max(apart, run.apart);
  }
  lesson.check_that("three scenes that turn, each by half a radian and more", turned > 0.5,
                    fmt::format("{:.2f}", turned));
  // Impacts and corners may multiply roundings of 1e-16 by a few powers of ten, not by ten.
  lesson.check_small("in each SI, PGS and sparse PGS end in the same places (m, rad)", apart, 1e-9);
}

}  // namespace cairn::tower
