// What lesson 21 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::taut {

namespace {

std::string end_of(const ChainRun& run) {
  if (run.torn >= 0) return fmt::format("a bead is {:g} m off after step {}", lost, run.torn);
  return fmt::format("{:.2g} mm off at most, in {} steps", 1000 * run.off_most(), film_steps);
}

void print_tables(Lesson& lesson, const ChainRuns& runs) {
  lesson.print("Δt (s)    holds up to (kg):  l m / (Δt² g)   ω Δt = 2   measured");
  for (const Critical& each : runs.criticals)
    lesson.print(fmt::format("  {:<8g}{:>32.2f}{:>11.2f}{:>11.2f}", each.dt, each.rule, each.predicted,
                             each.measured));
  lesson.print();
  lesson.print("load (kg)     ω Δt     a step multiplies by:  predicted   measured");
  for (const Growth& each : runs.growths)
    lesson.print(fmt::format("  {:<9.2f}{:>7.3f}{:>33.4f}{:>11.4f}", each.load, each.angle, each.predicted,
                             each.measured));
  lesson.print();
  lesson.print(fmt::format("Under {:g} kg, from 1 mm beside the line (steps of {:g} s):", runs.settings.load,
                           runs.settings.dt));
  for (const auto* list : {&runs.sweeps, &runs.cures})
    for (const ChainRun& run : *list) lesson.print(fmt::format("  {:<26}{}", run.name, end_of(run)));
  const ChainSettings& settings = runs.settings;
  const List<double> own = squared_frequencies(settings, List<double>(settings.beads, settings.bead)),
                     raised = squared_frequencies(settings, masses_needed(settings));
  lesson.print(fmt::format(
      "With enough mass, {:.3g} kg for the first bead: ω Δt {:.3f} instead of {:.3f}; the slowest swing "
      "{:.3f} s instead of {:.3f} s.",
      masses_needed(settings)[0], settings.dt * std::sqrt(raised.back()), settings.dt * std::sqrt(own.back()),
      2 * std::numbers::pi / std::sqrt(raised.front()), 2 * std::numbers::pi / std::sqrt(own.front())));
  lesson.print();
}

/// A chain counts as one that fails from a thousandfold on. 150 steps grow so far from a load on that is by
/// the share (ln 1000 / 300)^2 above the critical one; and the search ends at 0.0002.
void check_theory(Lesson& lesson, const ChainRuns& runs) {
  double off = 0;
  for (const Critical& each : runs.criticals)
    off = std::max(off, std::abs(each.measured / each.predicted - 1));
  lesson.check_small("the load at which ω Δt = 2, against that which fails (share)", off,
                     2e-4 + std::pow(std::log(1000) / 300, 2));
  double gap = 0;
  for (const Growth& each : runs.growths) gap = std::max(gap, std::abs(each.measured / each.predicted - 1));
  // The next slower swing still is in it: by less than the growth of both differs, over the steps that it
  // took.
  lesson.check_small("a step multiplies by z²/2 − 1 + √((z²/2 − 1)² − 1), z = ω Δt (share)", gap, 0.02);
}

void check_runs(Lesson& lesson, const ChainRuns& runs) {
  const double load = runs.settings.load, critical = runs.criticals[0].predicted;
  int kept = 0;
  for (const ChainRun& run : runs.sweeps) kept += run.torn < 0 ? 1 : 0;
  const List<double> raised = squared_frequencies(runs.settings, masses_needed(runs.settings));
  lesson.check_small("ω Δt of the fastest swing, with enough mass",
                     runs.settings.dt * std::sqrt(raised.back()), 2 * (1 + 100 * epsilon));
  if (load > 3 * critical)
    lesson.check_that("10, 100, 10 000 sweeps, and exact: none of them keeps it (chains kept)", kept == 0,
                      fmt::format("{}", kept));
  // Twice the mass holds twice the load: f = l m / Δt².
  if (load > 3 * critical)
    lesson.check_that("beads of twice the mass are not enough (step)", runs.cures[heavier].torn > 0,
                      fmt::format("{}", runs.cures[heavier].torn));
  lesson.check_that("enough mass holds (mm)", runs.cures[enough_mass].torn < 0,
                    fmt::format("{:.2g}", 1000 * runs.cures[enough_mass].off_most()));
  if (load < 0.9 * runs.criticals[2].predicted)
    lesson.check_that("steps of " + part_name(runs.settings) + " hold (mm)", runs.cures[short_steps].torn < 0,
                      fmt::format("{:.2g}", 1000 * runs.cures[short_steps].off_most()));
  if (load > critical)
    lesson.check_small("the default holds: never farther off than at the beginning (m)",
                       runs.cures[by_default].off_most(), 0.001 * (1 + 16 * epsilon));
}

}  // namespace

void report(Lesson& lesson, const ChainRuns& runs) {
  print_tables(lesson, runs);
  lesson.answer({3}, 0,
                fmt::format("A step of semi-implicit Euler follows neighbours that swing against each other "
                            "up to a pull of f = l m / Δt². That is a load of {:g} kg, and with steps of a "
                            "quarter sixteen times as much.",
                            runs.criticals[0].rule));
  check_theory(lesson, runs);
  check_runs(lesson, runs);
}

CsvTable numbers_table(const ChainRuns& runs) {
  CsvTable table{.header = {"run", "step", "off_m"}};
  for (const auto* list : {&runs.sweeps, &runs.cures})
    for (const ChainRun& run : *list)
      for (int k = 0; k < run.off.size(); ++k) table.rows.push_back({run.name, k, run.off[k]});
  return table;
}

}  // namespace cairn::taut
