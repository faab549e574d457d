// What a step of the fall left behind.
#include "lesson.hpp"

namespace cairn::pulley {

PulleyStep look(const World<double>& world) {
  PulleyStep step{.snapshot = snapshot(world)};
  for (int i = 0; i < 3; ++i) step.speed[i] = world.bodies().velocity[{i + 1}].y();
  RowSpecs<double> rows;
  world.scene().joints()[0]->append_rows(world.bodies().pose, rows);
  step.room = rows[0].error;
  const VelocityProblem<double>& problem = world.last_step().problem;
  if (!problem.impulse.empty()) step.tension = problem.impulse[0] / problem.dt;
  return step;
}

namespace {

/// Whether every mass hangs below its wheels, and high enough to be seen.
bool hangs_free(const PulleyStep& step) {
  const FixedList<double, 3> highest = {wheel_height - 1, wheel_height - 2 * wheel_radius - 1,
                                        wheel_height - 1};  // [m] of a mass of 0.6 m, the second with a wheel
  for (int i = 0; i < 3; ++i) {
    const double y = step.snapshot.bodies[{i + 1}].pose.position.y();
    if (y < 1 || y > highest[i]) return false;
  }
  return true;
}

}  // namespace

void end_at_wheels(PulleyRuns& all) {
  const List<PulleyStep>& steps = all.runs[0].steps;
  int kept = 2;
  while (kept < steps.size() && hangs_free(steps[kept])) ++kept;
  for (PulleyRun& run : all.runs) run.steps.resize(kept);
  all.settings.steps = kept - 1;
}

}  // namespace cairn::pulley
