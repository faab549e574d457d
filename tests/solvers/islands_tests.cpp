// The islands of a problem, and Newton's method on each by itself.
#include <cairn/constraints/converted.hpp>
#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// So many stacks of boxes side by side, each a box higher than the one before; the top boxes are heavy.
VelocityProblem<double> stacks(int count) {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k <= i; ++k)
      scene.add({.shapes = {box(1, 1)}, .position = {3.0 * i, 0.5 + k}, .density = k == i ? 30.0 : 1.0});
  }
  World<double> world(scene);
  return world.velocity_problem();
}

template <Scalar Real>
List<IslandProblem<Real>> islands_of(const VelocityProblem<Real>& problem) {
  Islands islands;
  islands.find(problem);
  List<IslandProblem<Real>> result(islands.count());
  for (int i = 0; i < islands.count(); ++i) islands.copy(i, problem, result[i]);
  return result;
}

}  // namespace

TEST_CASE("stacks side by side are islands: the ground connects nothing") {
  const VelocityProblem<double> whole = stacks(4);
  Islands islands;
  islands.find(whole);
  REQUIRE(islands.count() == 4);
  CHECK_FALSE(islands.are_one());
  int rows = 0, first = 1;
  for (int i = 0; i < 4; ++i) {
    CHECK(islands.lowest_body(i) == BodyId{first});
    first += i + 1;
    IslandProblem<double> island;
    islands.copy(i, whole, island);
    // The ground and i + 1 boxes; two points with friction for each of i + 1 contacts.
    CHECK(island.bodies.size() == i + 2);
    CHECK(island.rows.size() == 4 * (i + 1));
    CHECK(island.problem.number.value() != 0);
    for (int row = 0; row < island.rows.size(); ++row) {
      const ConstraintRow<double>& own = island.problem.rows[row];
      const ConstraintRow<double>& given = whole.rows[island.rows[row]];
      CHECK(island.bodies[own.a.index] == given.a);
      CHECK(island.bodies[own.b.index] == given.b);
      CHECK(own.jacobian_b == given.jacobian_b);
      CHECK(own.bounds.friction == given.bounds.friction);
      if (given.bounds.is_friction()) CHECK(island.rows[own.bounds.normal_row] == given.bounds.normal_row);
      CHECK(row_velocity(island.problem, own) == row_velocity(whole, given));
    }
    rows += island.rows.size();
  }
  CHECK(rows == whole.row_count());
  islands.find(stacks(1));
  CHECK(islands.count() == 1);
  CHECK(islands.are_one());
  islands.find(VelocityProblem<double>{});
  CHECK(islands.count() == 0);
  CHECK_FALSE(islands.are_one());
}

TEST_CASE("all bodies of a row are in its island, those beyond two as well") {
  Scene scene;
  for (int i = 0; i < 4; ++i) scene.add({.shapes = {circle(1)}, .position = {3.0 * i, 0}});
  for (const int i : {1, 4}) scene.join<RevoluteJoint>({.a = ground, .b = {i}, .anchor = {3.0 * (i - 1), 0}});
  Islands islands;
  islands.find(World<double>(scene).velocity_problem());
  CHECK(islands.count() == 2);
  CHECK(islands.lowest_body(1) == BodyId{4});
  scene.join<GearJoint>({.a = {2}, .b = {3}, .c = {4}});
  const VelocityProblem<double> whole = World<double>(scene).velocity_problem();
  islands.find(whole);
  REQUIRE(islands.count() == 2);
  CHECK(islands.lowest_body(1) == BodyId{2});
  IslandProblem<double> island;
  islands.copy(1, whole, island);
  CHECK(island.rows.size() == 3);  // two of the pin, one of the gear
  CHECK(island.problem.extra_terms.size() == whole.extra_terms.size());
  for (int row = 0; row < 3; ++row)
    CHECK(inverse_effective_mass(island.problem, island.problem.rows[row]) ==
          inverse_effective_mass(whole, whole.rows[island.rows[row]]));
  scene.join<GearJoint>({.a = {1}, .b = {2}});
  islands.find(World<double>(scene).velocity_problem());
  CHECK(islands.count() == 1);
  CHECK(islands.are_one());
}

TEST_CASE_TEMPLATE("Newton's method gives an island the same bits whatever is beside it", Real, float,
                   double) {
  const VelocityProblem<Real> start = converted<Real>(stacks(4));
  VelocityProblem<Real> whole = start;
  NewtonSolver<Real> solver({.iterations = 30});
  CHECK(solver.solve(whole).converged);
  for (IslandProblem<Real>& island : islands_of(start)) {
    IslandNewton alone({.iterations = 30}, std::numeric_limits<Real>::epsilon());
    alone.solve(island.problem);
    for (int row = 0; row < island.rows.size(); ++row)
      CHECK(whole.impulse[island.rows[row]] == static_cast<Real>(island.problem.impulse[row]));
    for (int body = 0; body < island.bodies.size(); ++body)
      CHECK(whole.velocity[island.bodies[body]] == island.problem.velocity[{body}].template cast<Real>());
  }
}

TEST_CASE("an island keeps its answer while others change and go") {
  const VelocityProblem<double> start = stacks(4);
  NewtonSolver<double> solver({.iterations = 30, .tolerance = 1e-9});
  VelocityProblem<double> first = start;
  CHECK(solver.solve(first).iterations > 0);
  // As warm as before, but for the highest stack, which is pushed down.
  VelocityProblem<double> pushed = start;
  pushed.impulse = first.impulse;
  pushed.velocity.back().y() -= 1;
  CHECK(solver.solve(pushed).converged);
  const List<IslandProblem<double>> islands = islands_of(start);
  for (int i = 0; i < islands.size(); ++i) {
    bool is_same = true;
    for (const int row : islands[i].rows)
      is_same = is_same && pushed.impulse[row] == doctest::Approx(first.impulse[row]).epsilon(4e-16);
    CHECK(is_same == (i < 3));
  }
  // Without the highest stack: its rows have the same names.
  VelocityProblem<double> fewer = stacks(3);
  for (int row = 0; row < fewer.row_count(); ++row) {
    for (int k = 0; k < start.row_count(); ++k)
      if (start.rows[k].key == fewer.rows[row].key) fewer.impulse[row] = first.impulse[k];
  }
  const SolveReport rest = solver.solve(fewer);
  CHECK(rest.iterations == 0);
  CHECK(rest.converged);
}

TEST_CASE("of several islands the worst is told, and a NaN is the worst") {
  VelocityProblem<double> problem = stacks(3);
  problem.velocity[{1}].y() = std::numeric_limits<double>::quiet_NaN();
  const SolveReport report = NewtonSolver<double>({.iterations = 30}).solve(problem);
  CHECK_FALSE(report.converged);
  CHECK_FALSE(std::isfinite(*report.residual));
  for (const BodyId body : problem.velocity.indices())
    if (body.index > 1) CHECK(problem.velocity[body].allFinite());
}
