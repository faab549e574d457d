// Lesson 16. Jacobi: everybody at once.
// Gauss-Seidel goes from row to row, and each row sees what the one before has done. Here all rows look at
// the same velocities, and only then do all of them act: nobody waits, and nobody comes first. But rows that
// share a body correct the same error several times over. A box on three feet is thrown up, let go, and
// thrown up again, for ever, unless each row gives less: ω of it (damped), or what its share of the body's
// mass asks for (split).
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::everybody;

/// ω / D_ii: what row i gives of its error ζ − j·v. The ground cannot be moved, so that D_ii is the box's
/// part alone.
PerRow<double> shares_of_error(const VelocityProblem<double>& problem, Method method, double omega) {
  PerRow<double> give;
  for (const ConstraintRow<double>& row : problem.rows) {
    double divisor = inverse_effective_mass(problem, row);        // A_ii, as in Gauss-Seidel
    if (method == Method::split) divisor *= problem.row_count();  // the box, in as many parts as it has rows
    give.push_back((method == Method::damped ? omega : 1) / divisor);
  }
  return give;
}

/// One sweep of Jacobi.
void sweep_at_once(VelocityProblem<double>& problem, const PerRow<double>& give) {
  // [at_once]
  PerRow<double> next;
  for (int i = 0; i < problem.row_count(); ++i) {  // all look at the same v ...
    const ConstraintRow<double>& row = problem.rows[i];
    const double corrective = (row.bias - row_velocity(problem, row)) * give[i];  // (22), times Δt
    next.push_back(row.bounds.clamp(problem.impulse[i] + corrective, problem.impulse));
  }
  for (int i = 0; i < problem.row_count(); ++i) {                           // ... and all of it acts, once
    apply_impulse(problem, problem.rows[i], next[i] - problem.impulse[i]);  // (21)
    problem.impulse[i] = next[i];
  }
  // [/at_once]
}

/// One sweep of Gauss-Seidel, SI: the same lines, in one loop.
void sweep_in_turn(VelocityProblem<double>& problem, const PerRow<double>& give) {
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    const double corrective = (row.bias - row_velocity(problem, row)) * give[i];  // (22), times Δt
    const double next = row.bounds.clamp(problem.impulse[i] + corrective, problem.impulse);
    apply_impulse(problem, row, next - problem.impulse[i]);  // (21): the next row sees it
    problem.impulse[i] = next;
  }
}

/// The box on its feet, sweep by sweep.
FeetHistory stand(const FeetRun& run, Method method) {
  VelocityProblem<double> problem = run.problem;
  const PerRow<double> give = shares_of_error(problem, method, run.settings.omega);
  FeetHistory history{.method = method};
  for (int k = 0; k <= run.settings.sweeps; ++k) {
    if (k > 0 && method == Method::sequential) sweep_in_turn(problem, give);
    if (k > 0 && method != Method::sequential) sweep_at_once(problem, give);
    history.speed.push_back(problem.velocity[{1}].y());
    List<double>& lambda = history.lambda.emplace_back();
    for (const double impulse : problem.impulse) lambda.push_back(impulse / problem.dt);
  }
  return history;
}

void run(Lesson& lesson) {
  FeetRun feet = box_on_feet({.feet = lesson.whole("feet"), .omega = lesson.real("omega")});
  for (const Method method : all_methods) feet.histories.push_back(stand(feet, method));
  const PileRun pile = run_pile({.base = lesson.whole("base"), .omega = lesson.real("omega")});
  lesson.print(fmt::format(
      "Scene: a box of {:g} kg on {} feet from x = −{} to {} m, Δt = {:g} s; then a pyramid of {} boxes",
      box_mass, feet.settings.feet, outermost, outermost, time_step, pile.problem.body_count() - 1));
  lesson.predict();
  report(lesson, feet, pile);
  lesson.film(everybody_shots(feet, pile));
  lesson.data(sweeps_table(feet, pile));
  lesson.fingerprint(pile.snapshot);
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), run, argc, argv); }
