// Sequential impulses in lanes: the numbers of SequentialImpulse in the same order, whatever the registers.
#include <cairn/constraints/converted.hpp>
#include "lane_grid.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const Momentum both_momenta[] = {Momentum::none, Momentum::nesterov};

List<LaneSet> lane_sets_here() {
  List<LaneSet> sets;
  for (const LaneSet set : {LaneSet::baseline, LaneSet::avx2, LaneSet::avx512}) {
    if (has(set)) sets.push_back(set);
  }
  return sets;
}

}  // namespace

TEST_CASE_TEMPLATE("lanes sweep as sequential impulses do in the same order, to a rounding of a change", Real,
                   float, double) {
  for (const double relaxation : {1.0, 1.3}) {
    const auto start = converted<Real>(lane_grid_with_oddities(4));
    OrderWatcher<Real> watcher;
    VelocityProblem<Real> watched = start;
    WideSequentialImpulse<Real>({.iterations = 5, .relaxation = relaxation}).solve(watched, &watcher);
    REQUIRE(watcher.rows.size() == start.row_count());
    CHECK(watcher.outside == 0);

    for (const int sweeps : {1, 5}) {
      VelocityProblem<Real> wide = start, plain = reordered(start, watcher.rows);
      WideSequentialImpulse<Real>({.iterations = sweeps, .relaxation = relaxation}).solve(wide);
      SequentialImpulse<Real>({.iterations = sweeps, .relaxation = relaxation}).solve(plain);
      // A single sweep is not made in lanes' precision. Of more: impulses and velocities are a few units at
      // most; every update rounds about 20 times, and what it gets wrong goes on to its neighbours, of which
      // there are fewer than 16.
      const Real epsilon = static_cast<Real>(std::numeric_limits<float>::epsilon());
      const Real tolerance = sweeps == 1 ? Real(0) : Real(16 * 20 * sweeps) * epsilon;
      for (int k = 0; k < watcher.rows.size(); ++k) {
        CHECK(std::abs(wide.impulse[watcher.rows[k]] - plain.impulse[k]) <= tolerance);
      }
      CHECK(largest_gap(wide.velocity, plain.velocity) <= tolerance);
      if (sweeps == 5) CHECK(same_bits(wide, watched));
    }
  }
}

TEST_CASE_TEMPLATE("all instruction sets that this processor has give the same bits", Real, float, double) {
  const auto start = converted<Real>(lane_grid_with_oddities(4));
  for (const Momentum momentum : both_momenta) {
    for (const int sweeps : {1, 7, 400}) {
      VelocityProblem<Real> expected = start;
      WideSequentialImpulse<Real>({.iterations = sweeps}, momentum, LaneSet::baseline).solve(expected);
      for (const LaneSet set : lane_sets_here()) {
        VelocityProblem<Real> problem = start;
        WideSequentialImpulse<Real>({.iterations = sweeps}, momentum, set).solve(problem);
        CHECK(same_bits(problem, expected));
      }
    }
  }
}

TEST_CASE("an instruction set that the processor lacks is refused") {
  for (const LaneSet set : {LaneSet::avx2, LaneSet::avx512}) {
    if (!has(set))
      CHECK_THROWS_AS(WideSequentialImpulse<double>({}, Momentum::none, set), std::invalid_argument);
  }
  CHECK(has(LaneSet::baseline));
  CHECK(has(widest_lane_set()));
}

TEST_CASE_TEMPLATE("lanes in single precision lead to an answer in the problem's own", Real, float, double) {
  const auto start = converted<Real>(lane_grid(10, 2));
  const Real scale = residual_scale(start), epsilon = std::numeric_limits<Real>::epsilon();
  const SolverSettings settings = {.iterations = 20000, .tolerance = static_cast<double>(1000 * epsilon)};
  for (const Momentum momentum : both_momenta) {
    VelocityProblem<Real> problem = start, stopped = start;
    WideSequentialImpulse<Real>({.iterations = 20000}, momentum).solve(problem);
    CHECK(residual(problem, scale).energy <= 1000 * epsilon);  // as conformance_tests.cpp asks of all
    CHECK(WideSequentialImpulse<Real>(settings, momentum).solve(stopped).converged);
    CHECK(residual(stopped, scale).energy <= 1000 * epsilon);
  }
}

TEST_CASE("rows that fit into no lane come to the answer that sequential impulses come to") {
  VelocityProblem<double> start = lane_grid_with_oddities(2);
  for (ConstraintRow<double>& row : start.rows) row.bounds.friction /= 5;  // or sweeps go in circles
  VelocityProblem<double> wide = start, plain = start;
  const SolverSettings settings = {.iterations = 20000, .tolerance = 1e-11};
  CHECK(WideSequentialImpulse<double>(settings).solve(wide).converged);
  CHECK(SequentialImpulse<double>(settings).solve(plain).converged);
  CHECK(largest_gap(wide.velocity, plain.velocity) <= 1e-8);
}

TEST_CASE("a solver that knows other problems gives the bits of one that is new") {
  const List<VelocityProblem<double>> problems = {lane_grid(12, 4), lane_grid_with_oddities(4),
                                                  lane_grid(9, 1), lane_grid(12, 2), lane_grid(12, 4)};
  for (const Momentum momentum : both_momenta) {
    WideSequentialImpulse<double> one({.iterations = 6}, momentum);
    for (const VelocityProblem<double>& start : problems) {
      VelocityProblem<double> known = start, fresh = start;
      one.solve(known);
      WideSequentialImpulse<double>({.iterations = 6}, momentum).solve(fresh);
      CHECK(same_bits(known, fresh));
    }
  }
}

TEST_CASE("what a solver kept is made anew when a body is fixed, a row goes soft or turns around") {
  const VelocityProblem<double> start = lane_grid(8, 4);
  List<VelocityProblem<double>> changed(4, start);
  changed[0].inverse_mass[{12}].setZero();
  changed[1].rows[9].softness += 1;
  changed[2].rows[0].softness = 0.7;
  for (int i = 0; i < start.blocks[3].count; ++i) {
    ConstraintRow<double>& row = changed[3].rows[start.blocks[3].first + i];
    std::swap(row.a, row.b);
  }
  for (const VelocityProblem<double>& other : changed) {
    WideSequentialImpulse<double> one({.iterations = 6});
    VelocityProblem<double> before = start, known = other, fresh = other;
    one.solve(before);
    one.solve(known);
    WideSequentialImpulse<double>({.iterations = 6}).solve(fresh);
    CHECK(same_bits(known, fresh));
  }
}

TEST_CASE("springs too weak for a number of a lane give nothing, and nothing that is no number") {
  VelocityProblem<double> problem = lane_grid(8, 2);
  for (ConstraintRow<double>& row : problem.rows) row.softness = 1e300;
  problem.impulse.assign(problem.rows.size(), 0.0);
  const VelocityProblem<double> start = problem;
  WideSequentialImpulse<double>({.iterations = 5}).solve(problem);
  // (bias - j v) / softness: at most 1 + 6, for all of it is made of numbers below 1; over 1e30.
  const double most = 7e-30;
  for (const double impulse : problem.impulse) CHECK(std::abs(impulse) <= most);
  CHECK(largest_gap(problem.velocity, start.velocity) == 0);  // so little is lost in any velocity
}

TEST_CASE("velocities that are not numbers end no solve early, and blocks that leave rows out are refused") {
  VelocityProblem<double> problem = lane_grid(10, 2);
  problem.velocity[{33}].y() = std::numeric_limits<double>::quiet_NaN();
  const SolveReport report =
      WideSequentialImpulse<double>({.iterations = 50, .tolerance = 1e-6, .patience = 1}).solve(problem);
  CHECK(report.stop == Stop::sweeps);
  CHECK(report.iterations == 50);
  problem.blocks.pop_back();
  CHECK_THROWS_AS(WideSequentialImpulse<double>().solve(problem), std::invalid_argument);
}
