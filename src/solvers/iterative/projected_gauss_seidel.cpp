// Floor 4. Section 2 of the paper: A lambda = b by projected Gauss-Seidel.
#include <cairn/solvers/iterative/projected_gauss_seidel.hpp>

#include <cmath>
#include <stdexcept>

namespace cairn {

template <Scalar Real>
ProjectedGaussSeidel<Real>::ProjectedGaussSeidel(const SolverSettings& settings) : settings_(settings) {
  check(settings, "ProjectedGaussSeidel");
}

template <Scalar Real>
SolveReport ProjectedGaussSeidel<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (problem.row_count() > max_rows) {
    throw std::length_error("ProjectedGaussSeidel: a dense A of " + std::to_string(problem.row_count()) +
                            " rows is above the limit of " + std::to_string(max_rows) +
                            "; SequentialImpulse needs memory linear in the rows");
  }
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);

  system_matrices(problem, system_);
  system_velocity(problem, velocity_);
  lambda_.resize(problem.row_count());
  for (int i = 0; i < problem.row_count(); ++i) {
    lambda_(i) = problem.impulse[i] / problem.dt;  // warm start (2.3)
  }

  return stopping_.repeat_rows(
      problem, observer, sequence_,
      [&](int number, SolveObserver<Real>* watcher) { return sweep(number, problem, watcher); },
      [&] { update_velocity(problem); });
}

template <Scalar Real>
std::size_t ProjectedGaussSeidel<Real>::memory() const {
  const Eigen::Index numbers = system_.J.size() + system_.inverse_mass.size() + system_.A.size() +
                               system_.b.size() + lambda_.size() + velocity_.size();
  return static_cast<std::size_t>(numbers) * sizeof(Real);
}

template <Scalar Real>
Real ProjectedGaussSeidel<Real>::sweep(int number, VelocityProblem<Real>& problem,
                                       SolveObserver<Real>* watcher) {
  const Real omega = Real(settings_.relaxation);
  Real largest_change = 0;
  for (const int index : sequence_.rows) {
    const ConstraintRow<Real>& row = problem.rows[index];
    const Real A_ii = system_.A(index, index);

    // (28) rearranged as in (29). A is symmetric: its column is its row, and lies together in memory.
    const Real row_error = system_.b(index) - system_.A.col(index).dot(lambda_);
    const Real corrective = A_ii > 0 ? omega * (row_error / A_ii) : Real(0);
    const Real old = problem.impulse[index];
    problem.impulse[index] = row.bounds.clamp((lambda_(index) + corrective) * problem.dt, problem.impulse);
    lambda_(index) = problem.impulse[index] / problem.dt;

    largest_change = std::max(largest_change, std::abs(problem.impulse[index] - old));
    if (watcher != nullptr) {
      const Real jv = row.bias - row.softness * old - row_error * problem.dt;
      update_velocity(problem);
      watcher->after_row({number, index, jv, A_ii, corrective * problem.dt, old, problem.impulse[index]},
                         problem);
    }
  }
  return largest_change;
}

/// (12): v_2 = v_1 + M^-1 J^T lambda dt, where the problem keeps its velocities.
template <Scalar Real>
void ProjectedGaussSeidel<Real>::update_velocity(VelocityProblem<Real>& problem) const {
  static_assert(sizeof(Vec3<Real>) == 3 * sizeof(Real), "velocities must lie as one column");
  if (problem.velocity.empty()) return;
  Eigen::Map<Vector<Real>> v(problem.velocity.front().data(), velocity_.size());
  v.noalias() = system_.J.transpose() * lambda_;
  v = velocity_ + system_.inverse_mass.cwiseProduct(v) * problem.dt;
}

template class ProjectedGaussSeidel<float>;
template class ProjectedGaussSeidel<double>;
template class ProjectedGaussSeidel<long double>;

}  // namespace cairn
