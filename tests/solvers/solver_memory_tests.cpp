// What solvers store, and what they refuse to store.
#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

List<SolverMaker<double>> solvers_that_count_memory() {
  return {maker<SequentialImpulse<double>, double>(),
          maker<ProjectedGaussSeidel<double>, double>(),
          maker<SparseProjectedGaussSeidel<double>, double>(),
          maker<FactoredProjectedGaussSeidel<double>, double>(),
          maker<NaiveProjectedGaussSeidel<double>, double>(),
          maker<NewtonSolver<double>, double>()};
}

/// How many bytes a solver kept for a stack of boxes.
template <typename SolverType>
std::ptrdiff_t memory_for_boxes(int boxes) {
  VelocityProblem<double> problem = hand_made_stack<double>(boxes, 10, 0.02);
  SolverType solver({.iterations = 1});
  solver.solve(problem);
  return static_cast<std::ptrdiff_t>(solver.memory());
}

}  // namespace

TEST_CASE("what each form of PGS stores is what it says") {
  const std::ptrdiff_t real = sizeof(double), index = sizeof(int), place = sizeof(std::ptrdiff_t);
  for (const int m : {1, 10, 20, 40}) {
    CAPTURE(m);
    const int n = m + 1;  // the boxes and the ground
    CHECK(memory_for_boxes<ProjectedGaussSeidel<double>>(m) == (m * m + 3 * n * m + 6 * n + 2 * m) * real);
    CHECK(memory_for_boxes<SequentialImpulse<double>>(m) == m * real);
    CHECK(memory_for_boxes<NaiveProjectedGaussSeidel<double>>(m) == (m + 3 * n) * real);
    CHECK(memory_for_boxes<FactoredProjectedGaussSeidel<double>>(m) ==
          m * (16 * real + 4 * index) + 6 * n * real);

    // A is tridiagonal. Beside it stand its diagonal, b, lambda and v_1; and of every row its two bodies, of
    // every body its rows: all rows but the lowest act on two.
    const int entries = 3 * m - 2;
    CHECK(coupled_pairs(hand_made_stack<double>(m, 10, 0.02)) == entries);
    const std::ptrdiff_t matrix = entries * (real + index) + (m + 1) * place;
    const std::ptrdiff_t lists = (m + 1) * place + (n + 1) * place + 2 * (2 * m - 1) * index;
    CHECK(memory_for_boxes<SparseProjectedGaussSeidel<double>>(m) == matrix + lists + (3 * m + 3 * n) * real);
  }
}

TEST_CASE("the memory of a solver is that of its last solve") {
  for (const SolverMaker<double>& make : solvers_that_count_memory()) {
    const auto solver = make({.iterations = 1});
    CAPTURE(solver->name());
    CHECK(solver->memory() == 0);
    VelocityProblem<double> small = hand_made_stack<double>(5, 10, 0.02), same = small;
    VelocityProblem<double> large = hand_made_stack<double>(50, 10, 0.02);
    solver->solve(small);
    const std::size_t first = solver->memory();
    solver->solve(large);
    CHECK(solver->memory() > first);
    solver->solve(same);
    CHECK(solver->memory() == first);
  }
}

TEST_CASE("naive PGS refuses a problem that would take too long") {
  const int rows = NaiveProjectedGaussSeidel<double>::max_rows + 1;
  VelocityProblem<double> problem = hand_made_stack<double>(rows, 10, 0.02);
  CHECK_THROWS_WITH_AS(NaiveProjectedGaussSeidel<double>().solve(problem),
                       "NaiveProjectedGaussSeidel: sweeps over 5001 rows, above the limit of 5000, take time "
                       "with their square; SequentialImpulse needs time linear in the rows",
                       std::length_error);
}

TEST_CASE("sparse PGS refuses rows that all meet on one body, and takes as many that do not") {
  const int rows = 5001;
  SparseProjectedGaussSeidel<double> solver({.iterations = 1});
  VelocityProblem<double> stack = hand_made_stack<double>(rows, 10, 0.02);
  CHECK(solver.solve(stack).iterations == 1);

  VelocityProblem<double> star = hand_made_stack<double>(rows, 10, 0.02);
  for (ConstraintRow<double>& row : star.rows) {
    row.a = ground;
    row.b = {1};
  }
  CHECK_THROWS_WITH_AS(solver.solve(star),
                       "SparseProjectedGaussSeidel: 25010001 pairs of rows on a body are above the limit of "
                       "25000000; SequentialImpulse needs memory linear in the rows",
                       std::length_error);
}
