// Lesson 20. Only what the scene needs: the fastest row update is the one that is left out.
// A pyramid and a tower stand, a chain swings, a ball flies. Every step costs rows × sweeps, and most of them
// do nothing. Four runs of the same scene leave something out: sweeps after the error is small, the wait of
// one island for another, all rows of what sleeps. What each run saves is counted, and how far it goes
// another way than a run that leaves nothing out.
#include "lesson.hpp"

#include <chrono>

namespace {

using namespace cairn;
using namespace cairn::needs;

/// What tables and checks want to know of a step.
void note(StepBill& bill, const Stage& stage, const StepReport& report) {
  bill.stages.push_back({.rows = report.rows, .sweeps = report.rows > 0 ? report.sweeps : 0});
  bill.rows += report.rows;
  bill.awake += report.awake.bodies;
  bill.sweeps = std::max(bill.sweeps, bill.stages.back().sweeps);
  if (report.rows > 0 && report.solve.converged)
    bill.residual = std::max(bill.residual, residual_left(stage));
}

/// A step, and the seconds that it took on this machine, without what this lesson looks up afterwards.
StepReport timed_step(Stage& stage, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const StepReport report = stage.world.step(stage.solver, &stage.scale);
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

/// One step of the whole scene, or of its islands one by one, and what it has cost.
StepBill step(List<Stage>& stages, double& seconds) {
  StepBill bill;
  for (Stage& stage : stages) {
    const StepReport report = timed_step(stage, seconds);
    bill.updates += static_cast<long long>(report.rows) * report.sweeps;  // 0 where all of it sleeps or flies
    note(bill, stage, report);
  }
  return bill;
}

BillRun run_under(const NeedsSettings& settings, const Switches& switches, double tolerance) {
  List<Stage> stages = stages_of(settings, switches, tolerance);
  BillRun run{.switches = switches, .frames = {together(stages)}};
  for (int k = 1; k <= settings.steps; ++k) {
    run.steps.push_back(step(stages, run.seconds));
    run.updates += run.steps.back().updates;
    run.frames.push_back(together(stages));
  }
  return run;
}

NeedsRun run_all(const NeedsSettings& settings) {
  NeedsRun all{.settings = settings};
  const int last = settings.steps, bodies = pyramid_boxes + 1 + settings.tower + settings.links;
  NeedsSettings thorough = settings;
  thorough.sweeps = 2000;
  // [runs]
  all.reference = run_under(thorough, all_switches()[by_islands], reference_tolerance);
  all.touch = first_touch(all.reference.frames, ball_of(settings));
  const int before = all.touch > 0 ? all.touch - 1 : last;
  for (const Switches& each : all_switches()) {
    BillRun run = run_under(settings, each, each.ends_early ? settings.tolerance : 0);
    run.off_before = largest_distance(run.frames, all.reference.frames, 1, before, bodies);
    all.runs.push_back(run);
  }
  // [/runs]
  const BillRun alone = run_under(settings, {.by_island = true}, 0);  // each island a scene of its own
  all.alone = largest_distance(alone.frames, all.runs[everything].frames, 1, last, bodies);
  return all;
}

void run(Lesson& lesson) {
  const NeedsSettings settings{.sweeps = lesson.whole("sweeps"),
                               .tolerance = lesson.real("tolerance"),
                               .tower = lesson.whole("bodies"),
                               .links = lesson.whole("links"),
                               .steps = lesson.whole("steps")};
  lesson.print(fmt::format(
      "Scene: a pyramid of {}, a tower of {}, a chain of {} links, a ball in flight; Δt = {:g} s, "
      "{} sweeps, {} steps",
      pyramid_boxes, settings.tower, settings.links, time_step, settings.sweeps, settings.steps));
  lesson.predict();
  const NeedsRun all = run_all(settings);
  report(lesson, all);
  lesson.film(needs_shots(all));
  lesson.data(bills_table(all));
  lesson.fingerprint(all.runs[everything].frames.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), run, argc, argv); }
