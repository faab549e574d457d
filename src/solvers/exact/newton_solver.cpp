// Floor 4. Proximal steps from the warm start.
#include "solvers/exact/newton_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/iterative/accelerated_projected_gauss_seidel.hpp"
#include "solvers/exact/exact_rows.hpp"

namespace cairn {

namespace {

// Softness, of rows with ones on the diagonal.
constexpr double warm_softness = 1e-6;
constexpr double cold_softness = 1e-2;
constexpr double softest = 10;
constexpr double stiffest = 1e-9;  // below it, factors in double have few digits left
constexpr double softness_step = 10;
constexpr int steps_of_one_problem = 10;
constexpr int first_sweeps = 30;
constexpr int failures_before_sweeps = 4;
constexpr int most_failures = 20;
constexpr int roundings_of_residual = 4;  // of R_E: there is nothing below
constexpr double least_progress =
    0.5;  // of R_E in a step that was solved at the stiffest: else it stands still

}  // namespace

template <Scalar Real>
NewtonSolver<Real>::NewtonSolver(const SolverSettings& settings) : settings_(settings) {
  check(settings, "NewtonSolver");
}

template <Scalar Real>
SolveReport NewtonSolver<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  if constexpr (std::is_same_v<Real, Work>) {
    answer(problem);
  } else {
    answer(converted<Work>(problem));
  }
  SolveReport report{.iterations = systems_, .extra_sweeps = sweeps_};
  for (int i = 0; i < problem.row_count(); ++i) problem.impulse[i] = static_cast<Real>(best_[i]);
  apply_impulses(problem);
  report.converged = least_residual_ <= enough();
  if (report.converged) report.stop = Stop::tolerance;
  if (observer != nullptr) observer->after_sweep(systems_, problem);
  return report;
}

template <Scalar Real>
typename NewtonSolver<Real>::Work NewtonSolver<Real>::enough() const {
  return std::max(static_cast<Work>(settings_.tolerance),
                  roundings_of_residual * std::numeric_limits<Work>::epsilon());
}

template <Scalar Real>
void NewtonSolver<Real>::answer(const VelocityProblem<Work>& problem) {
  begin(problem);
  approach(problem);
}

template <Scalar Real>
void NewtonSolver<Real>::begin(const VelocityProblem<Work>& problem) {
  rows_.begin(problem);
  pairs_.clear();
  rows_.for_each_terms([this](const auto& terms) {
    for (const auto& left : terms) {
      const int low = left.column / 3;
      for (const auto& right : terms) {
        const int high = right.column / 3;
        if (low < high && (pairs_.empty() || pairs_.back() != std::pair(low, high)))
          pairs_.emplace_back(low, high);
      }
    }
  });
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  factors_.begin(problem.body_count(), pairs_);
  scale_ = exact_scale(problem);
  systems_ = 0;
  sweeps_ = 1;
  best_ = problem.impulse;
  rows_.center_at(best_);
  residual_ = least_residual_ = std::numeric_limits<Work>::infinity();
  note_center();
}

template <Scalar Real>
void NewtonSolver<Real>::note_center() {
  const Work error = rows_.error();
  residual_ = error == 0 ? 0 : error / scale_;
  if (!(residual_ < least_residual_)) return;
  least_residual_ = residual_;
  best_ = rows_.center_impulses();
}

/// The best impulses so far after some sweeps: what Newton's method finds easier to begin with.
template <Scalar Real>
void NewtonSolver<Real>::sweep(const VelocityProblem<Work>& problem, int sweeps) {
  swept_ = problem;
  swept_.impulse = best_;
  AcceleratedProjectedGaussSeidel<Work>({.iterations = sweeps}).solve(swept_);
  sweeps_ += sweeps;
  rows_.center_at(swept_.impulse);
  note_center();
}

template <Scalar Real>
void NewtonSolver<Real>::approach(const VelocityProblem<Work>& problem) {
  if (!std::isfinite(residual_)) return;  // nothing can be said of what is no number
  Work softness = Work(warm_softness);
  int failures = 0, sweeps = first_sweeps;
  while (least_residual_ > enough() && systems_ < settings_.iterations && failures < most_failures) {
    const Work before = least_residual_;
    rows_.soften(softness);
    const bool is_solved = solve_softened();
    rows_.center_at_last();
    note_center();
    if (is_solved) {
      const bool stands_still = !(least_residual_ <= Work(least_progress) * before);
      if (stands_still && softness <= Work(stiffest)) break;
      softness = std::max(softness / Work(softness_step), Work(stiffest));
      continue;
    }
    // What was found is kept where it is nearer. After the first failure, and after many, sweeps lead on.
    if (failures % failures_before_sweeps == 0) {
      sweep(problem, sweeps);
      sweeps *= 2;
      softness = Work(cold_softness);
    } else {
      rows_.center_at(best_);
      note_center();
      softness = std::min(softness * Work(softness_step), Work(softest));
    }
    failures += 1;
  }
}

/// Seeks du with F(du) = 0 around the centre; the last evaluation is the answer.
template <Scalar Real>
bool NewtonSolver<Real>::solve_softened() {
  const Work enough = Work(1e-2) * residual_ * scale_;
  du_ = Vector<Work>::Zero(rows_.freedoms());
  Work error = rows_.evaluate(du_).norm();
  for (int step = 0; step < steps_of_one_problem && error > enough; ++step) {
    if (systems_ >= settings_.iterations || !find_change(change_) || !shorten(change_, error)) return false;
  }
  return error <= enough;
}

template <Scalar Real>
bool NewtonSolver<Real>::find_change(Vector<Work>& change) {
  ++systems_;
  factors_.set_identity();
  rows_.for_each_slope([this](const auto& left, const auto& right, Work factor) {
    for (int k = 0; k < left.size();) {
      const int row = left[k].column / 3;
      int k_end = k;
      while (k_end < left.size() && left[k_end].column / 3 == row) ++k_end;
      for (int l = 0; l < right.size();) {
        const int column = right[l].column / 3;
        auto& block = factors_.at(row, column);
        for (; l < right.size() && right[l].column / 3 == column; ++l) {
          for (int of_row = k; of_row < k_end; ++of_row) {
            block(left[of_row].column - 3 * row, right[l].column - 3 * column) +=
                factor * left[of_row].value * right[l].value;
          }
        }
      }
      k = k_end;
    }
  });
  factors_.factorize();
  change = rows_.value();
  factors_.solve(change);
  return change.allFinite();
}

/// Goes a share of the step that makes the error fall: the largest of 1, 1/2, 1/4 ...; false: there is none.
template <Scalar Real>
bool NewtonSolver<Real>::shorten(const Vector<Work>& change, Work& error) {
  for (Work share = 1; share >= Work(1.0 / 256); share /= 2) {
    next_ = du_ - share * change;
    const Work left = rows_.evaluate(next_).norm();
    if (!(left < (1 - share / 10000) * error)) continue;
    du_ = next_;
    error = left;
    return true;
  }
  return false;
}

template class NewtonSolver<float>;
template class NewtonSolver<double>;
template class NewtonSolver<long double>;

}  // namespace cairn
