// Floor 4. Other ways into a problem, and whether they end elsewhere.
#include <cairn/solvers/exact/other_answers.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/solvers/exact/newton.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Of rows, in sqrt(J): what ExactRows::size is.
long double largest_row_speed(const VelocityProblem<long double>& problem) {
  long double largest = 0;
  for (const ConstraintRow<long double>& row : problem.rows) {
    const long double mass = effective_mass(problem, row);
    largest = std::max(largest, std::sqrt(mass) * std::abs(row_velocity(problem, row) - row.bias));
  }
  return largest;
}

/// sqrt(dv^T M dv)
long double kinetic_distance(const VelocityProblem<long double>& problem, const PerBody<Vec3<long double>>& a,
                             const PerBody<Vec3<long double>>& b) {
  long double sum = 0;
  for (const BodyId body : a.indices()) {
    for (int axis = 0; axis < 3; ++axis) {
      const long double inverse = problem.inverse_mass[body](axis), change = a[body](axis) - b[body](axis);
      if (inverse > 0) sum += change * change / inverse;
    }
  }
  return std::sqrt(sum);
}

/// Some times as much as the speeds call for, as between walls that were driven in; no friction yet.
void press_rows(VelocityProblem<long double>& problem, int number, long double speed) {
  const Vector<long double> cover = other_cover(problem.rows.size(), number);
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<long double>& row = problem.rows[i];
    const long double mass = effective_mass(problem, row);
    const long double press = 4 * cover(i) * speed * std::sqrt(mass);
    problem.impulse[i] = row.bounds.is_friction() ? 0.0L : press;
  }
}

}  // namespace

Vector<long double> other_cover(Eigen::Index size, int number) {
  Vector<long double> cover(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const long double turn = static_cast<long double>((i + 1) * (2 * number + 1)) * 0.6180339887498948482L;
    cover(i) = 0.5L + turn - std::floor(turn);
  }
  return cover;
}

int count_newton_answers(const VelocityProblem<long double>& problem, const PerBody<Vec3<long double>>& known,
                         int starts) {
  const long double speed = largest_row_speed(problem);
  List<PerBody<Vec3<long double>>> answers = {known};
  for (int k = 1; k <= starts; ++k) {
    VelocityProblem<long double> other = problem;
    press_rows(other, k, speed);
    const NewtonResult result = newton(other, {.iterations = 1000, .restarts = 0, .sweeps = 0});
    if (!(result.residual <= exact_residual)) continue;
    const bool is_known = std::any_of(answers.begin(), answers.end(), [&](const auto& velocity) {
      return kinetic_distance(problem, velocity, other.velocity) <= distinct_velocity * speed;
    });
    if (!is_known) answers.push_back(other.velocity);
  }
  return answers.size();
}

}  // namespace cairn
