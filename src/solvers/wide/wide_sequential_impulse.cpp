// Floor 4. Algorithm 1 in lanes, with momentum or without.
#include <cairn/solvers/wide/wide_sequential_impulse.hpp>

#include <cmath>

namespace cairn {

template <Scalar Real>
WideSequentialImpulse<Real>::WideSequentialImpulse(const SolverSettings& settings, Momentum momentum,
                                                   LaneSet set)
    : settings_(settings), momentum_(momentum), lanes_(set, Real(settings.relaxation)) {
  check(settings, "WideSequentialImpulse");
  settings_.order = RowOrder::coloured;  // whatever was asked for
}

template <Scalar Real>
SolveReport WideSequentialImpulse<Real>::solve(VelocityProblem<Real>& problem,
                                               SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  // Momentum is part of the state: impulses that repeat are no cycle.
  stopping_.begin(settings_, problem, {.looks = Looks::rarely, .seeks_cycles = momentum_ == Momentum::none});
  lanes_.begin(problem);  // warm start: impulses of last step act before the first sweep
  restarts_ = 0;
  if (settings_.iterations == 1 && !(settings_.tolerance > 0)) {
    return stopping_.repeat(problem, observer, [&](int number, SolveObserver<Real>* watcher) {
      return lanes_.sweep_once(problem, number, watcher);
    });
  }
  if (settings_.tolerance > 0 || settings_.patience > 0) stopping_.take_scale(lanes_.residual_scale(problem));
  lanes_.take(problem);
  path_ = 0;
  k_ = 1;

  bool is_current = true;
  SolveReport report = stopping_.repeat(problem, observer, [&](int number, SolveObserver<Real>* watcher) {
    const LaneSteps<Real> swept = iterate(number, problem, watcher);
    const bool again = lanes_.is_worth_taking(swept.largest, path_);
    const bool looks = stopping_.looks(number, std::sqrt(swept.squares)) && settings_.tolerance > 0;
    if (looks) stopping_.take_residual(lanes_.residual(problem, stopping_.scale(), LaneLook::rough));
    const bool may_have_arrived = looks && stopping_.is_near();
    is_current = again || may_have_arrived || observer != nullptr || settings_.patience > 0;
    if (again) {
      lanes_.take_again(problem);
      path_ = 0;
    } else if (is_current) {
      lanes_.write_back(problem);
    }
    if (may_have_arrived)
      stopping_.take_residual(lanes_.residual(problem, stopping_.scale(), LaneLook::exact));
    return swept.largest;
  });
  if (!is_current) lanes_.write_back(problem);
  if (settings_.tolerance > 0 && !report.converged)
    report.residual = static_cast<double>(lanes_.residual(problem, stopping_.scale(), LaneLook::exact));
  return report;
}

/// One sweep, with one step of momentum before it where there is any. Returns the steps of the sweep alone:
/// R_E goes with them, while steps of momentum grow.
template <Scalar Real>
LaneSteps<Real> WideSequentialImpulse<Real>::iterate(int number, VelocityProblem<Real>& problem,
                                                     SolveObserver<Real>* watcher) {
  LaneSteps<Real> gathered;
  if (momentum_ == Momentum::nesterov) {
    gathered = lanes_.gather_momentum(problem, static_cast<Real>(k_ - 1) / static_cast<Real>(k_ + 2));
    if (watcher != nullptr && k_ > 1) lanes_.write_back(problem);
  }
  const LaneSteps<Real> swept = lanes_.sweep(problem, number, watcher);
  path_ += gathered.largest + swept.largest;
  if (momentum_ == Momentum::nesterov) accept_or_undo(problem, gathered, swept);
  return swept;
}

/// As AcceleratedProjectedGaussSeidel does: f must have fallen by half of what updates alone lower it by.
template <Scalar Real>
void WideSequentialImpulse<Real>::accept_or_undo(VelocityProblem<Real>& problem,
                                                 const LaneSteps<Real>& gathered,
                                                 const LaneSteps<Real>& swept) {
  const Real omega = Real(settings_.relaxation);
  const Real change = (gathered.squares + swept.squares) / 2 - (gathered.work + swept.work) / omega;
  const Real share = swept.squares * (1 / omega - Real(0.5));
  if (k_ == 1 || change <= -share / 2) {
    k_ = share > 0 ? k_ + 1 : 1;  // what is too small to have an energy needs no momentum
    return;
  }
  lanes_.undo(problem);
  k_ = 1;
  ++restarts_;
}

template class WideSequentialImpulse<float>;
template class WideSequentialImpulse<double>;

}  // namespace cairn
