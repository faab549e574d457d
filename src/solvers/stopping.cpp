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
  look_below_ = std::numeric_limits<Real>::infinity();
  if (settings.time_budget > 0) began_ = std::chrono::steady_clock::now();
  const bool measures = settings.tolerance > 0 || settings.patience > 0;
  scale_ = measures && how.looks == Looks::always ? residual_scale(problem) : Real(0);
  next_look_ = 0;
  quiet_sweeps_ = 0;
  moved_ = false;
  remembered_sweep_ = 0;
  remembered_.reserve(settings.patience > 0 ? problem.impulse.size() : 0);
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
  moved_ = moved_ || !quiet;
  if (quiet_sweeps_ >= settings_.patience) return Stop::stalled;
  if (repeats(problem, sweep)) return Stop::cycle;
  return is_plateau(problem, sweep, largest_change) ? Stop::plateau : Stop::sweeps;
}

template <Scalar Real>
bool Stopping<Real>::has_arrived(const VelocityProblem<Real>& problem, int sweep) {
  if (how_.looks == Looks::rarely && !looks_now_) return false;
  if (how_.looks == Looks::always) energy_ = residual(problem, scale_).energy;
  // A quarter more: the two do not shrink quite alike.
  look_below_ = Real(1.25) * size_ * Real(settings_.tolerance) / energy_;
  next_look_ = sweep + 3 + sweep / 16;  // to look takes as long as two or three sweeps in lanes
  return energy_ <= Real(settings_.tolerance);
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

template <Scalar Real>
bool Stopping<Real>::repeats(const VelocityProblem<Real>& problem, int sweep) {
  if (!how_.seeks_cycles || settings_.order == RowOrder::shuffled) return false;
  // An upward and a downward sweep may lead to the same impulses, and from there to different ones.
  const bool same_direction =
      settings_.order != RowOrder::alternating || (sweep - remembered_sweep_) % 2 == 0;
  if (remembered_sweep_ > 0 && moved_ && same_direction && problem.impulse == remembered_) return true;
  if (remembered_sweep_ == 0 || sweep >= 2 * remembered_sweep_) {
    remembered_ = problem.impulse;
    remembered_sweep_ = sweep;
    moved_ = false;
  }
  return false;
}

template class Stopping<float>;
template class Stopping<double>;
template class Stopping<long double>;

}  // namespace cairn
