// Lesson 13. Soft: a spring is a constraint that gives way.
//
// A weight stands on a spring. As a force the spring pushes with -k c - d v, taken at the beginning of the
// step, and a stiff one diverges. As a row it asks for j v = zeta like any other, but by gamma less for every
// N s that it has given: that is the same force taken at the end of the step, and it cannot diverge. Both
// stand below as plain loops; then the library does the second with the row of a rod.
#include "lesson.hpp"

namespace cairn::soft {

List<double> by_row(const SoftSettings& settings, int steps) {
  const double m = settings.mass, dt = settings.dt;
  const double k = stiffness(settings);
  const double d = damping_constant(settings);
  List<double> c = {-settings.pressed};
  double v = 0;
  // [row]
  const double gamma = 1 / (dt * (d + dt * k));
  const double beta = dt * k / (d + dt * k);
  for (int step = 0; step < steps; ++step) {
    v -= dt * gravity;
    const double zeta = -beta * c.back() / dt;                  // (7), as for a rigid row
    const double lambda = (zeta - v) / ((1 / m + gamma) * dt);  // (22), with gamma beside j M^-1 j^T
    v += dt * lambda / m;
    c.push_back(c.back() + dt * v);
  }
  // [/row]
  return c;
}

List<double> by_force(const SoftSettings& settings, int steps) {
  const double m = settings.mass, dt = settings.dt;
  const double k = stiffness(settings);
  const double d = damping_constant(settings);
  List<double> c = {-settings.pressed};
  double v = 0;
  for (int step = 0; step < steps; ++step) {
    const double force = -k * c.back() - d * v;  // as the spring stands now
    v += dt * (force / m - gravity);
    c.push_back(c.back() + dt * v);
  }
  return c;
}

// A weight on the ground's rod. It cannot turn, and stands straight above, so it moves up and down.
Scene weight_scene(const SoftSettings& settings, double beta) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta}});
  const Vec2<double> place(0, rest_length - settings.pressed);
  const BodyId weight = scene.add({.shapes = {box(2 * half_height, 2 * half_height)},
                                   .position = place + Vec2<double>(0, half_height),
                                   .mass = settings.mass,
                                   .fixed_rotation = true});
  scene.join<DistanceJoint>({.a = ground, .b = weight, .anchor_b = place, .length = rest_length});
  return scene;
}

WeightRun run_weight(const SoftSettings& settings, double gamma, double beta, int steps) {
  World<double> world(weight_scene(settings, beta));
  SoftRows solver(gamma, {.iterations = 1});  // one row is solved in one sweep
  WeightRun run{.gamma = gamma, .beta = beta};
  record(run, world);
  run.rows.push_back({});
  for (int step = 0; step < steps; ++step) {
    const VelocityProblem<double> problem = world.velocity_problem();
    const ConstraintRow<double>& row = problem.rows[0];
    run.rows.push_back({.zeta = row.bias, .free = row_velocity(problem, row)});
    world.step(solver);
    run.rows.back().lambda = world.last_step().problem.impulse[0] / settings.dt;
    record(run, world);
  }
  return run;
}

namespace {

void run(Lesson& lesson) {
  const SoftRuns all = run_soft(settings_of(lesson));
  print_scene(lesson, all.settings);
  lesson.predict();
  print_runs(lesson, all);
  const double right = all.spring.rows[1].lambda;
  lesson.answer({right}, 0.05 * right,
                "Less than −k c: the row pushes with the force that the spring has at the end of the step, "
                "when it is longer and its damper resists.");
  check_runs(lesson, all);
  lesson.film(soft_shots(all));
  lesson.data(steps_table(all));
  lesson.fingerprint(all.spring.steps.back());
}

}  // namespace
}  // namespace cairn::soft

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::soft::run, argc, argv); }
