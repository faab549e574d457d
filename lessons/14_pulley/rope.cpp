// Seven solvers, one sweep a step, one row on three bodies.
#include "rope.hpp"

#include <functional>
#include <memory>

namespace cairn::pulley {

namespace {

const double gravity = 10;  // [m/s^2]

Scene pulley_scene(const PulleySettings& settings) {
  Scene scene({.gravity = {0, -gravity}, .dt = settings.dt});
  const std::array<double, 3> x = {-3 * wheel_radius, 0, 3 * wheel_radius};
  const std::array<double, 3> y = {2, 2, 4};
  std::array<RopeOverWheels::End, 3> ends;
  double length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const BodyId body =
        scene.add({.shapes = {box(0.6, 0.6)}, .position = {x[i], y[i]}, .mass = settings.masses[i]});
    ends[i] = {.body = body, .parts = parts[i], .top = wheel_height};
    length += parts[i] * (wheel_height - y[i]);
  }
  scene.add_joint(std::make_shared<const RopeOverWheels>(ends, length));
  return scene;
}

PulleyStep look(const World<double>& world) {
  PulleyStep step{.snapshot = snapshot(world)};
  for (std::size_t i = 0; i < 3; ++i) step.speed[i] = world.bodies().velocity[i + 1].y();
  RowSpecs<double> rows;
  world.scene().joints()[0]->append_rows(world.bodies().pose, rows);
  step.room = rows[0].error;
  const VelocityProblem<double>& problem = world.last_step().problem;
  if (!problem.impulse.empty()) step.tension = problem.impulse[0] / problem.dt;
  return step;
}

PulleyRun run_one(const PulleySettings& settings, Solver<double>& solver) {
  World<double> world(pulley_scene(settings));
  PulleyRun run{.solver = solver.name(), .steps = {look(world)}};
  for (int step = 1; step <= settings.steps; ++step) {
    world.step(solver);
    run.steps.push_back(look(world));
    if (step == settings.lift_step) world.set_velocity({3}, {0, settings.lift, 0});
  }
  run.memory = solver.memory();
  return run;
}

}  // namespace

PulleyRuns run_pulleys(const PulleySettings& settings) {
  PulleyRuns all{.settings = settings, .first = World<double>(pulley_scene(settings)).velocity_problem()};
  const SolverSettings one_sweep = {.iterations = 1};
  const std::unique_ptr<Solver<double>> solvers[] = {
      std::make_unique<SequentialImpulse<double>>(one_sweep),
      std::make_unique<ProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<SparseProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<FactoredProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<NaiveProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<AcceleratedProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<Jacobi<double>>(one_sweep, Splitting::mass)};
  for (const std::unique_ptr<Solver<double>>& solver : solvers)
    all.runs.push_back(run_one(settings, *solver));
  return all;
}

double tension_by_formula(const PulleySettings& settings) {
  double sum = 0;
  double inverse = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += parts[i];
    inverse += parts[i] * parts[i] / settings.masses[i];
  }
  return sum * gravity / inverse;
}

}  // namespace cairn::pulley
