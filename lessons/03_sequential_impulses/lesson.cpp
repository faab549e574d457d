// Lesson 03. Sequential impulses: the middle of Algorithm 1, which lesson 08 completes.
// A stack of boxes has begun to fall, and the ground and the boxes have to push it to rest. No matrix is
// built. We go from contact to contact, ask how fast its own two boxes approach each other, push just hard
// enough to stop that, and let both boxes have the new velocities immediately. Then we go round again.
// Everything that happens is kept, row by row, for the pictures and the table.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::stack;

// [sweep]
/// One sweep: a visit to every contact. problem.impulse holds what each has given so far, λΔt.
void sweep(int number, VelocityProblem<double>& problem, List<RowRecord>& updates) {
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    double& given = problem.impulse[i];

    const double jv = row_velocity(problem, row);      // how fast its two boxes part
    const double mass = effective_mass(problem, row);  // 1 / (j M⁻¹ jᵀ)
    const double corrective = (row.bias - jv) * mass;  // (22) times Δt; the bias is ζ, here 0
    const double before = given;
    given = before + corrective;                  // in total
    apply_impulse(problem, row, given - before);  // (23), (21): to both boxes, immediately

    updates.push_back({{number, i, jv, 1 / mass, corrective, before, given}, problem.velocity});
  }
}
// [/sweep]

StackRun solve_stack(const StackSettings& settings) {
  StackRun run = falling_stack(settings);
  VelocityProblem<double> problem = run.problem;
  run.sweeps.push_back(problem.impulse);  // nothing given yet
  for (int number = 1; number <= settings.sweeps; ++number) {
    sweep(number, problem, run.updates);
    run.sweeps.push_back(problem.impulse);
  }
  return run;
}

void run(Lesson& lesson) {
  const StackSettings settings{.boxes = lesson.whole("bodies"),
                               .dt = lesson.real("dt"),
                               .gravity = lesson.real("gravity"),
                               .sweeps = lesson.whole("sweeps"),
                               .order = lesson.choice("order"),
                               .seed = static_cast<std::uint64_t>(lesson.whole("seed"))};
  const StackRun stack = solve_stack(settings);
  tell_scene(lesson, stack);
  lesson.predict();
  tell_updates(lesson, stack);
  tell_sweeps(lesson, stack);
  lesson.answer({-velocities_after(stack, 1).back()}, 0.002,
                "Row 3 finds box 2 at 0.1 m/s and box 3 at 0.2 m/s, and makes both equally fast.");
  check_claims(lesson, stack);
  if (settings.order == "up") check_question(lesson, stack);
  lesson.film(stack_shots(stack));
  lesson.data(table_of(stack));
  List<double> numbers = lambda_after(stack, settings.sweeps);
  for (const Vec3<double>& v : stack.updates.back().velocity) numbers.push_back(v.y());
  lesson.fingerprint(numbers);
}

}  // namespace

int main(int argc, char** argv) { return run_lesson(card(), run, argc, argv); }
