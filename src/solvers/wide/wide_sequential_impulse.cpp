// Floor 4. Algorithm 1 in lanes.
#include "solvers/wide/wide_sequential_impulse.hpp"

namespace cairn {

template <Scalar Real>
WideSequentialImpulse<Real>::WideSequentialImpulse(const SolverSettings& settings, LaneSet set)
    : settings_(settings), lanes_(set, Real(settings.relaxation)) {
  check(settings, "WideSequentialImpulse");
  settings_.order = RowOrder::coloured;  // whatever was asked for: sweeps may repeat themselves
}

template <Scalar Real>
SolveReport WideSequentialImpulse<Real>::solve(VelocityProblem<Real>& problem,
                                               SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  stopping_.begin(settings_, problem, Looks::rarely);
  apply_impulses(problem);  // warm start: those of last step act before the first sweep
  lanes_.take(problem);

  Real path = 0;  // [N s] what changes since the lanes were filled add up to, at most
  bool is_current = true;
  const SolveReport report =
      stopping_.repeat(problem, observer, [&]([[maybe_unused]] int number, auto watched) {
        const Real change = decltype(watched)::value ? lanes_.watched_sweep(number, problem, *observer)
                                                     : lanes_.sweep(problem);
        path += change;
        const bool again = lanes_.is_worth_taking(change, path);
        is_current = again || observer != nullptr || stopping_.looks(change);
        if (is_current) lanes_.write_back(problem);
        if (again) {
          lanes_.take(problem);
          path = 0;
        }
        return change;
      });
  if (!is_current) lanes_.write_back(problem);
  return report;
}

template class WideSequentialImpulse<float>;
template class WideSequentialImpulse<double>;
template class WideSequentialImpulse<long double>;

}  // namespace cairn
