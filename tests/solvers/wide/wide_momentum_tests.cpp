// Momentum in lanes: that of AcceleratedProjectedGaussSeidel in the same order.
#include "solvers/solver_list.hpp"
#include <cairn/constraints/converted.hpp>
#include "lane_grid.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

template <Scalar Real>
List<int> order_in_lanes(const VelocityProblem<Real>& start) {
  OrderWatcher<Real> watcher;
  VelocityProblem<Real> problem = start;
  WideSequentialImpulse<Real>({.iterations = 1}).solve(problem, &watcher);
  return watcher.rows;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "momentum in lanes is that of accelerated PGS in the same order, to a rounding of a change", Real, float,
    double) {
  for (const double relaxation : {1.0, 1.3}) {
    const auto start = converted<Real>(lane_grid_with_oddities(4));
    const List<int> order = order_in_lanes(start);
    REQUIRE(order.size() == start.row_count());
    for (const int sweeps : {1, 2, 6}) {
      VelocityProblem<Real> wide = start, watched = start, plain = reordered(start, order);
      const SolverSettings settings = {.iterations = sweeps, .relaxation = relaxation};
      WideSequentialImpulse<Real> solver(settings, Momentum::nesterov);
      AcceleratedProjectedGaussSeidel<Real> accelerated(settings);
      solver.solve(wide);
      accelerated.solve(plain);
      CHECK(solver.restarts() == accelerated.restarts());
      // As in wide_sequential_impulse_tests.cpp, and twice as many passes.
      const Real tolerance =
          Real(16 * 20 * 2 * sweeps) * static_cast<Real>(std::numeric_limits<float>::epsilon());
      for (int k = 0; k < order.size(); ++k) {
        CHECK(std::abs(wide.impulse[order[k]] - plain.impulse[k]) <= tolerance);
      }
      CHECK(largest_gap(wide.velocity, plain.velocity) <= tolerance);
      OrderWatcher<Real> watcher;
      solver.solve(watched, &watcher);
      CHECK(watcher.outside == 0);
      CHECK(same_bits(wide, watched));
    }
  }
}

TEST_CASE("a sweep in lanes that went too far is undone to the last bit") {
  VelocityProblem<double> problem = hand_made_stack<double>(60, 10, 0.02);
  UndoneSweeps undone;
  WideSequentialImpulse<double> solver({.iterations = 200}, Momentum::nesterov);
  solver.solve(problem, &undone);
  CHECK(solver.restarts() > 0);
  CHECK(undone.count == solver.restarts());
}

TEST_CASE("momentum outlives the filling of lanes: a tall stack takes as many sweeps as accelerated PGS") {
  const VelocityProblem<double> start = hand_made_stack<double>(60, 10, 0.02);
  VelocityProblem<double> wide = start, watched = start, plain = reordered(start, order_in_lanes(start));
  const SolverSettings settings = {.iterations = 20000, .tolerance = 1e-11};
  WideSequentialImpulse<double> solver(settings, Momentum::nesterov);
  const SolveReport report = solver.solve(wide);
  const SolveReport expected = AcceleratedProjectedGaussSeidel<double>(settings).solve(plain);
  CHECK(report.converged);
  CHECK(residual(wide, residual_scale(start)).energy <= 1e-11);
  // R_E is looked at every 64th more sweeps, and roundings move the restarts by a few.
  CHECK(report.iterations <= 1.1 * expected.iterations);
  CHECK(WideSequentialImpulse<double>(settings).solve(watched).iterations > 5 * report.iterations);
}
