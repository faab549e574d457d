// What every solver must do, for every scalar.
#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A box on two feet that slides: two normal rows with a friction row each, and a rod from the box to a ball
/// above it. Every kind of row, some at their bounds.
template <Scalar Real>
VelocityProblem<Real> sliding_box_with_a_rod() {
  VelocityProblem<Real> problem = box_on_feet<Real>({Real(-0.5), Real(0.5)}, {3, Real(-0.2), 0}, Real(0.3));
  problem.dt = Real(0.02);
  ConstraintRow<Real> rod;
  rod.a = {1};
  rod.b = add_body<Real>(problem, Real(0.5), Real(0.125), {0, Real(-0.2), 1});
  rod.jacobian_a = {Real(-0.6), Real(-0.8), Real(-0.1)};
  rod.jacobian_b = {Real(0.6), Real(0.8), 0};
  rod.bias = Real(0.05);
  add_row(problem, rod);
  return problem;
}

}  // namespace

TEST_CASE_TEMPLATE("a solver that starts from the answer stays there", Real, float, double) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> problem = sliding_box_with_a_rod<Real>();
    const VelocityProblem<Real> start = problem;
    make({.iterations = 2000})->solve(problem);
    VelocityProblem<Real> again = start;
    again.impulse = problem.impulse;
    make({.iterations = 1})->solve(again);
    // One sweep adds at most a rounding of each of its terms: impulses here are below 4 N s.
    for (int i = 0; i < again.impulse.size(); ++i) {
      CHECK(std::abs(again.impulse[i] - problem.impulse[i]) <= 64 * epsilon * 4);
    }
  }
}

TEST_CASE_TEMPLATE("every impulse is inside its bounds after every row update", Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> problem = sliding_box_with_a_rod<Real>();
    RowWatcher<Real> watcher;
    make({.iterations = 20})->solve(problem, &watcher);
    CHECK(watcher.outside == 0);
    CHECK(watcher.rows.size() == 20 * problem.row_count());
  }
}

TEST_CASE_TEMPLATE("a converged solver leaves no residual, and friction at its bound", Real, float, double) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> problem = sliding_box_with_a_rod<Real>();
    const Real scale = residual_scale(problem);
    make({.iterations = 2000})->solve(problem);
    // 2000 sweeps of 5 rows round velocities of about 3 m/s; errors do not grow, as every sweep contracts.
    CHECK(residual(problem, scale).energy <= 1000 * epsilon);
    CHECK(problem.impulse[1] == doctest::Approx(static_cast<double>(-Real(0.3) * problem.impulse[0])));
  }
}

TEST_CASE_TEMPLATE("the same problem gives the same bits twice", Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> first = sliding_box_with_a_rod<Real>();
    VelocityProblem<Real> second = first;
    const auto solver = make({.iterations = 7});
    solver->solve(first);
    solver->solve(second);
    CHECK(first.impulse == second.impulse);
    CHECK(first.velocity == second.velocity);
  }
}

TEST_CASE("a solver stops when the residual asked for is reached, and says so") {
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> problem = hand_made_stack<double>(10, 10, 0.02);
    const double scale = residual_scale(problem);
    const std::unique_ptr<Solver<double>> solver = make({.iterations = 100000, .tolerance = 1e-6});
    const SolveReport report = solver->solve(problem);
    CHECK(report.converged);
    CHECK(residual(problem, scale).energy <= 1e-6);
    VelocityProblem<double> sooner = hand_made_stack<double>(10, 10, 0.02);
    // Not a sweep too late; lanes look at R_E so much later at the soonest (Stopping).
    const bool in_lanes = solver->name().starts_with("wide");
    const int late = in_lanes ? 3 + report.iterations / 16 : 1;
    make({.iterations = report.iterations - late})->solve(sooner);
    CHECK(residual(sooner, scale).energy > 1e-6);
  }
}

TEST_CASE("settings that no solver can work with are refused") {
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    CHECK_THROWS_AS(make({.iterations = -1}), std::invalid_argument);
    CHECK_THROWS_AS(make({.tolerance = -1.0}), std::invalid_argument);
    CHECK_THROWS_AS(make({.tolerance = std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  }
}

TEST_CASE("dense PGS refuses a matrix that would not fit, before allocating it") {
  VelocityProblem<double> problem =
      hand_made_stack<double>(ProjectedGaussSeidel<double>::max_rows + 1, 10, 0.02);
  CHECK_THROWS_WITH_AS(ProjectedGaussSeidel<double>().solve(problem),
                       "ProjectedGaussSeidel: a dense A of 5001 rows is above the limit of 5000; "
                       "SequentialImpulse needs memory linear in the rows",
                       std::length_error);
}
