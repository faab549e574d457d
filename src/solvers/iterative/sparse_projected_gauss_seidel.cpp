// Floor 4. Section 2 of the paper with the optimisation of 2.3: only what is not zero.
#include <cairn/solvers/iterative/sparse_projected_gauss_seidel.hpp>

#include <cmath>
#include <stdexcept>

namespace cairn {

template <Scalar Real>
SparseProjectedGaussSeidel<Real>::SparseProjectedGaussSeidel(const SolverSettings& settings)
    : settings_(settings) {
  check(settings, "SparseProjectedGaussSeidel");
}

template <Scalar Real>
SolveReport SparseProjectedGaussSeidel<Real>::solve(VelocityProblem<Real>& problem,
                                                    SolveObserver<Real>* observer) {
  body_rows_.build(problem, problem.inverse_mass);
  if (body_rows_.pairs() > max_pairs) {
    throw std::length_error("SparseProjectedGaussSeidel: " + std::to_string(body_rows_.pairs()) +
                            " pairs of rows on a body are above the limit of " + std::to_string(max_pairs) +
                            "; SequentialImpulse needs memory linear in the rows");
  }
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);
  build(problem);

  return stopping_.repeat_rows(
      problem, observer, sequence_,
      [&](int number, SolveObserver<Real>* watcher) { return sweep(number, problem, watcher); },
      [&] { update_velocity(problem); });
}

/// A and b (15), and the lambda to start from.
template <Scalar Real>
void SparseProjectedGaussSeidel<Real>::build(const VelocityProblem<Real>& problem) {
  velocity_ = problem.velocity;
  first_.assign(1, 0);
  entry_.clear();
  column_.clear();
  entry_.reserve(body_rows_.pairs());
  column_.reserve(body_rows_.pairs());
  diagonal_.resize(problem.rows.size());
  b_.resize(problem.rows.size());
  lambda_.resize(problem.rows.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    diagonal_[i] = coupling(problem, row, row, problem.inverse_mass) + row.softness;
    body_rows_.append_neighbours(i, column_);
    if (column_.size() == first_.back()) column_.push_back(i);  // acts on nothing: softness may be there
    for (std::ptrdiff_t k = first_.back(); k < column_.size(); ++k) {
      const ConstraintRow<Real>& other = problem.rows[column_[k]];
      entry_.push_back(column_[k] == i ? diagonal_[i] : coupling(problem, row, other, problem.inverse_mass));
    }
    first_.push_back(column_.size());
    b_[i] = (row.bias - row_velocity(problem, row, velocity_)) / problem.dt;
    lambda_[i] = problem.impulse[i] / problem.dt;  // warm start (2.3)
  }
}

template <Scalar Real>
Real SparseProjectedGaussSeidel<Real>::sweep(int number, VelocityProblem<Real>& problem,
                                             SolveObserver<Real>* watcher) {
  const Real omega = Real(settings_.relaxation);
  Real largest_change = 0;
  for (const int i : sequence_.rows) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real row_error = b_[i] - row_product(i);  // (28) rearranged as in (29)
    const Real corrective = diagonal_[i] > 0 ? omega * (row_error / diagonal_[i]) : Real(0);
    const Real old = problem.impulse[i];
    problem.impulse[i] = row.bounds.clamp((lambda_[i] + corrective) * problem.dt, problem.impulse);
    lambda_[i] = problem.impulse[i] / problem.dt;

    largest_change = std::max(largest_change, std::abs(problem.impulse[i] - old));
    if (watcher != nullptr) {
      const Real jv = row.bias - row.softness * old - row_error * problem.dt;
      update_velocity(problem);
      watcher->after_row({number, i, jv, diagonal_[i], corrective * problem.dt, old, problem.impulse[i]},
                         problem);
    }
  }
  return largest_change;
}

/// Row i of A times lambda.
template <Scalar Real>
Real SparseProjectedGaussSeidel<Real>::row_product(int i) const {
  Real sum = 0;
  for (std::ptrdiff_t k = first_[i]; k < first_[i + 1]; ++k) {
    sum += entry_[k] * lambda_[column_[k]];
  }
  return sum;
}

/// (12): v_2 = v_1 + M^-1 J^T lambda dt, row after row.
template <Scalar Real>
void SparseProjectedGaussSeidel<Real>::update_velocity(VelocityProblem<Real>& problem) const {
  problem.velocity = velocity_;
  apply_impulses(problem);
}

template <Scalar Real>
std::size_t SparseProjectedGaussSeidel<Real>::memory() const {
  return body_rows_.memory() + first_.bytes() + entry_.bytes() + column_.bytes() + diagonal_.bytes() +
         b_.bytes() + lambda_.bytes() + velocity_.bytes();
}

template class SparseProjectedGaussSeidel<float>;
template class SparseProjectedGaussSeidel<double>;

}  // namespace cairn
