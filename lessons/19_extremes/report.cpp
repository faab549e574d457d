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

void print_courses(Lesson& lesson, const ExtremesRun& run) {
  const int last = run.settings.steps;
  lesson.print(fmt::format("{} steps of {:g} s, {} sweeps:   top off by (% of the height)   energy up by (%)",
                           last, time_step, run.settings.sweeps));
  for (const StackCourse& course : run.courses)
    lesson.print(fmt::format("  {:<20}{:>25.2f}{:>26.2f}    {}", name_of(course.ratio),
                             100 * worst(course.off_by_step, last), 100 * worst(course.energy_by_step, last),
                             verdict(is_ok(course, last))));
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

void check_courses(Lesson& lesson, const ExtremesRun& run) {
  lesson.check_that("step by step, the light box stays on the heavy one",
                    is_ok(run.courses[1], run.settings.steps),
                    verdict(is_ok(run.courses[1], run.settings.steps)));
}

}  // namespace

void report(Lesson& lesson, const ExtremesRun& run) {
  lesson.print();
  print_ratios(lesson, run);
  print_courses(lesson, run);
  const double heavy = run_of(run.ratios, run.settings.ratio).counted;
  const double light = run_of(run.ratios, 1 / run.settings.ratio).counted;
  lesson.answer(
      {heavy, light}, std::max(2.0, 0.02 * heavy),
      "The light box stands between the heavy one and the ground: in each sweep the ground learns of no more "
      "weight than the light box passes on. The other way round the first guess is nearly right.");
  check_ratios(lesson, run);
  check_courses(lesson, run);
}

CsvTable numbers_table(const ExtremesRun& run) {
  CsvTable table{.header = {"stack", "step", "off"}};
  for (const StackCourse& course : run.courses) {
    for (int k = 0; k < course.off_by_step.size(); ++k)
      table.rows.push_back({name_of(course.ratio), k, course.off_by_step[k]});
  }
  for (const RatioRun& each : run.ratios) {
    const int end = std::min(each.error.size(), 101);
    for (int k = 0; k < end; ++k) table.rows.push_back({name_of(each.ratio), k, each.error[k]});
  }
  return table;
}

}  // namespace cairn::edges
