// Floor 4. Algorithm 1 of the paper.
#include <cairn/solvers/iterative/sequential_impulse.hpp>

#include <cmath>

namespace cairn {

template <Scalar Real>
SequentialImpulse<Real>::SequentialImpulse(const SolverSettings& settings,
                                           const SequentialImpulseVariant& variant)
    : settings_(settings), variant_(variant) {
  check(settings, "SequentialImpulse");
}

template <Scalar Real>
SolveReport SequentialImpulse<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem);
  prepare(problem);
  apply_impulses(problem);  // warm start: those of last step act before the first sweep

  return stopping_.repeat_rows(problem, observer, sequence_, [&](int number, SolveObserver<Real>* watcher) {
    return sweep(number, problem, watcher);
  });
}

template <Scalar Real>
void SequentialImpulse<Real>::prepare(const VelocityProblem<Real>& problem) {
  if (variant_.effective_mass == EffectiveMass::in_the_loop) return;
  effective_mass_.resize(problem.rows.size());
  for (int i = 0; i < problem.row_count(); ++i) {
    effective_mass_[i] = effective_mass(problem, problem.rows[i]);
  }
}

template <Scalar Real>
Real SequentialImpulse<Real>::sweep(int number, VelocityProblem<Real>& problem,
                                    SolveObserver<Real>* watcher) {
  const bool precomputed = variant_.effective_mass == EffectiveMass::precomputed;
  const bool clamps_sum = variant_.clamp == Clamp::accumulated;
  const Real omega = Real(settings_.relaxation);
  Real largest_change = 0;
  for (const int i : sequence_.rows) {
    const ConstraintRow<Real>& row = problem.rows[i];
    Real& accumulated = problem.impulse[i];
    const Real jv = row_velocity(problem, row);
    const Real mass = precomputed ? effective_mass_[i] : effective_mass(problem, row);

    // The impulse that satisfies this row alone: (22) times dt, with softness; relaxed.
    const Real corrective = omega * ((row.bias - jv - row.softness * accumulated) * mass);
    const Real old = accumulated;
    accumulated = clamps_sum ? row.bounds.clamp(old + corrective, problem.impulse)
                             : old + row.bounds.clamp(corrective, problem.impulse);
    apply_impulse(problem, row, accumulated - old);  // (19), (21)

    largest_change = std::max(largest_change, std::abs(accumulated - old));
    if (watcher != nullptr) {
      const Real inverse = mass > 0 ? 1 / mass : Real(0);
      watcher->after_row({number, i, jv, inverse, corrective, old, accumulated}, problem);
    }
  }
  return largest_change;
}

template class SequentialImpulse<float>;
template class SequentialImpulse<double>;
template class SequentialImpulse<long double>;

}  // namespace cairn
