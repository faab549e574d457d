// Floor 4. Jacobi's method, plain, damped, or with split masses.
#include "solvers/iterative/jacobi.hpp"

#include <cmath>

namespace cairn {

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
  prepare(problem);
  apply_impulses(problem);  // warm start: those of last step act before the first sweep

  return stopping_.repeat(problem, observer, [&](int number, auto watched) {
    return sweep<decltype(watched)::value>(number, problem, observer);
  });
}

template <Scalar Real>
void Jacobi<Real>::prepare(const VelocityProblem<Real>& problem) {
  count_rows(problem);
  new_impulse_.resize(problem.rows.size());
  step_.resize(problem.rows.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    Real inverse = row.softness;
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      inverse +=
          Real(rows_on_body_[body]) * dot<Real>(jacobian, problem.inverse_mass[body].cwiseProduct(jacobian));
    });
    // Between two immovable bodies nothing can be done.
    step_[i] = inverse > 0 ? Real(settings_.relaxation) / inverse : Real(0);
  }
}

template <Scalar Real>
void Jacobi<Real>::count_rows(const VelocityProblem<Real>& problem) {
  const bool whole = splitting_ == Splitting::none;
  rows_on_body_.assign(problem.velocity.size(), whole ? 1 : 0);
  if (whole) return;
  for (const ConstraintRow<Real>& row : problem.rows) {
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      if (!jacobian.isZero(Real(0))) ++rows_on_body_[body];
    });
  }
}

template <Scalar Real>
template <bool watched>
Real Jacobi<Real>::sweep(int number, VelocityProblem<Real>& problem,
                         [[maybe_unused]] SolveObserver<Real>* observer) {
  // Everything is read here, and nothing is written that another row reads ...
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    const Real jv = row_velocity(problem, row);
    const Real old = problem.impulse[i];
    const Real corrective = (row.bias - jv - row.softness * old) * step_[i];
    new_impulse_[i] = row.bounds.clamp(old + corrective, problem.impulse);
    if constexpr (watched) {
      const Real inverse = inverse_effective_mass(problem, row);
      observer->after_row({number, i, jv, inverse, corrective, old, new_impulse_[i]}, problem);
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

template class Jacobi<float>;
template class Jacobi<double>;
template class Jacobi<long double>;

}  // namespace cairn
