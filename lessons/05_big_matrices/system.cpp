// The rows of a stack, its system as the library and others see it, and formulas for it.
#include "lesson.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cairn/validation/column.hpp>

namespace cairn::big {

namespace {

/// Gravity is left out of v_1, and added when all is solved.
void solve_without_gravity(StackRun& run) {
  const StackSystem still = assemble(stack_rows(run.settings, 0));
  run.lambda_without = solution_of(still);
  run.velocity_without = velocity_after(still, run.lambda_without);
  for (Eigen::Index i = 1; i < run.velocity_without.size(); i += 3) {
    run.velocity_without(i) -= gravity * run.settings.dt;
  }
}

}  // namespace

Eigen::VectorXd solution_of(const StackSystem& system) { return system.A.ldlt().solve(system.b); }

VelocityProblem<double> stack_rows(const StackSettings& settings, double pull) {
  List<double> masses(settings.boxes, 1.0);
  masses.back() = settings.top;
  return cases::column<double>(masses, pull, settings.dt);
}

void solve_otherwise(const VelocityProblem<double>& problem, StackRun& run) {
  VelocityProblem<double> copy = problem;
  ReferenceSolver<double> exact;
  exact.solve(copy);
  const int m = copy.row_count();
  run.reference.resize(m);
  run.row_velocity.resize(m);
  for (int i = 0; i < m; ++i) {
    run.reference(i) = copy.impulse[i] / copy.dt;
    run.row_velocity(i) = row_velocity(problem, problem.rows[i]);
  }
  const SystemMatrices<double> library = system_matrices(problem);
  run.library_gap = std::max((run.system.A - library.A).cwiseAbs().maxCoeff(),
                             (run.system.b - library.b).cwiseAbs().maxCoeff());
  run.mass.assign(m, 1.0);
  run.mass.back() = run.settings.top;
  run.inverse = run.system.A.ldlt().solve(Eigen::MatrixXd::Identity(m, m));
  run.eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(run.system.A).eigenvalues();
  solve_without_gravity(run);
  run.snapshot = stack_at_rest(run.boxes());
}

double mass_above(const StackRun& run, int contact) {
  double sum = 0;
  for (int i = run.boxes() - 1; i >= contact; --i) sum += run.mass[i];
  return sum;
}

double lambda_by_formula(const StackRun& run, int contact) { return mass_above(run, contact) * gravity; }

double entry_by_formula(const StackRun& run, int i, int j) {
  const auto above = [&run](int contact) { return 1 / run.mass[contact]; };
  if (i == j) return above(i) + (i > 0 ? above(i - 1) : 0.0);
  return std::abs(i - j) == 1 ? -above(std::min(i, j)) : 0.0;  // the box between the two
}

int changed_numbers(const StackRun& run, const StackRun& other) {
  return static_cast<int>((run.system.b.array() != other.system.b.array()).count());
}

}  // namespace cairn::big
