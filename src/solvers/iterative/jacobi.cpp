// Floor 4. Jacobi's method, plain, damped, or with split masses.
#include <cairn/solvers/iterative/jacobi.hpp>

#include <cmath>

namespace cairn {

namespace {

template <Scalar Real>
void count_rows(const VelocityProblem<Real>& problem, Splitting splitting, PerBody<int>& rows_on_body) {
  const bool whole = splitting == Splitting::none;
  rows_on_body.assign(problem.velocity.size(), whole ? 1 : 0);
  if (whole) return;
  for (const ConstraintRow<Real>& row : problem.rows) {
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      if (!jacobian.isZero(Real(0))) ++rows_on_body[body];
    });
  }
}

}  // namespace

template <Scalar Real>
void prepare_jacobi(const VelocityProblem<Real>& problem, Real relaxation, Splitting splitting,
                    PerBody<int>& rows_on_body, PerRow<Real>& step) {
  count_rows(problem, splitting, rows_on_body);
  step.resize(problem.rows.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    Real inverse = row.softness;
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      inverse +=
          Real(rows_on_body[body]) * dot<Real>(jacobian, problem.inverse_mass[body].cwiseProduct(jacobian));
    });
    // Between two immovable bodies nothing can be done.
    step[i] = inverse > 0 ? relaxation / inverse : Real(0);
  }
}

template <Scalar Real>
Jacobi<Real>::Jacobi(const SolverSettings& settings, Splitting splitting)
    : settings_(settings), splitting_(splitting) {
  check(settings, "Jacobi");
  settings_.order = RowOrder::as_written;  // whatever was asked for: it changes nothing here
}

template <Scalar Real>
std::string Jacobi<Real>::name() const {
  return splitting_ == Splitting::mass ? "mass-splitting Jacobi" : "Jacobi";
}

template <Scalar Real>
SolveReport Jacobi<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);
  prepare_jacobi(problem, Real(settings_.relaxation), splitting_, rows_on_body_, step_);
  new_impulse_.resize(problem.rows.size());
  apply_impulses(problem);  // warm start: those of last step act before the first sweep

  return stopping_.repeat(problem, observer, [&](int number, SolveObserver<Real>* watcher) {
    return sweep(number, problem, watcher);
  });
}

template <Scalar Real>
Real Jacobi<Real>::sweep(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher) {
  // Everything is read here, and nothing is written that another row reads ...
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real jv = row_velocity(problem, row);
    const Real old = problem.impulse[i];
    const Real corrective = (row.bias - jv - row.softness * old) * step_[i];
    new_impulse_[i] = row.bounds.clamp(old + corrective, problem.impulse);
    if (watcher != nullptr) {
      const Real inverse = inverse_effective_mass(problem, row);
      watcher->after_row({number, i, jv, inverse, corrective, old, new_impulse_[i]}, problem);
    }
  }

  // ... and here all of it acts.
  Real largest_change = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    const Real change = new_impulse_[i] - problem.impulse[i];
    apply_impulse(problem, problem.rows[i], change);
    problem.impulse[i] = new_impulse_[i];
    largest_change = std::max(largest_change, std::abs(change));
  }
  return largest_change;
}

template void prepare_jacobi(const VelocityProblem<float>&, float, Splitting, PerBody<int>&, PerRow<float>&);
template void prepare_jacobi(const VelocityProblem<double>&, double, Splitting, PerBody<int>&,
                             PerRow<double>&);
template class Jacobi<float>;
template class Jacobi<double>;

}  // namespace cairn
