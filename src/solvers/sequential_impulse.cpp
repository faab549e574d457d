// Floor 4. Algorithm 1 of the paper.
#include "solvers/sequential_impulse.hpp"

#include <cmath>

#include "solvers/residual.hpp"

namespace cairn {

template <Scalar Real>
SequentialImpulse<Real>::SequentialImpulse(const SolverSettings& settings) : settings_(settings) {
  check(settings, "SequentialImpulse");
}

template <Scalar Real>
SolveReport SequentialImpulse<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  const Real scale = settings_.tolerance > 0 ? residual_scale(problem) : Real(0);

  effective_mass_.resize(problem.rows.size());
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const Real inverse = inverse_effective_mass(problem.rows[i], problem.inverse_mass);
    effective_mass_[i] = inverse > 0 ? 1 / inverse : Real(0);  // two immovable bodies: nothing can be done
    // Warm start: last step's impulse acts before the first sweep.
    apply_impulse(problem.rows[i], problem.impulse[i], problem.inverse_mass, problem.velocity);
  }

  const bool watched = observer != nullptr && observer->watches_rows();
  SolveReport report;
  while (report.iterations < settings_.iterations && !report.converged) {
    const int number = ++report.iterations;
    const Real change =
        watched ? sweep<true>(number, problem, observer) : sweep<false>(number, problem, observer);
    report.largest_change = static_cast<double>(change);
    if (observer != nullptr) observer->after_sweep(number, problem);
    if (settings_.tolerance > 0)
      report.converged = residual(problem, scale).energy <= Real(settings_.tolerance);
  }
  return report;
}

template <Scalar Real>
template <bool watched>
Real SequentialImpulse<Real>::sweep(int number, VelocityProblem<Real>& problem,
                                    [[maybe_unused]] SolveObserver<Real>* observer) {
  Real largest_change = 0;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const ConstraintRow<Real>& row = problem.rows[i];
    Real& accumulated = problem.impulse[i];
    const Real jv = row_velocity(row, problem.velocity);

    // The impulse that satisfies this row alone: (22) times dt, with softness.
    const Real corrective = (row.bias - jv - row.softness * accumulated) * effective_mass_[i];
    const Real old = accumulated;
    accumulated = row.bounds.clamp(old + corrective, problem.impulse);
    apply_impulse(row, accumulated - old, problem.inverse_mass, problem.velocity);  // (19), (21)

    largest_change = std::max(largest_change, std::abs(accumulated - old));
    if constexpr (watched) {
      const Real inverse = effective_mass_[i] > 0 ? 1 / effective_mass_[i] : Real(0);
      observer->after_row({number, static_cast<int>(i), jv, inverse, corrective, old, accumulated}, problem);
    }
  }
  return largest_change;
}

template class SequentialImpulse<float>;
template class SequentialImpulse<double>;
template class SequentialImpulse<long double>;

}  // namespace cairn
