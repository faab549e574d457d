// Lesson 06. A λ = b without elimination: guess all λ, put one row right, then the next, and sweep again.
// That is Gauss-Seidel (28). Where a row only pushes, its λ is clamped to 0 immediately: projected
// Gauss-Seidel, which finds out which contacts push and which let go: here those of a rod on two supports.
// The loop stands here; the library's solver runs beside it and is recorded.
#include "lesson.hpp"

namespace cairn::sweeps {

/// A contact that pushes the rod upwards, `arm` [m] to the right of its centre, and the ground down.
void add_contact(VelocityProblem<double>& problem, double arm) {
  ConstraintRow<double> row;
  row.a = {0};
  row.b = {1};
  row.jacobian_a = {0, -1, 0};
  row.jacobian_b = {0, 1, arm};
  row.bounds = Bounds<double>::unilateral();
  row.key = {.source = static_cast<std::uint64_t>(problem.row_count())};
  problem.blocks.push_back({problem.row_count(), 1});
  problem.rows.push_back(row);
  problem.impulse.push_back(0);
}

VelocityProblem<double> rod_problem(const SweepSettings& settings) {
  VelocityProblem<double> problem;
  problem.dt = settings.dt;
  problem.inverse_mass = {{0, 0, 0}, {1 / rod_mass, 1 / rod_mass, 1 / rod_inertia}};
  problem.velocity = {{0, 0, 0}, {0, -gravity * settings.dt, 0}};
  add_contact(problem, -rod_length / 2);
  add_contact(problem, settings.support - rod_length / 2);
  return problem;
}

void sweep_by_hand(const SystemMatrices<double>& system, double lowest, Vector<double>& lambda) {
  const Matrix<double>& A = system.A;
  // [sweep]
  for (int i = 0; i < A.rows(); ++i) {
    double rest = system.b(i);
    for (int j = 0; j < A.cols(); ++j)
      if (j != i) rest -= A(i, j) * lambda(j);  // the newest λ that there is

    lambda(i) = rest / A(i, i);               // (28): now row i is right
    lambda(i) = std::max(lowest, lambda(i));  // its interval: from 0 for a contact, from −∞ for a joint
  }
  // [/sweep]
}

Swept swept(VelocityProblem<double> problem, int sweeps) {
  const SystemMatrices<double> system = system_matrices(problem);
  ProjectedGaussSeidel<double> solver({.iterations = sweeps});
  SweepRecorder<double> recorder(SweepRecorder<double>::Detail::rows);
  solver.solve(problem, &recorder);
  Swept result = recorded(recorder, problem.dt);
  result.velocity = problem.velocity;
  Vector<double> by_hand = Vector<double>::Zero(problem.row_count());  // and the same sweeps by hand
  for (int k = 1; k < result.by_sweep.size(); ++k) {
    sweep_by_hand(system, problem.rows[0].bounds.lower, by_hand);
    for (int i = 0; i < by_hand.size(); ++i)
      result.gap = std::max(result.gap, std::abs(by_hand(i) - result.by_sweep[k][i]));
  }
  return result;
}

}  // namespace cairn::sweeps

namespace {

using namespace cairn;
using namespace cairn::sweeps;

void run(Lesson& lesson) {
  const SweepRun all = run_sweeps(
      {.dt = lesson.real("dt"), .sweeps = lesson.whole("sweeps"), .support = lesson.real("support")});
  print_scene(lesson, all.settings);
  lesson.predict();
  lesson.print();
  print_rod(lesson, all);
  print_intervals(lesson);
  lesson.answer(
      {all.rod.formula[1]}, 1e-6,
      all.rod.tips()
          ? "Less than the unclamped answer: the right support had to push against the pull as well. "
            "Without it the rod tips, and only one point of it is held."
          : "Here both supports push, and the clamp has nothing to do.");
  check_rod(lesson, all);
  lesson.film(sweep_shots(all));
  lesson.data(updates_table(all));
  const PerRow<double>& last = all.rod.bounded.by_sweep.back();
  lesson.fingerprint(List<double>(last.begin(), last.end()));
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(card(), run, argc, argv); }
