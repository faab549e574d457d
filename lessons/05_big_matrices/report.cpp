// Lesson 05. The matrices in lines and rows, and what has to be true of them.
#include "lesson.hpp"

namespace cairn::big {

void print_scene(Lesson& lesson, const StackRun& run) {
  lesson.print(fmt::format(
      "Scene: {} unit boxes on the ground, the uppermost of {:g} kg, the others of 1 kg; g = {:g} m/s², "
      "Δt = {:.4g} s",
      run.boxes(), run.settings.top, gravity, run.settings.dt));
  lesson.print(
      fmt::format("       one normal row for each contact; gravity is in v₁ already: all fall at {:.4g} m/s",
                  gravity * run.settings.dt));
}

void print_matrices(Lesson& lesson, const StackRun& run) {
  const int n = run.boxes();
  std::string diagonal = "M⁻¹ = diag(";
  for (int box = 0; box < n; ++box) {
    const Eigen::Index k = 3 * box;
    diagonal += fmt::format("{}{:g}, {:g}, {:g}", box > 0 ? " | " : "", run.system.inverse_mass(k),
                            run.system.inverse_mass(k + 1), run.system.inverse_mass(k + 2));
  }
  lesson.print(diagonal + ")   1/m, 1/m, 1/I of each box");
  std::string head = "row  J: x  y  θ";
  for (int box = 2; box <= n; ++box) head += " |  x  y  θ";
  lesson.print(head + fmt::format("    A{:{}}b (m/s²)", "", 7 * n + 1));
  for (int i = 0; i < n; ++i) {
    std::string line = fmt::format("{:>3}    ", i + 1);
    for (int k = 0; k < 3 * n; ++k)
      line += fmt::format("{}{:>2g} ", k > 0 && k % 3 == 0 ? "| " : "", cleaned(run.system.J(i, k)));
    for (int j = 0; j < n; ++j) line += fmt::format("{:>7.4g}", cleaned(run.system.A(i, j)));
    lesson.print(line + fmt::format("{:>12.4f}", cleaned(run.system.b(i))));
  }
  lesson.print();
}

void print_right_side(Lesson& lesson, const StackRun& run, const StackRun& heavy) {
  for (int i = 0; i < run.boxes(); ++i) {
    const double jv = run.row_velocity(i);
    lesson.print(fmt::format("(15) b_{} = ζ/Δt − j·v₁/Δt = {:.4g}/{:.4g} − ({:.4g})/{:.4g} = {:.4g} m/s²",
                             i + 1, run.system.zeta(i), run.settings.dt, cleaned(jv), run.settings.dt,
                             cleaned(run.system.b(i))));
  }
  std::string b, lambda;
  for (int i = 0; i < heavy.boxes(); ++i) {
    b += fmt::format("{}{:.4g}", i > 0 ? ", " : "", cleaned(heavy.system.b(i)));
    lambda += fmt::format("{}{:.4g}", i > 0 ? ", " : "", heavy.lambda(i));
  }
  lesson.print(fmt::format("with {:g} kg on top: b = ({}) m/s², λ = ({}) N", heavy_mass, b, lambda));
  lesson.print();
}

void print_solution(Lesson& lesson, const StackRun& run) {
  const int n = run.boxes();
  lesson.print(fmt::format("(14), solved: A⁻¹ (kg){:{}}λ (N)   (12): v₂ (m/s)", "", std::max(1, 7 * n - 14)));
  for (int i = 0; i < n; ++i) {
    std::string line = "     ";
    for (int j = 0; j < n; ++j) line += fmt::format("{:>7.4g}", run.inverse(i, j));
    lesson.print(line + fmt::format("{:>15.4f} {:>14.4f}", run.lambda(i), cleaned(run.velocity(3 * i + 1))));
  }
  lesson.print();
}

namespace {

/// J, A and b against rows, formulas and the library.
void check_entries(Lesson& lesson, const StackRun& run) {
  const StackSystem& system = run.system;
  // Each is a sum of two products, the same in both; a third for what is not touched.
  lesson.check_small("J v₁ of the matrix = j·v₁ of each row (m/s)",
                     (system.J * system.velocity - run.row_velocity).cwiseAbs().maxCoeff(),
                     8 * epsilon * gravity * run.settings.dt);
  // b: a difference and a quotient of g dt.
  lesson.check_small("the library's A (kg⁻¹) and b (m/s²): the largest difference", run.library_gap,
                     8 * epsilon * (system.A.cwiseAbs().maxCoeff() + system.b.cwiseAbs().maxCoeff()));
  double gap = 0;
  for (int i = 0; i < run.boxes(); ++i)
    for (int j = 0; j < run.boxes(); ++j)
      gap = std::max(gap, std::abs(system.A(i, j) - entry_by_formula(run, i, j)));
  // Two divisions, a sum.
  lesson.check_small("A: Σ 1/m of a row's boxes, −1/m of the box between two (kg⁻¹)", gap,
                     4 * epsilon * system.A.cwiseAbs().maxCoeff());
}

void check_inverse(Lesson& lesson, const StackRun& run) {
  const StackSystem& system = run.system;
  const int n = run.boxes();
  double inverse_gap = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      inverse_gap = std::max(inverse_gap, std::abs(run.inverse(i, j) - mass_above(run, std::max(i, j))));
  const double condition = run.eigenvalues(n - 1) / run.eigenvalues(0);
  // A direct solution is as good as rounding times the condition number, times a few for each row.
  const double solved = 8 * n * epsilon * condition;
  lesson.check_small("A⁻¹: the mass above the higher of two contacts (kg)", inverse_gap,
                     solved * mass_above(run, 0));
  lesson.check_that("A is symmetric and positive definite: least eigenvalue (kg⁻¹)",
                    system.A == system.A.transpose() && run.eigenvalues(0) > 0,
                    fmt::format("{:.4g}", run.eigenvalues(0)));
}

}  // namespace

void check_matrices(Lesson& lesson, const StackRun& run) {
  check_entries(lesson, run);
  check_inverse(lesson, run);
}

namespace {

/// (1), (8), (12) and (13), each by itself.
void check_system(Lesson& lesson, const StackRun& run, double solved, double remainder) {
  const StackSystem& system = run.system;
  const double fall = gravity * run.settings.dt;
  double stacked = std::abs(static_cast<double>(system.velocity.size()) - 3.0 * run.boxes());
  double missing = 0, moved = 0;
  Eigen::VectorXd lambda(run.boxes());
  for (int i = 0; i < run.boxes(); ++i) {
    stacked = std::max(stacked, (system.velocity.segment<3>(3 * i) - Eigen::Vector3d(0, -fall, 0)).norm());
    const double rate = system.J.row(i).dot(system.velocity) - system.zeta(i);
    missing = std::max(missing, std::abs(rate - (i == 0 ? -fall : 0)));
    moved = std::max(moved, std::abs(run.velocity(3 * i + 1)));
    lambda(i) = lambda_by_formula(run, i);
  }
  lesson.check_small("(1) v: 0, −g Δt and 0 of each box, below each other (m/s)", stacked, 0);
  lesson.check_small("(8) J v₁ − ζ: −g Δt at the ground, 0 above (m/s)", missing, 8 * epsilon * fall);
  lesson.check_small("(12) v₂ = v₁ + M⁻¹ Jᵀ λ Δt: every box stands still (m/s)", moved,
                     remainder * run.boxes() + solved * run.settings.dt);
  const Eigen::VectorXd left = system.J * system.inverse_mass.asDiagonal() * system.J.transpose() * lambda;
  const Eigen::VectorXd right = (system.zeta - system.J * system.velocity) / run.settings.dt;
  lesson.check_small("(13) J M⁻¹ Jᵀ λ = (ζ − J v₁) / Δt, with λ by the formula (m/s²)",
                     (left - right).cwiseAbs().maxCoeff(), remainder / run.settings.dt);
}

}  // namespace

void check_solution(Lesson& lesson, const StackRun& run) {
  const StackSystem& system = run.system;
  const int n = run.boxes();
  const double dt = run.settings.dt;
  double gap = 0;
  for (int i = 0; i < n; ++i) gap = std::max(gap, std::abs(run.lambda(i) - lambda_by_formula(run, i)));
  const double largest = lambda_by_formula(run, 0);
  const double condition = run.eigenvalues(n - 1) / run.eigenvalues(0);
  const double solved = 8 * n * epsilon * condition * largest;  // as above
  lesson.check_small("λ = mass above × g (N)", gap, solved);
  lesson.check_small("the library's exact solver, on rows of six numbers (N)",
                     (run.lambda - run.reference).cwiseAbs().maxCoeff(), solved);
  // The remainder of an elimination is of the size of its roundings, whatever the condition number.
  const double remainder = 16 * n * epsilon * run.eigenvalues(n - 1) * largest * dt;
  lesson.check_small("(11) J v₂ = ζ (m/s)", (system.J * run.velocity - system.zeta).cwiseAbs().maxCoeff(),
                     remainder);
  check_system(lesson, run, solved, remainder);
  lesson.check_equal("gravity not in v₁: λ₁ holds nothing up (N)", run.lambda_without(0), 0, solved);
  lesson.check_equal("and the lowest box meets the ground g Δt faster than it should (m/s)",
                     system.zeta(0) - system.J.row(0).dot(run.velocity_without), gravity * dt,
                     remainder + 16 * epsilon * gravity * dt);
}

void check_question(Lesson& lesson, const StackRun& run, const StackRun& heavy) {
  lesson.check_small(fmt::format("{:g} kg on top: numbers of b that change", heavy_mass),
                     changed_numbers(run, heavy), 0);
  const int n = heavy.boxes();
  const double condition = heavy.eigenvalues(n - 1) / heavy.eigenvalues(0);
  lesson.check_equal(fmt::format("{:g} kg on top: λ₁ = mass above × g (N)", heavy_mass), heavy.lambda(0),
                     lambda_by_formula(heavy, 0), 8 * n * epsilon * condition * lambda_by_formula(heavy, 0));
}

CsvTable entries_table(const StackRun& run) {
  CsvTable table{.header = {"matrix", "row", "column", "value"}};
  const auto add = [&table](const char* name, const Eigen::MatrixXd& matrix) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        table.rows.push_back({name, i + 1, j + 1, matrix(i, j)});
      }
    }
  };
  add("J", run.system.J);
  add("inverse_mass", run.system.inverse_mass);
  add("A", run.system.A);
  add("b", run.system.b);
  add("lambda", run.lambda);
  add("velocity_before", run.system.velocity);
  add("velocity_after", run.velocity);
  return table;
}

}  // namespace cairn::big
