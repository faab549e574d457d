// Lesson 19. Heavy on light.
// Two boxes, and only their masses change: with the heavy one above, each sweep leaves R / (1 + R) of the
// error, which is hardly anything less. Then both stacks are stepped, and a heavy box that gets too few
// sweeps is thrown up.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::edges;

/// One box upon the other, a cold step: sweeps until the load on the ground is right to 1 %, and at least so
/// many.
RatioRun push_two(double ratio, int at_least) {
  RatioRun run{.ratio = ratio, .load = {{0, 0}}, .error = {1}, .speed_jv = {{0, 0}}};
  VelocityProblem<double> problem = two_boxes(ratio);
  const double weight = weight_of(ratio);
  const int sweeps = std::max(at_least, sweeps_by_formula(ratio) + 1);
  for (int k = 1; k <= sweeps; ++k) {
    List<double> jv;
    // [sweep]
    for (int i = 0; i < 2; ++i) {  // the ground first, then the contact between the boxes
      const ConstraintRow<double>& row = problem.rows[i];
      jv.push_back(row_velocity(problem, row));
      const double corrective = -jv[i] * effective_mass(problem, row);  // (22) with ζ = 0, times Δt
      const double sum = std::max(0.0, problem.impulse[i] + corrective);
      apply_impulse(problem, row, sum - problem.impulse[i]);  // (21)
      problem.impulse[i] = sum;
    }
    // [/sweep]
    run.speed_jv.push_back(jv);
    run.load.push_back({problem.impulse[0] / problem.dt, problem.impulse[1] / problem.dt});
    run.error.push_back(1 - run.load.back()[0] / weight);
    if (run.counted == 0 && run.error.back() <= goal) run.counted = k;
  }
  run.largest_gap = gap_to_formula(run);
  return run;
}

/// A stack under SI: how far its top is off, and how much its energy has grown, after each step.
StackCourse drive(double ratio, const StackSettings& settings) {
  StackCourse course{.ratio = ratio};
  World world(two_boxes_scene(ratio));
  SequentialImpulse<double> solver({.iterations = settings.sweeps});
  const double start = total_energy(snapshot(world)), budget = weight_of(ratio) * stack_height;
  for (int k = 0; k <= settings.steps; ++k) {
    if (k > 0) world.step(solver);
    const Snapshot& now = course.frames.emplace_back(snapshot(world));
    const double top = now.bodies.back().pose.position.y() + 0.5;
    course.off_by_step.push_back(std::abs(top - stack_height) / stack_height);
    course.energy_by_step.push_back((total_energy(now) - start) / budget);
  }
  return course;
}

void run(Lesson& lesson) {
  ExtremesRun all{.settings = {.ratio = lesson.real("ratio"), .sweeps = lesson.whole("sweeps")}};
  const double ratio = all.settings.ratio;
  lesson.print(fmt::format("Scene: {:g} kg on 1 kg, and the other way round; Δt = {:g} s", ratio, time_step));
  lesson.predict();
  std::set<double> ratios = {0.001, 0.01, 0.1, 1, 10, 100, 1000, 10000};
  ratios.insert({ratio, 1 / ratio});
  for (const double each : ratios) all.ratios.push_back(push_two(each, 3000));
  all.courses = {drive(ratio, all.settings), drive(1 / ratio, all.settings)};
  report(lesson, all);
  lesson.film(extremes_shots(all));
  lesson.data(numbers_table(all));
  lesson.fingerprint(all.courses[0].frames.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), run, argc, argv); }
