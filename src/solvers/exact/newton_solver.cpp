// Floor 4. Proximal steps from the warm start.
#include "solvers/exact/newton_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraints/converted.hpp"
#include "math/deadline.hpp"
#include "solvers/iterative/accelerated_projected_gauss_seidel.hpp"

namespace cairn {

namespace {

// Softness, of rows with ones on the diagonal.
constexpr double warm_softness = 1e-7;
constexpr double cold_softness = 1e-2;
constexpr double softest = 10;
constexpr double stiffest = 1e-9;  // below it, factors in double have few digits left
constexpr double softness_step = 10;
constexpr int steps_of_one_problem = 10;
constexpr int first_sweeps = 30;
constexpr int failures_before_sweeps = 4;
constexpr int most_failures = 20;
constexpr double roundings_of_residual = 4;  // of R_E: there is nothing below,
constexpr int roundings_of_impulses = 16;    // nor below so many of all impulses, beside the scale of R_E
constexpr double goal_of_tolerance = 0.01;
// Of R_E in a step that was solved: where it falls less, the next is stiffer;
constexpr double good_progress = 0.1;
// and where that is at the stiffest already, so often in a row, it stands still.
constexpr double least_progress = 0.5;
constexpr int most_idle = 3;
constexpr double kept_progress = 0.3;  // of |F| in a step by kept factors: else they do not help any more
// In time: to look at a problem, and a step by kept factors.
constexpr int sweeps_of_a_look = 3;
constexpr int sweeps_of_a_kept_step = 2;

/// R_E that numbers of this type leave, in each impulse so many roundings of it.
template <typename Number>
double rounding_in(const ProximalRows<double>& rows, int roundings) {
  const double impulses = rows.scale() > 0 ? rows.center_size() / rows.scale() : 0;
  return std::numeric_limits<Number>::epsilon() * std::max(roundings_of_residual, roundings * impulses);
}

}  // namespace

template <Scalar Real>
NewtonSolver<Real>::NewtonSolver(const SolverSettings& settings) : settings_(settings) {
  check(settings, "NewtonSolver");
}

template <Scalar Real>
SolveReport NewtonSolver<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  const SolveReport report = solve_unobserved(problem);
  if (observer != nullptr) observer->after_sweep(systems_, problem);
  return report;
}

template <Scalar Real>
SolveReport NewtonSolver<Real>::solve_unobserved(VelocityProblem<Real>& problem) {
  const bool again = problem.number.value() != 0 && problem.number.value() == solved_;
  solved_ = 0;  // until it is done
  if constexpr (std::is_same_v<Real, double>) {
    answer(problem, again);
  } else {
    answer(converted<double>(problem), again);
  }
  give_answer(problem);
  solved_ = problem.number.value();
  SolveReport report{.iterations = systems_, .extra_sweeps = sweeps_};
  report.converged =
      least_residual_ <= std::max({settings_.tolerance, rounding(), rounding_in<Real>(rows_, 1)});
  if (report.converged) report.stop = Stop::tolerance;
  report.residual = least_residual_;
  return report;
}

template <Scalar Real>
void NewtonSolver<Real>::give_answer(VelocityProblem<Real>& problem) {
  for (int i = 0; i < problem.row_count(); ++i) problem.impulse[i] = static_cast<Real>(best_[i]);
  if (!std::isfinite(least_residual_)) return apply_impulses(problem);
  if (residual_ != least_residual_) rows_.center_at(best_);
  for (const BodyId body : problem.velocity.indices()) {
    const Vec3<double> before = problem.velocity[body].template cast<double>();
    problem.velocity[body] = rows_.center_velocity(body, before).template cast<Real>();
  }
}

template <Scalar Real>
double NewtonSolver<Real>::goal() const {
  return std::max(goal_of_tolerance * tolerance(), rounding());
}

template <Scalar Real>
double NewtonSolver<Real>::rounding() const {
  return rounding_in<double>(rows_, roundings_of_impulses);
}

template <Scalar Real>
void NewtonSolver<Real>::answer(const VelocityProblem<double>& problem, bool again) {
  const bool keeps_rows = again && rows_.begin_again(problem);
  const bool keeps_center = keeps_rows && problem.impulse == best_;
  if (!keeps_rows) {
    rows_.begin(problem);
    factors_.begin();
  }
  interior_.clear();
  inside_.clear();
  systems_ = 0;
  sweeps_ = sweeps_of_a_look;
  best_ = problem.impulse;
  // Where nothing moves and no row asks for anything, no impulses are the answer, and R_E has no scale.
  const bool rests = settings_.iterations > 0 && rows_.scale() == 0;
  if (rests) best_.assign(best_.size(), 0);
  if (keeps_center && !rests) {
    rows_.keep_center();
  } else {
    rows_.center_at(best_);
  }
  residual_ = least_residual_ = std::numeric_limits<double>::infinity();
  note_center();
  // Nothing can be said of what is no number.
  const double good_start = std::max(goal(), rounding_in<Real>(rows_, 1));
  if (settings_.iterations > 0 && residual_ > good_start && std::isfinite(residual_)) approach(problem);
}

template <Scalar Real>
void NewtonSolver<Real>::note_center() {
  const double error = rows_.error();
  residual_ = error == 0 ? 0 : error / rows_.scale();
  if (!(residual_ < least_residual_)) return;
  least_residual_ = residual_;
  rows_.copy_center_to(best_);
}

/// The best impulses so far after some sweeps: what Newton's method finds easier to begin with.
template <Scalar Real>
void NewtonSolver<Real>::sweep(const VelocityProblem<double>& problem, int sweeps) {
  swept_ = problem;
  swept_.impulse = best_;
  AcceleratedProjectedGaussSeidel<double>({.iterations = sweeps}).solve(swept_);
  sweeps_ += sweeps;
  rows_.center_at(swept_.impulse);
  note_center();
}

template <Scalar Real>
void NewtonSolver<Real>::approach(const VelocityProblem<double>& problem) {
  double softness = warm_softness;
  if (factors_.are_for(rows_) && factors_.softness() > 0) softness = std::min(softness, factors_.softness());
  int failures = 0, idle = 0, sweeps = first_sweeps;
  while (least_residual_ > goal() && failures < most_failures) {
    const double before = least_residual_;
    rows_.soften(softness);
    const bool is_solved = solve_softened();
    rows_.center_at_last();
    note_center();
    if (is_solved) {
      if (least_residual_ <= good_progress * before) continue;
      go_on();
      if (least_residual_ <= good_progress * before) continue;
      const bool stands_still = !(least_residual_ <= least_progress * before);
      idle = stands_still && softness <= stiffest ? idle + 1 : 0;
      if (idle == most_idle) break;
      softness = std::max(softness / softness_step, stiffest);
      continue;
    }
    if (least_residual_ <= enough()) break;
    // What was found is kept where it is nearer. After the first failure, and after many, sweeps lead on.
    if (failures % failures_before_sweeps == 0) {
      sweep(problem, sweeps);
      sweeps *= 2;
      softness = cold_softness;
      if (failures == 0 && systems_ < settings_.iterations) follow_interior();
      if (least_residual_ <= enough()) softness = warm_softness;
    } else {
      rows_.center_at(best_);
      note_center();
      softness = std::min(softness * softness_step, softest);
    }
    failures += 1;
    if (systems_ >= settings_.iterations) break;
  }
}

/// Past the last step; back to the best impulses where that is not better.
template <Scalar Real>
void NewtonSolver<Real>::go_on() {
  rows_.go_on();
  note_center();
  if (residual_ == least_residual_) return;
  rows_.center_at(best_);
  note_center();
}

/// Seeks du with F(du) = 0 around the centre; the last evaluation is the answer.
template <Scalar Real>
bool NewtonSolver<Real>::solve_softened() {
  const double small = std::max(1e-2 * residual_, 1e-1 * goal()) * rows_.scale();
  du_ = Vector<double>::Zero(rows_.freedoms());
  double error = rows_.evaluate_at_center().norm();
  for (int step = 0; step < steps_of_one_problem && error > small; ++step) {
    if (take_kept_step(error)) continue;
    if (systems_ >= settings_.iterations || !take_new_step(error)) return false;
  }
  return error <= small;
}

/// A step by factors of an earlier system, or of an earlier solve; false: they do not help, and nothing has
/// changed.
template <Scalar Real>
bool NewtonSolver<Real>::take_kept_step(double& error) {
  if (!factors_.are_for(rows_) || factors_.softness() != rows_.softness()) return false;
  sweeps_ += sweeps_of_a_kept_step;
  change_ = rows_.value();
  factors_.solve(change_);
  next_ = du_ - change_;
  const double left = rows_.evaluate(next_).norm();
  if (left <= kept_progress * error) {
    du_.swap(next_);
    error = left;
    return true;
  }
  rows_.evaluate(du_);
  return false;
}

/// A step by factors of the moment, shortened until it helps; false: it does not.
template <Scalar Real>
bool NewtonSolver<Real>::take_new_step(double& error) {
  Deadline::go_on();
  ++systems_;
  factors_.factorize(rows_, rows_);
  change_ = rows_.value();
  factors_.solve(change_);
  return change_.allFinite() && shorten(change_, error);
}

/// Goes a share of the step that makes the error fall: the largest of 1, 1/2, 1/4 ...; false: there is none.
template <Scalar Real>
bool NewtonSolver<Real>::shorten(const Vector<double>& change, double& error) {
  for (double share = 1; share >= 1.0 / 256; share /= 2) {
    next_ = du_ - share * change;
    const double left = rows_.evaluate(next_).norm();
    if (!(left < (1 - share / 10000) * error)) continue;
    du_ = next_;
    error = left;
    return true;
  }
  return false;
}

template class NewtonSolver<float>;
template class NewtonSolver<double>;

}  // namespace cairn
