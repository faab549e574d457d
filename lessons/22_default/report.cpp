// What lesson 22 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::usual {

namespace {

std::string row_of(const Outcome& outcome, bool is_watched) {
  return fmt::format("  {:<14}{:>11.3f}{:>11.3f}{:>12}{:>13.0f}{:>11.3f}", outcome.name,
                     1000 * outcome.overlap, 1000 * outcome.gap,
                     is_watched ? fmt::format("{:.2f}", cleaned(1000 * outcome.sunk)) : "", outcome.work,
                     outcome.milliseconds);
}

void print_trials(Lesson& lesson, const Trials& trials) {
  lesson.print(fmt::format("{}, {}", trials.kind.name, trials.usual.reason));
  for (const Outcome& outcome : trials.outcomes) lesson.print(row_of(outcome, trials.kind.watched != ground));
}

void print_all(Lesson& lesson, const DefaultRuns& runs) {
  lesson.print("is off         overlap (mm)   gap (mm)  sinks (mm)  work a step  ms a step");
  for (const Trials* trials : {&runs.bridge, &runs.beam}) print_trials(lesson, *trials);
  lesson.print("Beyond the border, the default, which sweeps, and newton in its place:");
  for (const Trials& trials : runs.large) print_trials(lesson, trials);
  lesson.print(
      "Work: the solver alone, in row updates of SI. ms: whole steps, on this machine; never checked.");
  std::string sweeps = "The bridge, sweeps:   ", sunk = "  its load sinks (mm):",
              work = "  work a step:        ";
  for (const SweepTrial& trial : runs.sweeps) {
    sweeps += fmt::format("{:>8}", trial.sweeps);
    sunk += fmt::format("{:>8.0f}", 1000 * trial.sunk);
    work += fmt::format("{:>8.0f}", trial.work);
  }
  for (const std::string& line : {sweeps, sunk, work}) lesson.print(line);
  const double half = 0.5 * runs.settings.planks;
  const double longer = longer_half(runs.bridge.outcomes[swept].lowest);
  lesson.print(fmt::format(
      "Under 20 sweeps the gaps of its joints are {:.1f} cm together, {:.1f} cm for either half: straight, "
      "it would hang by {:.0f} cm.",
      200 * longer, 100 * longer, 100 * hangs_by(half, longer)));
  lesson.print();
}

void check_bridge(Lesson& lesson, const DefaultRuns& runs) {
  const List<Outcome>& outcomes = runs.bridge.outcomes;
  lesson.check_small("the default by hand, and Simulation: the bridge (m)", runs.from_simulation, 0);
  // A box of 0.8 m that tilts may be lower than the plank below it by half of its diagonal.
  const Outcome& loose = outcomes[swept];
  const double hangs = hangs_by(0.5 * runs.settings.planks, longer_half(loose.lowest));
  lesson.check_that("sweeps: the middle sinks no lower than open joints let it (m)",
                    loose.sunk <= hangs + 0.57, fmt::format("{:.2f} <= {:.2f}", loose.sunk, hangs + 0.57));
  if (runs.settings.planks < 8 || runs.settings.density < 5 || runs.settings.density > 50) return;
  // A load in the middle pulls a chain straight; one that is spread makes a parabola of it.
  const double parabola = std::sqrt(0.75) * hangs;
  lesson.check_that("sweeps: with these gaps, between a parabola and straight (m)",
                    parabola < loose.sunk && loose.sunk < hangs,
                    fmt::format("{:.3f} < {:.3f} < {:.3f}", parabola, loose.sunk, hangs));
  lesson.check_that("it sinks by more than ten times the widest gap of a joint", loose.sunk > 10 * loose.gap,
                    fmt::format("{:.0f} times", loose.sunk / loose.gap));
  double least = std::numeric_limits<double>::infinity();
  for (int i = one_substep; i <= swept; ++i)
    least = std::min(least, outcomes[i].sunk / outcomes[nothing_off].sunk);
  lesson.check_that("whichever part is off, the load of the bridge sinks at least twice as far", least > 2,
                    fmt::format("{:.1f} times", least));
  double smallest = 1, largest = 0;
  for (int i = 0; i + 3 < runs.sweeps.size(); ++i) {
    const double left = runs.sweeps[i + 3].sunk / runs.sweeps[i].sunk;
    smallest = std::min(smallest, left);
    largest = std::max(largest, left);
  }
  lesson.check_that("eight times the sweeps halve that, about", smallest > 0.4 && largest < 0.6,
                    fmt::format("{:.2f} to {:.2f}", smallest, largest));
}

void check_beam(Lesson& lesson, const DefaultRuns& runs) {
  const Outcome &exact = runs.beam.outcomes.front(), &loose = runs.beam.outcomes.back();
  // All rows at once leave 1e-9 of a weight's impulse in each step, on an arm of 10 m.
  lesson.check_small("the beam, all rows at once: its end sinks (m)", exact.sunk, 1e-6);
  lesson.check_that("the beam under 20 sweeps: its end sinks by more than a metre, for more work",
                    loose.sunk > 1 && loose.work > exact.work,
                    fmt::format("{:.2f} m, {:.1f} times", loose.sunk, loose.work / exact.work));
}

void check_beyond(Lesson& lesson, const DefaultRuns& runs) {
  const List<Outcome>&tower = runs.large[the_tower].outcomes, &pile = runs.large[the_large_pile].outcomes;
  lesson.check_small("the tower beyond the border: newton holds it (m)", tower[at_once].sunk, 1e-6);
  if (runs.settings.tower >= 110)
    lesson.check_that("the default lets it fall, for more work: its top sinks by more than a metre",
                      tower[by_sweeps].sunk > 1 && tower[by_sweeps].work > tower[at_once].work,
                      fmt::format("{:.2f} m, {:.2f} times", tower[by_sweeps].sunk,
                                  tower[by_sweeps].work / tower[at_once].work));
  lesson.check_that("the pile beyond it: newton takes more than ten times the work",
                    pile[at_once].work > 10 * pile[by_sweeps].work,
                    fmt::format("{:.0f} times", pile[at_once].work / pile[by_sweeps].work));
}

}  // namespace

double longer_half(const Snapshot& bridge) {
  double sum = 0;
  for (const SnapshotJoint& joint : bridge.joints) sum += joint.drift;
  return sum / 2;
}

double hangs_by(double half, double longer) {
  return std::sqrt((half + longer) * (half + longer) - half * half);
}

void report(Lesson& lesson, const DefaultRuns& runs) {
  lesson.print();
  print_all(lesson, runs);
  const Outcome& loose = runs.bridge.outcomes[swept];
  lesson.answer(
      {100 * loose.sunk}, 20 * loose.sunk,
      fmt::format("The gaps make either half of the bridge {:.1f} cm longer, and a level chain that "
                  "is a little longer hangs a lot lower.",
                  100 * longer_half(loose.lowest)));
  check_bridge(lesson, runs);
  check_beam(lesson, runs);
  check_beyond(lesson, runs);
}

CsvTable outcomes_table(const DefaultRuns& runs) {
  CsvTable table{.header = {"scene", "off", "overlap_m", "gap_m", "sinks_m", "work"}};
  List<const Trials*> all = {&runs.bridge, &runs.beam};
  for (const Trials& trials : runs.large) all.push_back(&trials);
  for (const Trials* trials : all)
    for (const Outcome& outcome : trials->outcomes)
      table.rows.push_back(
          {trials->kind.name, outcome.name, outcome.overlap, outcome.gap, outcome.sunk, outcome.work});
  return table;
}

}  // namespace cairn::usual
