// The stack as a problem by hand, and two independent accounts of its solve.
#include "lesson.hpp"

#include <numeric>

#include "lessons/kit/random.hpp"
#include <cairn/validation/column.hpp>

namespace cairn::stack {

namespace {

PerRow<int> visiting_order(const StackSettings& settings) {
  PerRow<int> order(settings.boxes);
  std::iota(order.begin(), order.end(), 0);
  if (settings.order == "down") std::reverse(order.begin(), order.end());
  if (settings.order == "shuffle") {
    Random random(settings.seed);
    for (int i = settings.boxes - 1; i > 0; --i) {
      std::swap(order[i], order[random.below(i + 1)]);
    }
  }
  return order;
}

/// Boxes that gravity has just made fall, one normal row per interface with j = (0, -1, 0 | 0, 1, 0), and
/// nothing else. Row k is the k-th in visiting order.
VelocityProblem<double> stack_problem(const StackSettings& settings, const PerRow<int>& interface_of_row) {
  const List<double> masses(settings.boxes, 1.0);
  const VelocityProblem<double> upwards = cases::column<double>(masses, settings.gravity, settings.dt);
  VelocityProblem<double> problem = upwards;
  for (int k = 0; k < interface_of_row.size(); ++k) problem.rows[k] = upwards.rows[interface_of_row[k]];
  return problem;
}

}  // namespace

StackRun falling_stack(const StackSettings& settings) {
  StackRun run{.settings = settings, .interface_of_row = visiting_order(settings)};
  run.problem = stack_problem(settings, run.interface_of_row);
  for (int i = 0; i < settings.boxes; ++i) run.exact.push_back((settings.boxes - i) * settings.gravity);
  run.snapshot = stack_at_rest(settings.boxes);
  return run;
}

List<double> box_velocities(const PerBody<Vec3<double>>& velocity) {
  List<double> result;
  for (const BodyId body : velocity.indices()) {
    if (body != ground) result.push_back(velocity[body].y());
  }
  return result;
}

List<double> velocities_after(const StackRun& run, int sweep) {
  if (sweep == 0) return box_velocities(run.problem.velocity);
  return box_velocities(run.updates[sweep * run.settings.boxes - 1].velocity);
}

List<double> lambda_after(const StackRun& run, int sweep) {
  List<double> lambda(run.exact.size(), 0.0);
  for (int row = 0; row < lambda.size(); ++row) {
    lambda[run.interface_of_row[row]] = run.sweeps[sweep][row] / run.settings.dt;
  }
  return lambda;
}

List<PerRow<double>> gauss_seidel(const VelocityProblem<double>& problem, int sweeps) {
  const SystemMatrices<double> system = system_matrices(problem);
  const Eigen::Index m = system.b.size();
  PerRow<double> lambda(m, 0.0);
  List<PerRow<double>> history(1, lambda);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Eigen::Index i = 0; i < m; ++i) {
      double rest = system.b(i);
      for (Eigen::Index j = 0; j < m; ++j) {
        if (j != i) rest -= system.A(i, j) * lambda[j];
      }
      lambda[i] = std::max(rest / system.A(i, i), 0.0);
    }
    history.push_back(lambda);
  }
  return history;
}

double error_factor(int boxes) {
  const double c = std::cos(pi / (2 * boxes));
  return boxes == 1 ? 0 : c * c;
}

double measured_error_factor(const StackSettings& settings) {
  // So many sweeps that a millionth of the error is left: slow enough to forget the other errors, and far
  // above rounding.
  const double factor = error_factor(settings.boxes);
  const int sweeps = factor > 0 ? static_cast<int>(std::ceil(std::log(1e-6) / std::log(factor))) : 2;
  const StackRun run = falling_stack(settings);
  const auto error_after = [&run](int count) {
    VelocityProblem<double> problem = run.problem;
    SequentialImpulse({.iterations = count}).solve(problem);
    double sum = 0;
    for (int row = 0; row < problem.impulse.size(); ++row) {
      const double exact = run.exact[run.interface_of_row[row]];
      const double error = problem.impulse[row] / problem.dt - exact;
      sum += error * error;
    }
    return std::sqrt(sum);
  };
  const double before = error_after(sweeps - 1);
  return before > 0 ? error_after(sweeps) / before : 0;
}

}  // namespace cairn::stack
