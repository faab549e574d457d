// What every solver must do, for every scalar.
#include <doctest/doctest.h>

#include <limits>

#include "solver_list.hpp"
#include "solvers/residual.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A box on two feet that slides: two normal rows with a friction row each, and a rod from the box to a ball
/// above it. Every kind of row, some at their bounds.
template <Scalar Real>
VelocityProblem<Real> sliding_box_with_a_rod() {
  VelocityProblem<Real> problem;
  problem.dt = Real(0.02);
  problem.inverse_mass = {Vec3<Real>::Zero(), Vec3<Real>(1, 1, 6), Vec3<Real>(2, 2, 8)};
  problem.velocity = {Vec3<Real>::Zero(), Vec3<Real>(3, Real(-0.2), 0), Vec3<Real>(0, Real(-0.2), 1)};
  for (const Real foot : {Real(-0.5), Real(0.5)}) {
    ConstraintRow<Real> normal;
    normal.b = {1};
    normal.jacobian_b = {0, 1, foot};
    normal.bounds = Bounds<Real>::unilateral();
    ConstraintRow<Real> friction;
    friction.b = {1};
    friction.jacobian_b = {1, 0, Real(0.5)};
    friction.bounds = Bounds<Real>::coulomb(Real(0.3), problem.row_count());
    problem.rows.push_back(normal);
    problem.rows.push_back(friction);
  }
  ConstraintRow<Real> rod;
  rod.a = {1};
  rod.b = {2};
  rod.jacobian_a = {Real(-0.6), Real(-0.8), Real(-0.1)};
  rod.jacobian_b = {Real(0.6), Real(0.8), 0};
  rod.bias = Real(0.05);
  problem.rows.push_back(rod);
  problem.blocks = {{0, 4}, {4, 1}};
  problem.impulse.assign(problem.rows.size(), Real(0));
  return problem;
}

template <Scalar Real>
class BoundsWatcher final : public SolveObserver<Real> {
 public:
  bool watches_rows() const override { return true; }
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override {
    const Bounds<Real>& bounds = problem.rows[update.row].bounds;
    violations += bounds.clamp(update.impulse_after, problem.impulse) != update.impulse_after;
    updates += 1;
  }
  int violations = 0;
  int updates = 0;
};

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
    BoundsWatcher<Real> watcher;
    make({.iterations = 20})->solve(problem, &watcher);
    CHECK(watcher.violations == 0);
    CHECK(watcher.updates == 20 * problem.row_count());
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
    for (const BodyId body : first.velocity.indices()) CHECK(first.velocity[body] == second.velocity[body]);
  }
}

TEST_CASE_TEMPLATE("an observer changes nothing", Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> alone = sliding_box_with_a_rod<Real>();
    VelocityProblem<Real> watched = alone;
    BoundsWatcher<Real> watcher;
    make({.iterations = 9})->solve(alone);
    make({.iterations = 9})->solve(watched, &watcher);
    CHECK(alone.impulse == watched.impulse);
  }
}

TEST_CASE("no sweeps at all apply the warm start and nothing else") {
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> problem = hand_made_stack<double>(1, 10, 0.5);
    problem.impulse[0] = 2;  // less than the 5 N s that would hold the box
    const SolveReport report = make({.iterations = 0})->solve(problem);
    CHECK(report.iterations == 0);
    CHECK(problem.impulse[0] == 2);
    CHECK(problem.velocity[{1}].y() == -5 + 2);
  }
}

TEST_CASE("a problem without rows is solved by leaving it alone") {
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> problem;
    problem.velocity = {Vec3<double>(1, 2, 3)};
    problem.inverse_mass = {Vec3<double>(1, 1, 1)};
    make({})->solve(problem);
    CHECK(problem.velocity[{0}] == Vec3<double>(1, 2, 3));
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
