// Lesson 07. PGS on A λ = b and SI, row by row.
// A random problem, solved by both. PGS asks the matrix what all other rows already do to this one; SI asks
// the two bodies of the row how they move by now. Equation (26) says that both hear the same. So we compute
// every update of the first sweep both ways, and with the step (29) between them, and look for the digit in
// which they part; then we run the library's two solvers for many sweeps in three precisions.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::twice;

// [both]
/// (27), SI: how do the row's own bodies move, and how much more λ stops that?
double by_27(const VelocityProblem<double>& problem, double eta, int i) {
  const ConstraintRow<double>& row = problem.rows[i];
  return eta + (row.bias - row_velocity(problem, row)) / (inverse_effective_mass(problem, row) * problem.dt);
}

/// (28), PGS: what do all other rows do to this one, and which λ is left for it?
double by_28(const SystemMatrices<double>& system, const PerRow<double>& eta, int i) {
  double others = 0;
  for (int j = 0; j < eta.size(); ++j)
    if (j != i) others += system.A(i, j) * eta[j];
  return (system.b(i) - others) / system.A(i, i);
}
// [/both]

/// (29): as (28), but the row's own share is added and taken away, so that all of A_i η stands together.
double by_29(const SystemMatrices<double>& system, const PerRow<double>& eta, int i) {
  double all = 0;
  for (int j = 0; j < eta.size(); ++j) all += system.A(i, j) * eta[j];
  const double a_ii = system.A(i, i);
  return (-all + a_ii * eta[i]) / a_ii + system.b(i) / a_ii;
}

/// One sweep of both. PGS has its η and A; SI has its η and the velocities, and never sees A.
List<RowStep> sweep_both(VelocityProblem<double> si, const SystemMatrices<double>& system) {
  PerRow<double> eta_pgs(si.row_count(), 0.0), eta_si = eta_pgs;
  List<RowStep> steps;
  for (int i = 0; i < si.row_count(); ++i) {
    const bool one_sided = si.rows[i].bounds.is_unilateral();
    RowStep step{.row = i, .eta = eta_si[i], .row_velocity = row_velocity(si, si.rows[i])};
    step.by_27 = by_27(si, eta_si[i], i);
    step.by_28 = by_28(system, eta_pgs, i);
    step.by_29 = by_29(system, eta_pgs, i);

    // [update]
    eta_pgs[i] = step.pgs = one_sided ? std::max(step.by_28, 0.0) : step.by_28;
    eta_si[i] = step.si = one_sided ? std::max(step.by_27, 0.0) : step.by_27;
    apply_impulse(si, si.rows[i], (step.si - step.eta) * si.dt);  // SI pushes immediately: (26) holds again
    // [/update]
    steps.push_back(step);
  }
  return steps;
}

void run(Lesson& lesson) {
  const TwiceSettings settings{.sweeps = lesson.whole("sweeps"),
                               .dt = lesson.real("dt"),
                               .seed = static_cast<std::uint64_t>(lesson.whole("seed"))};
  TwiceRun twice = solve_with_the_library(settings);
  twice.steps = sweep_both(twice.problem, twice.system);
  tell_scene(lesson, settings);
  lesson.predict();
  tell_first_sweep(lesson, twice);
  tell_precisions(lesson, twice);
  lesson.answer(
      {twice.pgs_off / twice.si_off}, 0.05,
      "The errors are equal after every sweep: both are one algorithm, and only rounding tells them apart.");
  check_claims(lesson, twice);
  check_masses(lesson, twice);
  lesson.film(twice_shots(twice));
  lesson.data(table_of(twice));
  const PerRow<double>& last = twice.si.back();
  lesson.fingerprint(List<double>(last.begin(), last.end()));
}

}  // namespace

int main(int argc, char** argv) { return run_lesson(card(), run, argc, argv); }
