// What lesson 18 prints, and the claims that it makes.
#include "lesson.hpp"

namespace cairn::cost {

namespace {

const FixedList<int, 5> shown_sweeps = {10, 20, 50, 100, 200};
const FixedList<int, 5> shown_digits = {1, 2, 3, 6, 9};

std::string shown_error(double error) {
  if (error <= least_error) return fmt::format("{:>9}", "< 1e-12");
  return error >= 0.001 ? fmt::format("{:>9.4f}", error) : fmt::format("{:>9.1e}", error);
}

void print_errors(Lesson& lesson, const CostRun& run) {
  std::string line = "1. Error after       ";
  for (const int sweep : shown_sweeps) line += fmt::format(" {:>9}", sweep);
  lesson.print(line + " sweeps   each leaves");
  for (const Curve& curve : run.curves) {
    line = fmt::format("   {:<18}", curve.name);
    for (const int sweep : shown_sweeps) {
      const int k = std::min(sweep, curve.error.size() - 1);
      line += " " + shown_error(curve.error[k]);
    }
    lesson.print(line +
                 (curve.rate > 0 ? fmt::format(" {:>17.4f}", curve.rate) : fmt::format(" {:>17}", "·")));
  }
  lesson.print();
}

void print_digits(Lesson& lesson, const CostRun& run) {
  std::string line = "2. Sweeps to         ";
  for (const int digit : shown_digits) line += fmt::format(" {:>8}", fmt::format("1e-{}", digit));
  lesson.print(line + "   a digit    products, to 1e-2");
  for (const Curve& curve : run.curves) {
    line = fmt::format("   {:<18}", curve.name);
    for (const int digit : shown_digits) {
      const int sweeps = sweeps_to(curve.error, std::pow(10, -digit));
      line += sweeps < 0 ? fmt::format(" {:>8}", "·") : fmt::format(" {:>8}", sweeps);
    }
    line += curve.rate > 0 ? fmt::format(" {:>9.1f}", sweeps_per_digit(curve)) : fmt::format(" {:>9}", "·");
    const int sweeps = sweeps_to(curve.error, 0.01);
    lesson.print(line + (sweeps < 0 ? "" : fmt::format(" {:>23.0f}", curve.work * sweeps)));
  }
  const double n = run.settings.boxes;
  lesson.print(fmt::format("   elimination, all digits: 5n − 4 = {:.0f} products", 5 * n - 4));
  line = "   to 1 %, boxes:    ";
  std::string sor = "   with the best ω   ";
  for (const SizeCost& size : run.sizes) {
    line += fmt::format(" {:>2}: {:>4}", size.boxes, size.si);
    sor += fmt::format("     {:>4}", size.sor);
  }
  lesson.print(line + "   about 1.78 n²");
  lesson.print(sor);
  lesson.print();
}

/// What a sweep has left of the error where it first is below 1e-4: by then one error is left. Those that
/// decay faster have become smaller than it by a factor of 1e-14 or so at least, for any number of boxes.
double measured_rate(const Curve& curve) {
  const int k = sweeps_to(curve.error, 1e-4);
  return curve.error[k + 1] / curve.error[k];
}

void check_rates(Lesson& lesson, const CostRun& run) {
  const int n = run.settings.boxes;
  // Loads rounded once an update; a sweep forgets 1 / n^2 of them: some 8 n^2 roundings of 1, in errors of
  // 1e-4.
  const double tolerance = 8 * epsilon * n * n / 1e-4 * 4;
  lesson.check_equal("SI: a sweep leaves cos²(π / 2n)", measured_rate(run.curves[si_curve]),
                     run.curves[si_curve].rate, tolerance);
  lesson.check_equal("Jacobi, ω = ½: cos²(π / 4n)", measured_rate(run.curves[jacobi_curve]),
                     std::pow(std::cos(pi / (4 * n)), 2), tolerance);
  // A double eigenvalue moves by the root of what the matrix is rounded by.
  lesson.check_equal("SOR: Young's ρ is the largest eigenvalue of its matrix",
                     sor_rate_by_matrix(n, run.omega), sor_rate(n, run.omega), std::sqrt(64 * epsilon * n));
}

void check_curves(Lesson& lesson, const CostRun& run) {
  const int n = run.settings.boxes;
  const Curve& si = run.curves[si_curve];
  double apart = 0;
  for (int k = 0; k < std::min(si.error.size(), run.pgs.error.size()); ++k)
    apart = std::max(apart, std::abs(si.error[k] - run.pgs.error[k]));
  // As above: 8 n^2 roundings are remembered, in each of the two.
  lesson.check_small("PGS and SI: errors differ, after any sweep, by", apart, 16 * epsilon * n * n);
  for (const int which : {si_curve, sor_curve}) {
    const Curve& curve = run.curves[which];
    const List<double>& by_hand = curve.by_hand;
    double gap = 0;
    double gained = 0;
    for (int k = 0; k < std::min(by_hand.size(), curve.lambda.size()); ++k) {
      gap = std::max(gap, std::abs(by_hand[k] - curve.error[k]));
      if (k > 0) gained = std::max(gained, error_energy(curve.lambda[k]) - error_energy(curve.lambda[k - 1]));
    }
    const std::string name = which == si_curve ? "SI" : "SOR";
    // SOR remembers roundings for 1 / (1 - rho) sweeps, and more where they pile up at the best omega.
    lesson.check_small(name + ": errors as by plain loops on A λ = b", gap,
                       16 * epsilon * n * n * (which == si_curve ? 1 : 1 / (1 - run.curves[which].rate)));
    // Squares of impulses of n g dt, rounded.
    const double largest = n * gravity * time_step;
    lesson.check_small(name + ": energy of the error gained in any sweep (J)", gained,
                       16 * epsilon * n * largest * largest);
  }
}

void check_costs(Lesson& lesson, const CostRun& run) {
  int difference = 0;
  for (const SizeCost& size : run.sizes) difference = std::max(difference, std::abs(size.si - size.by_hand));
  // Counts may differ by 1 only where an error is 1 % but for rounding.
  lesson.check_small("sweeps to 1 % of 3, 5, 10, 20 boxes, against plain loops", difference, 1);
  const int n = run.settings.boxes;
  lesson.check_equal("entries of A that are not 0: 3n − 2", static_cast<double>(run.non_zeros), 3 * n - 2, 0);
}

}  // namespace

void report(Lesson& lesson, const CostRun& run) {
  lesson.print();
  print_errors(lesson, run);
  print_digits(lesson, run);
  lesson.answer(
      {static_cast<double>(sweeps_to(run.curves[sor_curve].error, 0.01))}, 8,
      "The neighbours of a contact give way to its correction, so that alone it is too small. With the "
      "best ω a sweep leaves 0.73 of the error in place of 0.98.");
  check_rates(lesson, run);
  check_curves(lesson, run);
  check_costs(lesson, run);
  check_tower(lesson, run.settings.boxes);
}

CsvTable errors_table(const CostRun& run) {
  CsvTable table{.header = {"solver", "sweep", "error", "products"}};
  for (const Curve& curve : run.curves) {
    for (int k = 0; k < curve.error.size(); k += k < 400 ? 1 : 10)
      table.rows.push_back({curve.name, k, curve.error[k], curve.work * k});
  }
  return table;
}

}  // namespace cairn::cost
