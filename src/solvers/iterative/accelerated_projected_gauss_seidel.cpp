// Floor 4. Projected Gauss-Seidel with momentum and restarts.
#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>

#include <cmath>

namespace cairn {

namespace {

/// bias - j v - softness * impulse: what row i lacks, and by how much f falls along its impulse.
template <Scalar Real>
Real row_error(const ConstraintRow<Real>& row, Real jv, Real impulse) {
  return row.bias - jv - row.softness * impulse;
}

}  // namespace

template <Scalar Real>
AcceleratedProjectedGaussSeidel<Real>::AcceleratedProjectedGaussSeidel(const SolverSettings& settings)
    : settings_(settings) {
  check(settings, "AcceleratedProjectedGaussSeidel");
}

template <Scalar Real>
SolveReport AcceleratedProjectedGaussSeidel<Real>::solve(VelocityProblem<Real>& problem,
                                                         SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  // Momentum is part of the state: impulses that repeat are no cycle.
  stopping_.begin(settings_, problem, {.seeks_cycles = false});
  prepare(problem);

  return stopping_.repeat(problem, observer, [&](int number, SolveObserver<Real>* watcher) {
    return iterate(number, problem, watcher);
  });
}

template <Scalar Real>
void AcceleratedProjectedGaussSeidel<Real>::prepare(VelocityProblem<Real>& problem) {
  k_ = 1;
  restarts_ = 0;
  effective_mass_.resize(problem.rows.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    effective_mass_[i] = effective_mass(problem, problem.rows[i]);
  }
  apply_impulses(problem);  // warm start: those of last step act before the first sweep
  impulse_before_ = problem.impulse;
}

/// One step of momentum and one sweep, or neither of them. Returns the largest change of an impulse that was
/// tried: an undone sweep is no standstill.
template <Scalar Real>
Real AcceleratedProjectedGaussSeidel<Real>::iterate(int number, VelocityProblem<Real>& problem,
                                                    SolveObserver<Real>* watcher) {
  order_rows(problem, settings_.order, settings_.seed, number, sequence_);
  velocity_before_ = problem.velocity;
  const Real gained = extrapolate(static_cast<Real>(k_ - 1) / static_cast<Real>(k_ + 2), problem);
  const Descent descent = sweep(number, problem, watcher);
  const Real change = largest_change(problem);

  const bool descends = gained + descent.change <= -descent.share / 2;
  if (k_ == 1 || descends) {
    k_ = descent.share > 0 ? k_ + 1 : 1;  // what is too small to have an energy needs no momentum
  } else {
    problem.impulse = impulse_before_;
    problem.velocity = velocity_before_;
    k_ = 1;
    ++restarts_;
  }
  return change;
}

/// Takes the impulses from p_{k-1} to y and remembers p_{k-1}. Returns by how much f has changed [J].
template <Scalar Real>
Real AcceleratedProjectedGaussSeidel<Real>::extrapolate(Real momentum, VelocityProblem<Real>& problem) {
  if (!(momentum > 0)) {
    impulse_before_ = problem.impulse;
    return 0;
  }
  Real change = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real old = problem.impulse[i];
    const Real target = row.bounds.clamp(old + momentum * (old - impulse_before_[i]), problem.impulse);
    impulse_before_[i] = old;
    if (!(effective_mass_[i] > 0)) continue;

    const Real step = target - old;
    const Real error = row_error(row, row_velocity(problem, row), old);
    change += step * (step / (2 * effective_mass_[i]) - error);
    problem.impulse[i] = target;
    apply_impulse(problem, row, step);
  }
  return change;
}

template <Scalar Real>
typename AcceleratedProjectedGaussSeidel<Real>::Descent AcceleratedProjectedGaussSeidel<Real>::sweep(
    int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher) {
  const Real omega = Real(settings_.relaxation);
  Descent descent;
  for (const int i : sequence_.rows) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real old = problem.impulse[i];
    const Real jv = row_velocity(problem, row);
    const Real error = row_error(row, jv, old);

    const Real corrective = omega * (error * effective_mass_[i]);
    problem.impulse[i] = row.bounds.clamp(old + corrective, problem.impulse);
    const Real step = problem.impulse[i] - old;
    apply_impulse(problem, row, step);

    // While its bounds stand still, error * step is at least step^2 A_ii / omega: row by row f falls.
    const Real inverse = effective_mass_[i] > 0 ? 1 / effective_mass_[i] : Real(0);
    descent.change += step * (step * inverse / 2 - error);
    descent.share += step * step * inverse * (1 / omega - Real(0.5));
    if (watcher != nullptr) {
      watcher->after_row({number, i, jv, inverse, corrective, old, problem.impulse[i]}, problem);
    }
  }
  return descent;
}

template <Scalar Real>
Real AcceleratedProjectedGaussSeidel<Real>::largest_change(const VelocityProblem<Real>& problem) const {
  Real largest = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    largest = std::max(largest, std::abs(problem.impulse[i] - impulse_before_[i]));
  }
  return largest;
}

template class AcceleratedProjectedGaussSeidel<float>;
template class AcceleratedProjectedGaussSeidel<double>;
template class AcceleratedProjectedGaussSeidel<long double>;

}  // namespace cairn
