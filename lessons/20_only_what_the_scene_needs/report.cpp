// What lesson 20 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::needs {

namespace {

void print_bills(Lesson& lesson, const NeedsRun& all) {
  const double steps = all.settings.steps;
  lesson.print("switch                rows  least   updates a step        %      µs    off before (mm)");
  for (const BillRun& run : all.runs) {
    lesson.print(fmt::format(
        "  {:<18}{:>6}{:>7}{:>17}{:>9.1f}{:>8.0f}{:>14.1f}", run.switches.name, run.steps[0].rows,
        least_rows(run), run.updates / all.settings.steps,
        100.0 * static_cast<double>(run.updates) / static_cast<double>(all.runs[everything].updates),
        1e6 * run.seconds / steps, 1000 * run.off_before));
  }
  lesson.print(
      "µs: of whole steps, with the search for contacts, on this machine; never checked. R_E itself costs a "
      "pass.");
  lesson.print(
      all.touch > 0
          ? fmt::format("off before: how far bodies are from where they should be, before step {}, in which "
                        "the ball hits.",
                        all.touch)
          : "off before: how far bodies are from where they should be; the ball hits nothing in these "
            "steps.");
  lesson.print();
}

void print_steps(Lesson& lesson, const NeedsRun& all) {
  lesson.print("rows × sweeps in step       1      20      40      60      80     100     120     140");
  for (const int i : {everything, by_islands, sleeping}) {
    std::string line = fmt::format("  {:<20}", all.runs[i].switches.name);
    for (const int k : {1, 20, 40, 60, 80, 100, 120, 140}) {
      if (k <= all.runs[i].steps.size()) line += fmt::format("{:>8}", all.runs[i].steps[k - 1].updates);
    }
    lesson.print(line);
  }
  const List<StepBill>& steps = all.runs[by_islands].steps;
  std::string line =
      fmt::format("exit by island: steps of {} that take all {} sweeps:", steps.size(), all.settings.sweeps);
  std::string sweeps = "  sweeps a step, on average:", updates = "  updates a step, on average:";
  const FixedList<std::string, 3> names = {"pyramid", "tower", "chain"};
  for (int i = 0; i < names.size(); ++i) {
    const auto all_sweeps = [&](const StepBill& bill) {
      return bill.stages[i].sweeps == all.settings.sweeps;
    };
    line += fmt::format("  {} {}", names[i], std::count_if(steps.begin(), steps.end(), all_sweeps));
    const StageMean taken = mean_of(all.runs[by_islands], i);
    sweeps += fmt::format("  {} {:.1f}", names[i], taken.sweeps);
    updates += fmt::format("  {} {:.0f}", names[i], taken.updates);
  }
  for (const std::string& each : {line, sweeps, updates}) lesson.print(each);
  lesson.print();
}

/// How far sleepers have moved, and whether rows were written for what sleeps alone.
struct SleepFacts {
  double moved = 0;    // [m]
  int wrong_rows = 0;  // steps in which only ball and chain are awake, with other rows than the chain's
  int such_steps = 0;
  int woken = 0;    // the step in which the pyramid has woken up; 0: never slept, or never woken
  int touched = 0;  // the step in which the ball came near it
};

SleepFacts look_at_sleep(const NeedsRun& all) {
  SleepFacts facts;
  const BillRun& run = all.runs[sleeping];
  const BodyId ball = ball_of(all.settings);
  for (int k = 1; k < run.frames.size(); ++k) {
    const Snapshot& before = run.frames[k - 1];
    const Snapshot& now = run.frames[k];
    for (const BodyId body : now.bodies.indices()) {
      if (body == ground || before.bodies[body].awake || now.bodies[body].awake) continue;
      const Vec2<double> gap = now.bodies[body].pose.position - before.bodies[body].pose.position;
      facts.moved = std::max(facts.moved, gap.norm());
    }
    bool at_ball = false;
    for (const SnapshotContact& contact : now.contacts)
      at_ball = at_ball || contact.a == ball || contact.b == ball;
    if (facts.touched == 0 && at_ball) facts.touched = k;
    if (facts.woken == 0 && !before.bodies[{1}].awake && now.bodies[{1}].awake) facts.woken = k;
    if (!at_ball && run.steps[k - 1].awake == all.settings.links + 1 && !before.bodies[{1}].awake) {
      facts.such_steps += 1;
      // Those that fall asleep in this step had rows in it.
      if (k >= 2 && run.steps[k - 2].awake == all.settings.links + 1)
        facts.wrong_rows += run.steps[k - 1].rows != 2 * all.settings.links;
    }
  }
  return facts;
}

void check_all(Lesson& lesson, const NeedsRun& all) {
  int wrong = 0;
  for (const BillRun& run : all.runs) wrong += run.steps[0].rows != rows_by_formula(all.settings);
  lesson.check_small("rows of step 1, counted by hand (runs that differ)", wrong, 0);
  lesson.check_small("an island by itself moves as in the whole scene (m)", all.alone, 0);
  const SleepFacts facts = look_at_sleep(all);
  lesson.check_small("what sleeps stays where it is (m)", facts.moved, 0);
  if (facts.such_steps > 0) {
    lesson.check_small("ball and chain awake: rows other than 2 a link (steps)", facts.wrong_rows, 0);
  }
  if (facts.woken > 0) {
    lesson.check_equal("the pyramid wakes up in the step in which the ball is near it", facts.woken,
                       facts.touched, 0);
  }
  double residual = 0;
  for (const int i : {early, by_islands}) {
    for (const StepBill& bill : all.runs[i].steps) residual = std::max(residual, bill.residual);
  }
  lesson.check_small("a step that ends early has R_E at most as asked for", residual, all.settings.tolerance);
}

}  // namespace

void report(Lesson& lesson, const NeedsRun& all) {
  lesson.print();
  print_bills(lesson, all);
  print_steps(lesson, all);
  lesson.answer(
      {100.0 * static_cast<double>(all.runs[by_islands].updates) /
       static_cast<double>(all.runs[everything].updates)},
      7,
      "So many per cent of the row updates are left. In one piece a step ends for all together, and in "
      "most steps the tower keeps it going. By themselves, the pyramid and the chain end earlier.");
  check_all(lesson, all);
}

CsvTable bills_table(const NeedsRun& all) {
  CsvTable table{.header = {"switch", "step", "rows", "sweeps", "updates", "awake"}};
  for (const BillRun& run : all.runs) {
    for (int k = 0; k < run.steps.size(); ++k) {
      const StepBill& bill = run.steps[k];
      table.rows.push_back({run.switches.name, k + 1, bill.rows, bill.sweeps, bill.updates, bill.awake});
    }
  }
  return table;
}

}  // namespace cairn::needs
