// The library's matrices, an elimination that keeps its steps, and other ways to the same answer.
#include "system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "solvers/reference_solver.hpp"

namespace cairn::big {

namespace {

/// Boxes of 1 m, one normal row for each contact. `fall`: [m/s] what gravity has done to all of them already.
VelocityProblem<double> stack_rows(const StackSettings& settings, double fall) {
  const auto n = static_cast<std::size_t>(settings.boxes);
  VelocityProblem<double> problem;
  problem.dt = settings.dt;
  problem.inverse_mass.assign(n + 1, {1, 1, 6});  // I = m (1 + 1) / 12
  problem.inverse_mass[0] = {0, 0, 0};            // the ground
  problem.inverse_mass[n] /= settings.top;
  problem.velocity.assign(n + 1, {0, -fall, 0});
  problem.velocity[0] = {0, 0, 0};
  problem.impulse.assign(n, 0.0);
  for (int contact = 0; contact < settings.boxes; ++contact) {
    ConstraintRow<double> row;
    row.a = {contact};
    row.b = {contact + 1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, 0};
    row.bias = contact == 0 ? baumgarte * settings.sunk / settings.dt : 0;
    row.bounds = Bounds<double>::unilateral();
    row.key = {.source = static_cast<std::uint64_t>(contact)};
    problem.blocks.push_back({contact, 1});
    problem.rows.push_back(row);
  }
  return problem;
}

StackSystem without_ground(const VelocityProblem<double>& problem) {
  const SystemMatrices<double> system = system_matrices(problem);
  const Eigen::Index columns = system.J.cols() - 3;
  Vector<double> velocity;
  system_velocity(problem, velocity);
  StackSystem result{.J = system.J.rightCols(columns),
                     .inverse_mass = system.inverse_mass.tail(columns),
                     .A = system.A,
                     .b = system.b,
                     .velocity = velocity.tail(columns),
                     .zeta = Eigen::VectorXd(problem.row_count())};
  for (int i = 0; i < problem.row_count(); ++i) {
    result.zeta(i) = problem.rows[static_cast<std::size_t>(i)].bias;
  }
  return result;
}

/// Gauss's elimination of [A | b], from the first row down. A is positive definite, so no rows are swapped.
std::vector<Eigen::MatrixXd> eliminate(const StackSystem& system) {
  const Eigen::Index m = system.b.size();
  Eigen::MatrixXd stage(m, m + 1);
  stage << system.A, system.b;
  std::vector<Eigen::MatrixXd> stages = {stage};
  for (Eigen::Index pivot = 0; pivot + 1 < m; ++pivot) {
    for (Eigen::Index row = pivot + 1; row < m; ++row) {
      const double factor = stage(row, pivot) / stage(pivot, pivot);
      stage.row(row) -= factor * stage.row(pivot);
      stage(row, pivot) = 0;
    }
    stages.push_back(stage);
  }
  return stages;
}

/// From the last row up: each has one unknown left.
Eigen::VectorXd substitute_back(const Eigen::MatrixXd& stage) {
  const Eigen::Index m = stage.rows();
  Eigen::VectorXd lambda(m);
  for (Eigen::Index i = m - 1; i >= 0; --i) {
    double rest = stage(i, m);
    for (Eigen::Index j = i + 1; j < m; ++j) rest -= stage(i, j) * lambda(j);
    lambda(i) = rest / stage(i, i);
  }
  return lambda;
}

/// Paper eq. (12).
Eigen::VectorXd velocity_after(const StackSystem& system, const Eigen::VectorXd& lambda, double dt) {
  const Eigen::VectorXd impulse = system.J.transpose() * lambda * dt;
  return system.velocity + system.inverse_mass.cwiseProduct(impulse);
}

Growth growth_of(int boxes) {
  const StackSystem system = without_ground(stack_rows({.boxes = boxes}, 0.2));
  Growth growth{.boxes = boxes};
  growth.all_of_J = static_cast<double>(system.J.size());
  growth.all_of_A = static_cast<double>(system.A.size());
  growth.used_of_J = static_cast<double>((system.J.array() != 0).count());
  growth.used_of_A = static_cast<double>((system.A.array() != 0).count());
  const double m = boxes;
  growth.elimination = (m * m * m - m) / 3 + m * m;
  return growth;
}

Snapshot stack_at_rest(const StackSettings& settings) {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < settings.boxes; ++i) {
    scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i - settings.sunk}, .mass = 1});
  }
  Snapshot result = snapshot(World(scene));
  for (int i = 0; i < settings.boxes; ++i) {
    result.contacts.push_back({.a = {i}, .b = {i + 1}, .position = {0, i - settings.sunk}, .normal = {0, 1}});
  }
  return result;
}

void solve_otherwise(const VelocityProblem<double>& problem, StackRun& run) {
  VelocityProblem<double> copy = problem;
  ReferenceSolver<double> exact;
  exact.solve(copy);
  const auto m = static_cast<Eigen::Index>(copy.impulse.size());
  run.reference.resize(m);
  run.row_velocity.resize(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto k = static_cast<std::size_t>(i);
    run.reference(i) = copy.impulse[k] / copy.dt;
    run.row_velocity(i) = row_velocity(problem, problem.rows[k]);
  }
}

void solve_without_gravity(StackRun& run) {
  const StackSystem still = without_ground(stack_rows(run.settings, 0));
  run.lambda_without = substitute_back(eliminate(still).back());
  run.velocity_without = velocity_after(still, run.lambda_without, run.settings.dt);
  for (Eigen::Index i = 1; i < run.velocity_without.size(); i += 3) {
    run.velocity_without(i) -= gravity * run.settings.dt;
  }
}

}  // namespace

StackRun run_stack(const StackSettings& settings) {
  StackRun run{.settings = settings};
  run.mass.assign(static_cast<std::size_t>(settings.boxes), 1.0);
  run.mass.back() = settings.top;
  const VelocityProblem<double> problem = stack_rows(settings, gravity * settings.dt);
  run.system = without_ground(problem);
  run.stages = eliminate(run.system);
  run.lambda = substitute_back(run.stages.back());
  run.velocity = velocity_after(run.system, run.lambda, settings.dt);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(settings.boxes, settings.boxes);
  run.inverse = run.system.A.ldlt().solve(identity);
  run.eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(run.system.A).eigenvalues();
  solve_otherwise(problem, run);
  solve_without_gravity(run);
  for (const int boxes : {3, 10, 30, 100, 300}) run.growth.push_back(growth_of(boxes));
  run.snapshot = stack_at_rest(settings);
  return run;
}

double mass_above(const StackRun& run, int contact) {
  double sum = 0;
  for (int i = run.boxes() - 1; i >= contact; --i) sum += run.mass[static_cast<std::size_t>(i)];
  return sum;
}

double lambda_by_formula(const StackRun& run, int contact) {
  const double zeta = baumgarte * run.settings.sunk / run.settings.dt;
  return mass_above(run, contact) * (gravity + zeta / run.settings.dt);
}

double entry_by_formula(const StackRun& run, int i, int j) {
  const auto above = [&run](int contact) { return 1 / run.mass[static_cast<std::size_t>(contact)]; };
  if (i == j) return above(i) + (i > 0 ? above(i - 1) : 0.0);
  return std::abs(i - j) == 1 ? -above(std::min(i, j)) : 0.0;  // the box between the two
}

}  // namespace cairn::big
