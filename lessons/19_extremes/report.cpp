// What lesson 19 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::edges {

namespace {

void print_ratios(Lesson& lesson, const ExtremesRun& run) {
  lesson.print("error left (%)     sweep 1       2      10     100    1000   to 1 %   ln 100 / ln(1 + 1/R)");
  for (auto each = run.ratios.rbegin(); each != run.ratios.rend(); ++each) {
    std::string line = fmt::format("  {:<16}", name_of(each->ratio));
    for (const int k : {1, 2, 10, 100, 1000})
      line += fmt::format("{:>8.2f}", 100 * std::max(0.0, each->error[k]));
    lesson.print(line + fmt::format("{:>9}{:>15.3f}", each->counted,
                                    std::log(goal) / std::log(rate_by_formula(each->ratio))));
  }
  lesson.print();
}

void print_wall(Lesson& lesson, const ExtremesRun& run) {
  lesson.print(fmt::format("Four worlds, {} steps of {:g} s, {} sweeps:   off by at most     energy gained",
                           run.settings.steps, time_step, run.settings.sweeps));
  const int last = run.settings.steps;
  for (const EdgeCase& edge : run.wall) {
    const double worst_off = worst(edge.off_by_step, last);
    const std::string off = worst_off <= 9.995 ? fmt::format("{:.2f} % of", 100 * std::max(worst_off, 1e-9))
                                               : fmt::format("{:.0f} times", worst_off);
    lesson.print(fmt::format("  {:<20}{:>14} {:<22}{:>8.2f} %    {}", edge.name, off, edge.quantity,
                             100 * worst(edge.energy_by_step, last), stamp_text(stamp_of(edge, last))));
  }
  lesson.print();
}

void print_refusals(Lesson& lesson, const ExtremesRun& run) {
  lesson.print("Asked for, and answered by std::invalid_argument:");
  for (const Refusal& refusal : run.refusals)
    lesson.print(fmt::format("  {:<40}{}", refusal.asked, refusal.message));
  lesson.print();
}

void check_ratios(Lesson& lesson, const ExtremesRun& run) {
  double gap = 0;
  int wrong = 0;
  for (const RatioRun& each : run.ratios) {
    // Each sweep rounds some eight times, and what it rounds stays for about 1 + R sweeps.
    gap = std::max(gap, each.largest_gap / (16 * epsilon * (1 + each.ratio)));
    if (each.counted != sweeps_by_formula(each.ratio)) ++wrong;
  }
  lesson.check_small("error = (R / (1 + R))ᵏ in every sweep (share of what rounding allows)", gap, 1);
  // Both stacks weigh the same, and each has found its load to 1 % by then.
  const double weight = (1 + run.settings.ratio) * gravity;
  double load_gap = 0;
  for (const double ratio : {run.settings.ratio, 1 / run.settings.ratio}) {
    const RatioRun& each = run_of(run.ratios, ratio);
    load_gap = std::max(load_gap, std::abs(each.load[each.counted][0] / weight - 1));
  }
  lesson.check_small("both stacks: λ₁ against the weight of both boxes, after the sweeps to 1 %", load_gap,
                     goal);
  lesson.check_small("sweeps to 1 %: counted = ln 100 / ln(1 + 1/R), rounded up (ratios that differ)", wrong,
                     0);
}

void check_wall(Lesson& lesson, const ExtremesRun& run) {
  double pins = 0;
  for (int k = 0; k <= run.settings.steps; ++k)
    pins = std::max(pins, std::abs(pull_of(run.wall[two_pins], k) - quarrel_by_formula(run.settings, k)));
  // Two roundings of the sum in each of all sweeps.
  const double visits = 2.0 * run.settings.sweeps * run.settings.steps;
  lesson.check_small("two pins: λ grows by m β d / Δt² a sweep (share of the last)",
                     pins / quarrel_by_formula(run.settings, run.settings.steps), visits * epsilon);
  const bool is_stamped = stamp_of(run.wall[two_pins], run.settings.steps) == Stamp::growing;
  lesson.check_that("two pins: no more than their distance off, and stamped λ GROWS", is_stamped,
                    fmt::format("{:.0f} kN", pull_of(run.wall[two_pins], run.settings.steps) / 1000));
  lesson.check_that("two pins, one long solve: it stops at a plateau", try_long_quarrel() == Stop::plateau,
                    "rows contradict each other");
}

void check_limits(Lesson& lesson, const ExtremesRun& run) {
  const Scaled scaled = try_scaled_masses(run.settings.sweeps);
  // Masses that are powers of two change exponents only.
  lesson.check_small("all masses times 2²⁰ and 2⁻²⁰: change of heights (m)",
                     std::max(scaled.heavy, scaled.light), 0);
  // Some 64 roundings a step, at a length of 1 m, carried along by all further steps.
  const double steps = run.settings.steps;
  lesson.check_small("a rod stated twice: change of the swing (m)",
                     try_twice(run.settings.sweeps, run.settings.steps), 64 * epsilon * steps * steps);
  const auto refused = std::count_if(run.refusals.begin(), run.refusals.end(), [](const Refusal& refusal) {
    return refusal.message.find("must be") != std::string::npos &&
           refusal.message.find("got") != std::string::npos;
  });
  lesson.check_equal("bad input refused, with rule and value", static_cast<double>(refused),
                     run.refusals.size(), 0);
  const Guarded guarded = try_not_a_number();
  lesson.check_that("0 / 0 in a joint: the body is named, and nothing has moved",
                    guarded.body == guarded.joined && guarded.finite && guarded.moved == 0,
                    fmt::format("body {}", guarded.body));
}

}  // namespace

void report(Lesson& lesson, const ExtremesRun& run) {
  lesson.print();
  print_ratios(lesson, run);
  print_wall(lesson, run);
  print_refusals(lesson, run);
  const double heavy = run_of(run.ratios, run.settings.ratio).counted;
  const double light = run_of(run.ratios, 1 / run.settings.ratio).counted;
  lesson.answer(
      {heavy, light}, std::max(2.0, 0.02 * heavy),
      "The light box stands between the heavy one and the ground: in each sweep the ground learns of no more "
      "weight than the light box passes on. The other way round the first guess is nearly right.");
  check_ratios(lesson, run);
  check_wall(lesson, run);
  check_limits(lesson, run);
}

CsvTable numbers_table(const ExtremesRun& run) {
  CsvTable table{.header = {"world", "step", "off"}};
  for (const EdgeCase& edge : run.wall) {
    for (int k = 0; k < edge.off_by_step.size(); ++k)
      table.rows.push_back({edge.name, k, edge.off_by_step[k]});
  }
  for (const RatioRun& each : run.ratios) {
    const int end = std::min(each.error.size(), 101);
    for (int k = 0; k < end; ++k) table.rows.push_back({name_of(each.ratio), k, each.error[k]});
  }
  return table;
}

}  // namespace cairn::edges
