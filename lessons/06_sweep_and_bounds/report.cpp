// Lesson 06. The sweeps in lines and rows, and what has to be true of them.
#include "lesson.hpp"

namespace cairn::sweeps {

namespace {

std::string in_brackets(double value) {
  return value < 0 ? fmt::format("({:.4g})", value) : fmt::format("{:.4g}", cleaned(value));
}

/// "(0 − (−1) × 10 − (−1) × 0) / 2 = 5": (28) with the numbers of one update, before it is clamped.
std::string row_in_numbers(const SystemMatrices<double>& system, const Swept& swept, int k) {
  const int i = swept.updates[k].row;
  std::string sum = fmt::format("{:.4g}", cleaned(system.b(i)));
  double rest = system.b(i);
  for (int j = 0; j < system.b.size(); ++j) {
    if (j == i || system.A(i, j) == 0) continue;
    const double other = k > 0 ? swept.after[k - 1][j] : 0;
    rest -= system.A(i, j) * other;
    sum += fmt::format(" − {} × {:.4g}", in_brackets(system.A(i, j)), cleaned(other));
  }
  return fmt::format("({}) / {:.4g} = {:.4f}", sum, system.A(i, i), cleaned(rest / system.A(i, i)));
}

void print_update(Lesson& lesson, const SystemMatrices<double>& system, const Swept& swept, int k,
                  int shown) {
  const RowUpdate<double>& update = swept.updates[k];
  const double after = swept.after[k][update.row];
  const bool cut = update.impulse_before + update.corrective < -1e-12;
  const std::string line =
      fmt::format("  sweep {} row {}: λ_{} = {}{}", update.sweep, update.row + 1, update.row + 1,
                  row_in_numbers(system, swept, k), cut ? fmt::format("  → clamped to {:g}", after) : "");
  lesson.print_if(k < shown, line);
}

/// [N] A system solved until rounding is off by that times its condition, which is below 4 / (1 - rate).
double rounding_of(const RodRun& rod) {
  const double largest = std::max(std::abs(rod.statics[0]), rod.statics[1]);
  return 16 * epsilon * largest * 4 / (1 - rod.rate);
}

void append_rows(CsvTable& table, const char* name, const Swept& swept, double dt) {
  for (int k = 0; k < swept.updates.size(); ++k) {
    const RowUpdate<double>& update = swept.updates[k];
    table.rows.push_back({name, update.sweep, update.row + 1, update.inverse_mass, update.row_velocity,
                          update.corrective / dt, update.impulse_before / dt, update.impulse_after / dt});
  }
}

}  // namespace

void print_scene(Lesson& lesson, const SweepSettings& settings) {
  lesson.print(fmt::format(
      "Scene: g = {:g} m/s², Δt = {:g} s; gravity is in v₁ already; {} sweeps from λ = 0, no warm start",
      gravity, settings.dt, settings.sweeps));
  if (settings.support != 1) {
    const double right = rod_mass * gravity * rod_length / 2 / settings.support;
    lesson.print(fmt::format(
        "        the right support is at {:g} m here, not at 1 m: A λ = b says {:.4g} and {:.4g} N",
        settings.support, rod_mass * gravity - right, right));
  }
}

void print_rod(Lesson& lesson, const SweepRun& run) {
  const RodRun& rod = run.rod;
  const Matrix<double>& A = rod.system.A;
  lesson.print(fmt::format("The rod: supports at 0 and {:g} m, its middle at {:g} m; I = {:g} kg m²",
                           run.settings.support, rod_length / 2, rod_inertia));
  lesson.print(fmt::format(
      "  A = [{0:.4g} {1:.4g}; {1:.4g} {2:.4g}], b = ({3:.4g}, {4:.4g}); A λ = b: λ = "
      "({5:.4g}, {6:.4g}) N",
      A(0, 0), cleaned(A(0, 1)), A(1, 1), rod.system.b(0), rod.system.b(1), rod.statics[0], rod.statics[1]));
  for (int k = 0; k < rod.bounded.updates.size(); ++k) print_update(lesson, rod.system, rod.bounded, k, 6);
  lesson.print("support   A λ = b: λ (N)   0 ≤ λ: λ (N)   w = A λ − b (m/s²)");
  for (int i = 0; i < 2; ++i) {
    const bool leaves = rod.leaving[i] > 1e-9;
    lesson.print(fmt::format("{:<7} {:>16.4f} {:>14.4f} {:>20.4f}   {}", i == 0 ? "left" : "right",
                             rod.statics[i], cleaned(rod.settled.after.back()[i]), cleaned(rod.leaving[i]),
                             leaves ? "let go: the rod leaves it" : "holds"));
  }
  lesson.print();
}

void print_intervals(Lesson& lesson) {
  lesson.print("The interval is data of the row. Clamped, −8, +4 and +8 N s become, with μ λ Δt = 6 N s:");
  for (const Interval& kind : kinds_of_rows()) {
    const PerRow<double> impulse = {10.0};
    std::string line = fmt::format("  {:<15}", kind.name);
    for (const double value : {-8.0, 4.0, 8.0})
      line += fmt::format("{:>5g}", kind.bounds.clamp(value, impulse));
    lesson.print(line + "   " + kind.reason);
  }
  lesson.print();
}

void check_rod(Lesson& lesson, const SweepRun& run) {
  const RodRun& rod = run.rod;
  const PerRow<double>& lambda = rod.settled.after.back();
  const double largest = std::max(std::abs(rod.statics[0]), rod.statics[1]);
  const double rounding = rounding_of(rod);
  lesson.check_small("the loop of lesson.cpp = the library's solver, sweep for sweep (N)",
                     std::max(rod.bounded.gap, rod.unbounded.gap), rounding);
  const PerRow<double>& pulled = rod.unbounded.after.back();
  // (enough sweeps leave 1e-17 of a first error that is no larger than twice the largest lambda)
  lesson.check_small("without clamp: forces and moments of statics (N)",
                     std::max(std::abs(pulled[0] - rod.statics[0]), std::abs(pulled[1] - rod.statics[1])),
                     rounding);
  lesson.check_small(rod.tips() ? "with clamp: λ₁ = 0, λ₂ = g / (1/m + r²/I) (N)"
                                : "with clamp: the same, for both supports push (N)",
                     std::max(std::abs(lambda[0] - rod.formula[0]), std::abs(lambda[1] - rod.formula[1])),
                     rounding);
  const double least = std::min({lambda[0], lambda[1], rod.leaving[0], rod.leaving[1]});
  const double largest_entry = std::max(rod.system.A(0, 0), rod.system.A(1, 1));
  const double complement =
      std::max(std::abs(lambda[0] * rod.leaving[0]), std::abs(lambda[1] * rod.leaving[1]));
  lesson.check_small("λ ≥ 0 and w = A λ − b ≥ 0: the least of all four", std::min(least, 0.0),
                     2 * largest_entry * rounding);
  lesson.check_small("λ w = 0: what pushes holds, what leaves does not push (N m/s²)", complement,
                     4 * largest_entry * rounding * largest);
  // The ends move as (12) says: velocities of the body, against w of the rows.
  const Vec3<double>& v = rod.settled.velocity[{1}];
  double gap = 0;
  for (int i = 0; i < 2; ++i)
    gap = std::max(gap, std::abs(v.y() + v.z() * rod.arm[i] - rod.leaving[i] * run.settings.dt));
  lesson.check_small("(12) above the supports the rod moves at w Δt (m/s)", gap,
                     32 * epsilon * largest * run.settings.dt * largest_entry);
}

CsvTable updates_table(const SweepRun& run) {
  CsvTable table{
      .header = {"system", "sweep", "row", "a_ii", "jv", "lambda_corr", "lambda_old", "lambda_new"}};
  append_rows(table, "rod", run.rod.bounded, run.settings.dt);
  append_rows(table, "rod_unbounded", run.rod.unbounded, run.settings.dt);
  return table;
}

}  // namespace cairn::sweeps
