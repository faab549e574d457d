// What the number of a problem says, and what solvers do with it.
#include "solver_list.hpp"

using namespace cairn;

namespace {

/// Boxes on each other, beside three in a chain.
VelocityProblem<double> boxes_and_pins() {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < 4; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0.1 * i, 0.5 + i}});
  BodyId last = ground;
  for (int i = 0; i < 3; ++i) {
    const BodyId link = scene.add({.shapes = {box(1, 0.2)}, .position = {5.5 + i, 6}});
    scene.join<RevoluteJoint>({.a = last, .b = link, .anchor = {5.0 + i, 6}});
    last = link;
  }
  return World(scene).velocity_problem();
}

/// What may differ between problems of one number.
void push_otherwise(VelocityProblem<double>& problem) {
  for (int i = 0; i < problem.row_count(); ++i) {
    if (problem.rows[i].bounds.is_equality()) problem.rows[i].bias += 0.1 * (i % 3);
    problem.impulse[i] *= 0.5;
  }
  for (Vec3<double>& v : problem.velocity) v *= 0.75;
}

}  // namespace

TEST_CASE("a problem has the number that it was given, and a copy of it has none") {
  VelocityProblem<double> problem;
  CHECK(problem.number.value() == 0);
  problem.number.renew();
  const std::uint64_t first = problem.number.value();
  CHECK(first != 0);
  CHECK(VelocityProblem<double>(problem).number.value() == 0);
  VelocityProblem<double> other;
  other.number.renew();
  CHECK(other.number.value() != first);
  other = problem;
  CHECK(other.number.value() == 0);
  problem.number.renew();
  CHECK(problem.number.value() != first);
}

TEST_CASE("a problem of the number before is solved as if it had none, by solvers that keep no answer") {
  for (const auto& make : testing::all_solvers<double>(testing::Iterates::any)) {
    VelocityProblem<double> problem = boxes_and_pins();
    const auto solver = make({.iterations = 8}), fresh = make({.iterations = 8});
    CAPTURE(solver->name());
    problem.number.renew();
    solver->solve(problem);
    push_otherwise(problem);
    VelocityProblem<double> same = problem;
    solver->solve(problem);
    fresh->solve(same);
    CHECK(problem.impulse == same.impulse);
    CHECK(problem.velocity == same.velocity);
    problem.rows[0].softness = 0.25;  // with which matrices of blocks are others
    same = problem;
    solver->solve(problem);
    fresh->solve(same);
    CHECK(problem.impulse == same.impulse);
  }
}
