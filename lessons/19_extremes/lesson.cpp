// Lesson 19. Heavy on light: where it breaks, and how you notice.
// Two boxes, and only their masses change: with the heavy one above, each sweep leaves R / (1 + R) of the
// error, which is hardly anything less. Then four small worlds, each driven to an edge, under one loop that
// steps them and measures how far off they are. A stamp says what came of it, and some of what has gone wrong
// only numbers tell.
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

/// A world driven to its edge: how far off it is, and its energy out of nowhere, after each step.
EdgeCase drive(const SmallWorld& small, const WallSettings& settings) {
  EdgeCase edge = small.edge;
  World world(small.scene);
  SequentialImpulse<double> solver({.iterations = settings.sweeps});
  const double start = total_energy(snapshot(world));
  for (int k = 0; k <= settings.steps; ++k) {
    if (k > 0) world.step(solver);
    const Snapshot& now = edge.frames.emplace_back(snapshot(world));
    edge.off_by_step.push_back(small.off(now));
    edge.energy_by_step.push_back((total_energy(now) - start) / small.budget);
  }
  return edge;
}

void run(Lesson& lesson) {
  ExtremesRun all{.settings = {.ratio = lesson.real("ratio"),
                               .sweeps = lesson.whole("sweeps"),
                               .boxes = lesson.whole("bodies")}};
  const double ratio = all.settings.ratio;
  lesson.print(
      fmt::format("Scene: {:g} kg on 1 kg, and the other way round; then four small worlds; Δt = {:g} s",
                  ratio, time_step));
  lesson.predict();
  std::set<double> ratios = {0.001, 0.01, 0.1, 1, 10, 100, 1000, 10000};
  ratios.insert({ratio, 1 / ratio});
  for (const double each : ratios) all.ratios.push_back(push_two(each, 3000));
  for (const SmallWorld& world : small_worlds(all.settings)) all.wall.push_back(drive(world, all.settings));
  all.refusals = try_bad_input();
  report(lesson, all);
  lesson.film(extremes_shots(all));
  lesson.data(numbers_table(all));
  lesson.fingerprint(all.wall[0].frames.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), run, argc, argv); }
