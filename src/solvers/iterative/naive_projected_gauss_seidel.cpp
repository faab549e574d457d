// Floor 4. The paper's "if implemented naively" (4.4), for comparison only.
#include <cairn/solvers/iterative/naive_projected_gauss_seidel.hpp>

#include <cmath>
#include <stdexcept>

namespace cairn {

template <Scalar Real>
NaiveProjectedGaussSeidel<Real>::NaiveProjectedGaussSeidel(const SolverSettings& settings)
    : settings_(settings) {
  check(settings, "NaiveProjectedGaussSeidel");
}

template <Scalar Real>
SolveReport NaiveProjectedGaussSeidel<Real>::solve(VelocityProblem<Real>& problem,
                                                   SolveObserver<Real>* observer) {
  if (problem.row_count() > max_rows) {
    throw std::length_error("NaiveProjectedGaussSeidel: sweeps over " + std::to_string(problem.row_count()) +
                            " rows, above the limit of " + std::to_string(max_rows) +
                            ", take time with their square; SequentialImpulse needs time linear in the rows");
  }
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);

  velocity_ = problem.velocity;
  inverse_mass_.resize(problem.rows.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    inverse_mass_[i] = inverse_effective_mass(problem, problem.rows[i]);
  }
  recompute_velocity(problem);  // warm start (2.3): the impulses that are there already act

  return stopping_.repeat_rows(problem, observer, sequence_, [&](int number, SolveObserver<Real>* watcher) {
    return sweep(number, problem, watcher);
  });
}

template <Scalar Real>
Real NaiveProjectedGaussSeidel<Real>::sweep(int number, VelocityProblem<Real>& problem,
                                            SolveObserver<Real>* watcher) {
  const Real omega = Real(settings_.relaxation);
  Real largest_change = 0;
  for (const int i : sequence_.rows) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real jv = row_velocity(problem, row);
    const Real old = problem.impulse[i];

    // b - A lambda of (28), times dt: read from the velocity, which holds (12).
    const Real row_error = row.bias - jv - row.softness * old;
    const Real corrective = inverse_mass_[i] > 0 ? omega * (row_error / inverse_mass_[i]) : Real(0);
    problem.impulse[i] = row.bounds.clamp(old + corrective, problem.impulse);
    recompute_velocity(problem);

    largest_change = std::max(largest_change, std::abs(problem.impulse[i] - old));
    if (watcher != nullptr) {
      watcher->after_row({number, i, jv, inverse_mass_[i], corrective, old, problem.impulse[i]}, problem);
    }
  }
  return largest_change;
}

/// (12): v_2 = v_1 + M^-1 J^T lambda dt, of all bodies from all rows.
template <Scalar Real>
void NaiveProjectedGaussSeidel<Real>::recompute_velocity(VelocityProblem<Real>& problem) const {
  problem.velocity = velocity_;
  apply_impulses(problem);
}

template class NaiveProjectedGaussSeidel<float>;
template class NaiveProjectedGaussSeidel<double>;

}  // namespace cairn
