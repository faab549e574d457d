// Floor 4. Tolerance, standstill, cycles and plateaus.
#include <cairn/solvers/stopping.hpp>

#include <cmath>
#include <limits>

#include <cairn/math/deadline.hpp>
#include <cairn/solvers/residual.hpp>

namespace cairn {

template <Scalar Real>
void Stopping<Real>::begin(const SolverSettings& settings, const VelocityProblem<Real>& problem,
                           Judging how) {
  settings_ = settings;
  how_ = how;
  if (settings.time_budget > 0) began_ = std::chrono::steady_clock::now();
  const bool measures = settings.tolerance > 0 || settings.patience > 0;
  scale_ = measures && how.looks == Looks::always ? residual_scale(problem) : Real(0);
  rare_looks_ = {};
  quiet_sweeps_ = 0;
  // An upward and a downward sweep may lead to the same impulses, and from there to different ones.
  const int stride = settings.order == RowOrder::alternating ? 2 : 1;
  cycles_.begin(settings.patience > 0 ? problem.impulse.size() : 0, stride);
}

template <Scalar Real>
Stop Stopping<Real>::judge(const VelocityProblem<Real>& problem, int sweep, Real largest_change) {
  Deadline::go_on();
  if (settings_.tolerance > 0 && has_arrived(problem, sweep)) return Stop::tolerance;
  if (settings_.time_budget > 0 &&
      std::chrono::steady_clock::now() - began_ >= std::chrono::duration<double>(settings_.time_budget)) {
    return Stop::time;
  }
  if (settings_.patience == 0) return Stop::sweeps;

  Real largest = 0;
  for (const Real impulse : problem.impulse) {
    if (!std::isfinite(impulse)) return Stop::sweeps;
    largest = std::max(largest, std::abs(impulse));
  }
  const bool quiet = largest_change <= 16 * std::numeric_limits<Real>::epsilon() * largest;
  quiet_sweeps_ = quiet ? quiet_sweeps_ + 1 : 0;
  if (quiet_sweeps_ >= settings_.patience) return Stop::stalled;
  const bool may_repeat = how_.seeks_cycles && settings_.order != RowOrder::shuffled;
  if (may_repeat && cycles_.comes_back(problem.impulse, sweep, !quiet)) return Stop::cycle;
  return is_plateau(problem, sweep, largest_change) ? Stop::plateau : Stop::sweeps;
}

template <Scalar Real>
bool Stopping<Real>::has_arrived(const VelocityProblem<Real>& problem, int sweep) {
  const Real tolerance = Real(settings_.tolerance);
  if (how_.looks == Looks::always) {
    energy_ = residual(problem, scale_).energy;
  } else {
    if (!size_seen_) return false;
    rare_looks_.note(sweep, *size_seen_, energy_, tolerance);
  }
  return energy_ <= tolerance;
}

template <Scalar Real>
bool Stopping<Real>::is_plateau(const VelocityProblem<Real>& problem, int sweep, Real largest_change) {
  if (!looks_for_plateau(sweep)) return false;
  const Real energy = residual(problem, scale_).energy;
  const auto stays = [](Real now, Real before) { return std::abs(now - before) <= Real(1e-4) * before; };
  const bool is_flat =
      sweep > first_look && stays(energy, residual_before_) && stays(largest_change, change_before_);
  residual_before_ = energy;
  change_before_ = largest_change;
  return is_flat;
}

template class Stopping<float>;
template class Stopping<double>;
template class Stopping<long double>;

}  // namespace cairn
