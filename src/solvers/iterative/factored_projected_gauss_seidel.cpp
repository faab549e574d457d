// Floor 4. E. Catto's form of section 2: A is never multiplied out.
#include <cairn/solvers/iterative/factored_projected_gauss_seidel.hpp>

#include <cmath>

namespace cairn {

template <Scalar Real>
FactoredProjectedGaussSeidel<Real>::FactoredProjectedGaussSeidel(const SolverSettings& settings)
    : settings_(settings) {
  check(settings, "FactoredProjectedGaussSeidel");
}

template <Scalar Real>
SolveReport FactoredProjectedGaussSeidel<Real>::solve(VelocityProblem<Real>& problem,
                                                      SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);
  build(problem);

  return stopping_.repeat_rows(
      problem, observer, sequence_,
      [&](int number, SolveObserver<Real>* watcher) { return sweep(number, problem, watcher); },
      [&] { update_velocity(problem); });
}

/// The rows of J and M^-1 J^T, b (15), and a = M^-1 J^T lambda for the lambda to start from (2.3).
template <Scalar Real>
void FactoredProjectedGaussSeidel<Real>::build(const VelocityProblem<Real>& problem) {
  velocity_ = problem.velocity;
  acceleration_.assign(problem.velocity.size(), Vec3<Real>::Zero());
  rows_.resize(problem.rows.size());
  for (int i = 0; i < rows_.size(); ++i) {
    const ConstraintRow<Real>& source = problem.rows[i];
    FactoredRow& row = rows_[i];
    row.body_a = source.a;
    row.body_b = source.b;
    row.first_extra = source.first_extra;
    row.extra_count = source.extra_count;
    row.jacobian_a = source.jacobian_a;
    row.jacobian_b = source.jacobian_b;
    row.response_a = problem.inverse_mass[row.body_a].cwiseProduct(row.jacobian_a);
    row.response_b = problem.inverse_mass[row.body_b].cwiseProduct(row.jacobian_b);
    row.softness = source.softness;
    row.effective_mass = effective_mass(problem, source);
    row.b = (source.bias - row_velocity(problem, source)) / problem.dt;
    row.lambda = problem.impulse[i] / problem.dt;
    accelerate(problem, i, row.lambda);
  }
}

/// a += M^-1 j^T lambda, on the row's two bodies, and on further ones where there are any.
template <Scalar Real>
void FactoredProjectedGaussSeidel<Real>::accelerate(const VelocityProblem<Real>& problem, int i,
                                                    Real lambda) {
  const FactoredRow& row = rows_[i];
  acceleration_[row.body_a] += row.response_a * lambda;
  acceleration_[row.body_b] += row.response_b * lambda;
  for_each_extra_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
    acceleration_[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * lambda;
  });
}

template <Scalar Real>
Real FactoredProjectedGaussSeidel<Real>::sweep(int number, VelocityProblem<Real>& problem,
                                               SolveObserver<Real>* watcher) {
  const Real omega = Real(settings_.relaxation);
  Real largest_change = 0;
  for (const int i : sequence_.rows) {
    FactoredRow& row = rows_[i];

    // (28) rearranged as in (29), with j a for the sums over J M^-1 J^T.
    Real ja = dot(row.jacobian_a, acceleration_[row.body_a]) + dot(row.jacobian_b, acceleration_[row.body_b]);
    for_each_extra_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      ja += dot(jacobian, acceleration_[body]);
    });
    const Real row_error = row.b - ja - row.softness * row.lambda;
    const Real corrective = omega * (row_error * row.effective_mass);
    const Real old = problem.impulse[i];
    const Real wish = (row.lambda + corrective) * problem.dt;
    problem.impulse[i] = problem.rows[i].bounds.clamp(wish, problem.impulse);
    const Real lambda = problem.impulse[i] / problem.dt;
    accelerate(problem, i, lambda - row.lambda);
    row.lambda = lambda;

    largest_change = std::max(largest_change, std::abs(problem.impulse[i] - old));
    if (watcher != nullptr) {
      const Real jv = problem.rows[i].bias - row.softness * old - row_error * problem.dt;
      const Real inverse = row.effective_mass > 0 ? 1 / row.effective_mass : Real(0);
      update_velocity(problem);
      watcher->after_row({number, i, jv, inverse, corrective * problem.dt, old, problem.impulse[i]}, problem);
    }
  }
  return largest_change;
}

/// (12): v_2 = v_1 + a dt.
template <Scalar Real>
void FactoredProjectedGaussSeidel<Real>::update_velocity(VelocityProblem<Real>& problem) const {
  for (const BodyId body : velocity_.indices()) {
    problem.velocity[body] = velocity_[body] + acceleration_[body] * problem.dt;
  }
}

template <Scalar Real>
std::size_t FactoredProjectedGaussSeidel<Real>::memory() const {
  return rows_.bytes() + acceleration_.bytes() + velocity_.bytes();
}

template class FactoredProjectedGaussSeidel<float>;
template class FactoredProjectedGaussSeidel<double>;

}  // namespace cairn
