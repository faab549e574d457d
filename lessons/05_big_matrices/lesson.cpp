// Lesson 05. All bodies and all rows together. The rows are written below each other, which makes J (6); the
// velocities likewise make v. The forces that make J v = ζ true (11) solve A λ = b, (14) and (15): one
// equation for each contact. We build A and b for a stack of boxes, solve them, and put λ into (12) to see
// that the stack stands still.
#include "lesson.hpp"

namespace cairn::big {

StackSystem assemble(const VelocityProblem<double>& problem) {
  const Eigen::Index rows = problem.row_count(), bodies = problem.body_count() - 1;  // without the ground
  StackSystem system{.J = Eigen::MatrixXd::Zero(rows, 3 * bodies),
                     .inverse_mass = Eigen::VectorXd(3 * bodies),
                     .velocity = Eigen::VectorXd(3 * bodies),
                     .zeta = Eigen::VectorXd(rows),
                     .dt = problem.dt};
  // [assemble]
  for (int i = 0; i < rows; ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    if (row.a != ground) system.J.block<1, 3>(i, 3 * row.a.index - 3) = row.jacobian_a.transpose();  // (6)
    system.J.block<1, 3>(i, 3 * row.b.index - 3) = row.jacobian_b.transpose();
    system.zeta(i) = row.bias;
  }
  for (const BodyId body : problem.velocity.indices()) {
    if (body == ground) continue;
    const int column = 3 * body.index - 3;
    system.velocity.segment<3>(column) = problem.velocity[body];          // (1)
    system.inverse_mass.segment<3>(column) = problem.inverse_mass[body];  // (2)
  }
  system.A = system.J * system.inverse_mass.asDiagonal() * system.J.transpose();  // (15)
  system.b = (system.zeta - system.J * system.velocity) / system.dt;
  // [/assemble]
  return system;
}

Eigen::VectorXd velocity_after(const StackSystem& system, const Eigen::VectorXd& lambda) {
  const Eigen::VectorXd impulse = system.J.transpose() * lambda * system.dt;
  return system.velocity + system.inverse_mass.cwiseProduct(impulse);  // (12)
}

}  // namespace cairn::big

namespace {

using namespace cairn;
using namespace cairn::big;

StackRun solve_stack(const StackSettings& settings) {
  StackRun run{.settings = settings};
  const VelocityProblem<double> problem = stack_rows(settings, gravity);
  run.system = assemble(problem);
  run.lambda = solution_of(run.system);
  run.velocity = velocity_after(run.system, run.lambda);
  solve_otherwise(problem, run);
  return run;
}

void run(Lesson& lesson) {
  StackSettings settings{.boxes = lesson.whole("boxes"), .dt = lesson.real("dt"), .top = lesson.real("top")};
  const StackRun stack = solve_stack(settings);
  settings.top = heavy_mass;
  const StackRun heavy = solve_stack(settings);
  print_scene(lesson, stack);
  lesson.predict();
  lesson.print();
  print_matrices(lesson, stack);
  print_right_side(lesson, stack, heavy);
  print_solution(lesson, stack);
  lesson.answer({static_cast<double>(changed_numbers(stack, heavy))}, 1e-9,
                "Boxes that fall together do not approach each other, whatever they weigh. b sees only the "
                "contact with the ground; the masses are in A.");
  check_matrices(lesson, stack);
  check_solution(lesson, stack);
  check_question(lesson, stack, heavy);
  lesson.film(stack_shots(stack, heavy));
  lesson.data(entries_table(stack));
  List<double> answer(stack.lambda.begin(), stack.lambda.end());
  answer.insert(answer.end(), stack.velocity.begin(), stack.velocity.end());
  lesson.fingerprint(answer);
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(card(), run, argc, argv); }
