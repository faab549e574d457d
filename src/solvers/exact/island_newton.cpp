// Floor 4. Proximal steps from the warm start.
#include <cairn/solvers/exact/island_newton.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/math/deadline.hpp>
#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>

namespace cairn {

namespace {

// Softness, of rows with ones on the diagonal.
constexpr double least_warm_softness = 1e-6;
// Beside R_E: a row that is softer by epsilon answers what is left of its speed by an impulse of 1 / epsilon
// times that, and where that is not small beside its own, it changes sides. Where nothing pushes yet, or no
// row has a bound, none can.
constexpr double warm_softness = 100;
constexpr double kept_softness = 10;  // for which factors of before are used again
constexpr double cold_softness = 1e-2;
constexpr double most_caution = 1e4;
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
constexpr double loosest_tolerance = 1e-7;
constexpr double without_tolerance = 1e-9;  // R_E below which no new system is worth its price
// Of R_E in a step that was solved: where it falls less, the next is stiffer;
constexpr double good_progress = 0.1;
// and where that is at the stiffest already, so often in a row, it stands still.
constexpr double least_progress = 0.5;
constexpr int most_idle = 3;
constexpr double kept_progress = 0.3;     // of |F| in a step by kept factors: else they do not help any more
constexpr double least_part = 1.0 / 256;  // of a step by factors of the moment
// In time: to look at a problem, and a step by kept factors.
constexpr int sweeps_of_a_look = 3;
constexpr int sweeps_of_a_kept_step = 2;

/// R_E that numbers with this epsilon leave, in each impulse so many roundings of it.
double rounding_in(double epsilon, double scale, double size_of_impulses, int roundings) {
  const double impulses = scale > 0 ? size_of_impulses / scale : 0.0;
  return epsilon * std::max(roundings_of_residual, roundings * impulses);
}

}  // namespace

SolveReport IslandNewton::solve(VelocityProblem<double>& problem) {
  const bool again = problem.number.value() != 0 && problem.number.value() == solved_;
  solved_ = 0;  // until it is done
  answer(problem, again);
  give_answer(problem);
  solved_ = problem.number.value();
  const double asked = settings_.tolerance;
  done_.converged = best_.residual <= std::max({asked, rounding(), rounding_of_answer()});
  if (done_.converged) done_.stop = Stop::tolerance;
  done_.residual = best_.residual;
  return done_;
}

void IslandNewton::give_answer(VelocityProblem<double>& problem) {
  problem.impulse = best_.impulse;
  if (!std::isfinite(best_.residual)) return apply_impulses(problem);
  if (residual() != best_.residual) center_.go_to(rows_, best_.impulse);
  for (const BodyId body : problem.velocity.indices())
    problem.velocity[body] = rows_.velocity_of(body, problem.velocity[body], center_.u());
}

double IslandNewton::goal() const {
  return std::max(goal_of_tolerance * std::min(settings_.tolerance, loosest_tolerance), rounding());
}

double IslandNewton::enough() const {
  const double asked = settings_.tolerance > 0 ? settings_.tolerance : without_tolerance;
  return std::max(std::min(asked, loosest_tolerance), rounding());
}

double IslandNewton::rounding() const {
  return rounding_in(std::numeric_limits<double>::epsilon(), rows_.scale(), center_.size(),
                     roundings_of_impulses);
}

double IslandNewton::rounding_of_answer() const {
  return rounding_in(epsilon_, rows_.scale(), center_.size(), 1);
}

void IslandNewton::answer(const VelocityProblem<double>& problem, bool again) {
  const bool keeps_rows = again && rows_.begin_again(problem);
  if (!keeps_rows) {
    rows_.begin(problem);
    factors_.begin();
  }
  interior_.clear();
  done_ = {.extra_sweeps = sweeps_of_a_look};
  if (keeps_rows && last_is_answer()) return;
  best_.impulse = problem.impulse;
  // Where nothing moves and no row asks for anything, no impulses are the answer, and R_E has no scale.
  const bool rests = settings_.iterations > 0 && rows_.scale() == 0;
  if (rests) best_.impulse.assign(best_.impulse.size(), 0.0);
  center_.go_to(rows_, best_.impulse);
  best_.residual = std::numeric_limits<double>::infinity();
  note_center();
  // Nothing can be said of what is no number.
  const double good_start = std::max(goal(), rounding_of_answer());
  if (settings_.iterations > 0 && residual() > good_start && std::isfinite(residual())) approach(problem);
}

/// Whether what it gave before answers the rows as they are now.
bool IslandNewton::last_is_answer() {
  if (settings_.iterations == 0 || rows_.scale() == 0) return false;
  center_.stay(rows_);
  best_.residual = std::numeric_limits<double>::infinity();
  note_center();
  return residual() <= std::max(goal(), enough());
}

void IslandNewton::note_center() {
  if (!(residual() < best_.residual)) return;
  best_.residual = residual();
  rows_.copy_impulses(center_.x(), best_.impulse);
}

void IslandNewton::go_to(const PerRow<double>& impulse) {
  center_.go_to(rows_, impulse);
  note_center();
}

/// The best impulses so far after some sweeps: what Newton's method finds easier to begin with.
void IslandNewton::sweep(const VelocityProblem<double>& problem, int sweeps) {
  swept_ = problem;
  swept_.impulse = best_.impulse;
  AcceleratedProjectedGaussSeidel<double>({.iterations = sweeps}).solve(swept_);
  done_.extra_sweeps += sweeps;
  go_to(swept_.impulse);
}

double IslandNewton::residual() const {
  const double error = center_.error();
  return error == 0 ? 0 : error / rows_.scale();
}

double IslandNewton::first_softness() const {
  const double left = center_.size() > 0 && rows_.have_bounds() ? residual() : 0.0;
  const bool are_kept = factors_.are_for(rows_) && factors_.softness() > 0;
  if (are_kept && factors_.softness() >= caution_ * kept_softness * left) return factors_.softness();
  const double least = std::min(caution_ * least_warm_softness, cold_softness);
  return std::clamp(caution_ * warm_softness * left, least, cold_softness);
}

void IslandNewton::approach(const VelocityProblem<double>& problem) {
  double softness = first_softness();
  int failures = 0, idle = 0, sweeps = first_sweeps;
  while (best_.residual > goal() && failures < most_failures) {
    const double before = best_.residual;
    map_.soften(softness);
    const bool is_solved = solve_softened(failures == 0 ? 1 : settings_.iterations);
    center_.go_to(rows_, map_.x(), map_.response());
    note_center();
    if (is_solved) {
      if (best_.residual <= good_progress * before) continue;
      caution_ = std::max(caution_ / softness_step, 1.0);  // it may have been softer than need be
      go_on();
      if (best_.residual <= good_progress * before) continue;
      const bool stands_still = !(best_.residual <= least_progress * before);
      idle = stands_still && softness <= stiffest ? idle + 1 : 0;
      if (idle == most_idle) break;
      softness = std::max(softness / softness_step, stiffest);
      continue;
    }
    if (failures == 0 && softness < cold_softness)  // it was too stiff
      caution_ = std::min(softness_step * caution_, most_caution);
    if (best_.residual <= enough()) break;
    // What was found is kept where it is nearer. Where the interior does not lead there, and after many
    // failures, sweeps do.
    if (failures == 0) follow_interior();
    if (failures % failures_before_sweeps == 0) {
      if (best_.residual > enough()) {
        sweep(problem, sweeps);
        sweeps *= 2;
        softness = cold_softness;
      }
    } else {
      go_to(best_.impulse);
      softness = std::min(softness * softness_step, softest);
    }
    failures += 1;
    if (done_.iterations >= settings_.iterations) break;
  }
}

/// Past the last step; back to the best impulses where that is not better.
void IslandNewton::go_on() {
  center_.go_on(rows_, [this](int i) { return map_.is_held(i); });
  note_center();
  if (residual() == best_.residual) return;
  go_to(best_.impulse);
}

/// Seeks du with F(du) = 0 around the centre; the last evaluation is the answer.
bool IslandNewton::solve_softened(int most_systems) {
  const double small = std::max(1e-2 * residual(), 1e-1 * goal()) * rows_.scale();
  const int last_system = std::min(settings_.iterations, done_.iterations + most_systems);
  return steps_.solve(at(), small, steps_of_one_problem, [&] {
    return take_kept_step() || (done_.iterations < last_system && take_new_step());
  });
}

/// A step by factors of an earlier system, or of an earlier solve; false: they do not help, and nothing has
/// changed.
bool IslandNewton::take_kept_step() {
  if (!factors_.are_for(rows_) || factors_.softness() != map_.softness()) return false;
  done_.extra_sweeps += sweeps_of_a_kept_step;
  change_ = map_.value();
  factors_.solve(change_);
  return steps_.leap(at(), change_, kept_progress);
}

/// A step by factors of the moment, shortened until it helps; false: it does not.
bool IslandNewton::take_new_step() {
  Deadline::go_on();
  ++done_.iterations;
  factors_.factorize(rows_, map_, map_.softness());
  change_ = map_.value();
  factors_.solve(change_);
  return change_.allFinite() && steps_.shorten(at(), change_, least_part);
}

}  // namespace cairn
