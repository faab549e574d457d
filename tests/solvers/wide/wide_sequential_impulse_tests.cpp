// Sequential impulses in lanes: the numbers of SequentialImpulse in the same order, whatever the registers.
#include "solvers/wide/wide_sequential_impulse.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "math/list.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "solvers/residual.hpp"

using namespace cairn;

namespace {

/// Numbers from -1 to 1.
class LaneNumbers {
 public:
  double next() { return static_cast<double>(random_() % 2001) / 1000 - 1; }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 random_{11};
};

/// Bodies in a grid; each is held to the next and to the one above by a block of rows, in turn a manifold of
/// two points, a pin, a weld with a spring, and a manifold whose friction is one row.
struct LaneGrid {
  VelocityProblem<double> problem = {};
  LaneNumbers numbers = {};

  void add_row(int a, int b, const Bounds<double>& bounds, double softness) {
    ConstraintRow<double> row;
    row.a = {a};
    row.b = {b};
    row.jacobian_a = {numbers.next(), numbers.next(), numbers.next()};
    row.jacobian_b = {numbers.next(), numbers.next(), numbers.next()};
    row.bias = numbers.next();
    row.softness = softness;
    row.bounds = bounds;
    problem.rows.push_back(row);
    problem.impulse.push_back(bounds.is_unilateral() ? 0.1 : 0);
  }
  void add_block(int a, int b, int kind) {
    const int first = problem.row_count();
    const auto normal = Bounds<double>::unilateral();
    if (kind == 0) {
      for (int point = 0; point < 2; ++point) {
        add_row(a, b, normal, 0);
        add_row(a, b, Bounds<double>::coulomb(0.5, first + 2 * point), 0);
      }
    } else if (kind == 1) {
      for (int row = 0; row < 2; ++row) add_row(a, b, Bounds<double>::equality(), 0.3);
    } else if (kind == 2) {
      add_row(a, b, Bounds<double>::at_most(0.2), 0);
      for (int row = 0; row < 3; ++row) add_row(a, b, Bounds<double>::equality(), row == 2 ? 2 : 0.3);
    } else {
      for (int point = 0; point < 2; ++point) add_row(a, b, normal, 0.3);
      add_row(a, b, Bounds<double>::coulomb(0.5, first, first + 1), 0);
    }
    problem.blocks.push_back({first, problem.row_count() - first});
  }
};

/// Every fifth body cannot move.
VelocityProblem<double> lane_grid(int side, int kinds) {
  LaneGrid grid;
  for (int body = 0; body < side * side; ++body) {
    grid.problem.velocity.push_back({grid.numbers.next(), grid.numbers.next(), grid.numbers.next()});
    const Vec3<double> mass(1.5 + grid.numbers.next(), 1.5, 1.5 + grid.numbers.next());
    grid.problem.inverse_mass.push_back(body % 5 == 0 ? Vec3<double>(0, 0, 0) : mass);
  }
  for (int body = 0; body < side * side; ++body) {
    if (body % side != side - 1) grid.add_block(body, body + 1, grid.numbers.below(kinds));
    if (body + side < side * side) grid.add_block(body, body + side, grid.numbers.below(kinds));
  }
  return grid.problem;
}

/// The same with rows that fit into no lane: of three bodies, on a disc, and friction on another block's row.
VelocityProblem<double> lane_grid_with_oddities(int kinds) {
  LaneGrid grid = {.problem = lane_grid(12, kinds)};
  const int first = grid.problem.row_count();
  grid.add_row(1, 50, Bounds<double>::equality(), 0.5);
  grid.problem.extra_terms = {{{77}, {0.3, -0.8, 0.1}}};
  grid.problem.rows[first].extra_count = 1;
  grid.add_row(3, 4, Bounds<double>::at_most(0.3), 0);
  grid.add_row(3, 4, Bounds<double>::rest_of_disc(0.3, first + 1), 0);
  grid.problem.blocks.push_back({first, 1});
  grid.problem.blocks.push_back({first + 1, 2});
  for (int i = 0; i < 2; ++i) {
    grid.add_row(6, 7, i == 0 ? Bounds<double>::unilateral() : Bounds<double>::coulomb(0.4, first + 3), 0);
    grid.problem.blocks.push_back({first + 3 + i, 1});
  }
  return grid.problem;
}

template <Scalar Real>
bool same_bits(const VelocityProblem<Real>& one, const VelocityProblem<Real>& other) {
  bool same = one.impulse == other.impulse;
  for (const BodyId body : one.velocity.indices()) same = same && one.velocity[body] == other.velocity[body];
  return same;
}

template <Scalar Real>
Real largest_lane_gap(const VelocityProblem<Real>& one, const VelocityProblem<Real>& other) {
  Real largest = 0;
  for (const BodyId body : one.velocity.indices()) {
    largest = std::max(largest, (one.velocity[body] - other.velocity[body]).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The rows in the order in which a sweep updates them.
template <Scalar Real>
class OrderWatcher final : public SolveObserver<Real> {
 public:
  bool watches_rows() const override { return true; }
  void after_row(const RowUpdate<Real>& update, const VelocityProblem<Real>& problem) override {
    const ConstraintRow<Real>& row = problem.rows[update.row];
    if (update.sweep == 1) rows.push_back(update.row);
    outside += row.bounds.clamp(update.impulse_after, problem.impulse) != update.impulse_after;
    outside += problem.impulse[update.row] != update.impulse_after;
  }
  List<int> rows;
  int outside = 0;
};

template <Scalar Real>
VelocityProblem<Real> reordered(const VelocityProblem<Real>& problem, const List<int>& order) {
  VelocityProblem<Real> result = problem;
  List<int> place(order.size());
  for (int k = 0; k < order.size(); ++k) place[order[k]] = k;
  for (int k = 0; k < order.size(); ++k) {
    ConstraintRow<Real> row = problem.rows[order[k]];
    Bounds<Real>& bounds = row.bounds;
    if (bounds.normal_row >= 0) bounds.normal_row = place[bounds.normal_row];
    if (bounds.second_normal_row >= 0) bounds.second_normal_row = place[bounds.second_normal_row];
    result.rows[k] = row;
    result.impulse[k] = problem.impulse[order[k]];
  }
  return result;
}

List<LaneSet> lane_sets_here() {
  List<LaneSet> sets;
  for (const LaneSet set : {LaneSet::baseline, LaneSet::avx2, LaneSet::avx512}) {
    if (has(set)) sets.push_back(set);
  }
  return sets;
}

}  // namespace

TEST_CASE_TEMPLATE("lanes sweep as sequential impulses do in the same order, to a rounding of a change", Real,
                   float, double, long double) {
  using Number = typename LaneSystem<Real>::Number;
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
      // Impulses and velocities are a few units at most; every update rounds about 20 times, and what it gets
      // wrong goes on to its neighbours, of which there are fewer than 16.
      const Real tolerance =
          Real(16 * 20 * sweeps) * static_cast<Real>(std::numeric_limits<Number>::epsilon());
      for (int k = 0; k < watcher.rows.size(); ++k) {
        CHECK(std::abs(wide.impulse[watcher.rows[k]] - plain.impulse[k]) <= tolerance);
      }
      CHECK(largest_lane_gap(wide, plain) <= tolerance);
      if (sweeps == 5) CHECK(same_bits(wide, watched));
    }
  }
}

TEST_CASE_TEMPLATE("all instruction sets that this processor has give the same bits", Real, float, double,
                   long double) {
  const auto start = converted<Real>(lane_grid_with_oddities(4));
  for (const int sweeps : {1, 7, 400}) {
    VelocityProblem<Real> expected = start;
    WideSequentialImpulse<Real>({.iterations = sweeps}, LaneSet::baseline).solve(expected);
    for (const LaneSet set : lane_sets_here()) {
      VelocityProblem<Real> problem = start;
      WideSequentialImpulse<Real>({.iterations = sweeps}, set).solve(problem);
      CHECK(same_bits(problem, expected));
    }
  }
}

TEST_CASE("an instruction set that the processor lacks is refused") {
  for (const LaneSet set : {LaneSet::avx2, LaneSet::avx512}) {
    if (!has(set)) CHECK_THROWS_AS(WideSequentialImpulse<double>({}, set), std::invalid_argument);
  }
  CHECK(has(LaneSet::baseline));
  CHECK(has(widest_lane_set()));
}

TEST_CASE_TEMPLATE("lanes in single precision lead to an answer in the problem's own", Real, float, double,
                   long double) {
  const auto start = converted<Real>(lane_grid(10, 2));
  const Real scale = residual_scale(start), epsilon = std::numeric_limits<Real>::epsilon();
  VelocityProblem<Real> problem = start;
  WideSequentialImpulse<Real>({.iterations = 20000}).solve(problem);
  CHECK(residual(problem, scale).energy <= 1000 * epsilon);  // as conformance_tests.cpp asks of all
  VelocityProblem<Real> stopped = start;
  const SolveReport report =
      WideSequentialImpulse<Real>({.iterations = 20000, .tolerance = static_cast<double>(1000 * epsilon)})
          .solve(stopped);
  CHECK(report.converged);
  CHECK(residual(stopped, scale).energy <= 1000 * epsilon);
}

TEST_CASE("rows that fit into no lane come to the answer that sequential impulses come to") {
  VelocityProblem<double> start = lane_grid_with_oddities(2);
  for (ConstraintRow<double>& row : start.rows) row.bounds.friction /= 5;  // or sweeps go in circles
  VelocityProblem<double> wide = start, plain = start;
  const SolverSettings settings = {.iterations = 20000, .tolerance = 1e-11};
  CHECK(WideSequentialImpulse<double>(settings).solve(wide).converged);
  CHECK(SequentialImpulse<double>(settings).solve(plain).converged);
  CHECK(largest_lane_gap(wide, plain) <= 1e-8);
}

TEST_CASE("a solver that knows other problems gives the bits of one that is new") {
  const List<VelocityProblem<double>> problems = {lane_grid(12, 4), lane_grid_with_oddities(4),
                                                  lane_grid(9, 1), lane_grid(12, 2), lane_grid(12, 4)};
  WideSequentialImpulse<double> one({.iterations = 6});
  for (const VelocityProblem<double>& start : problems) {
    VelocityProblem<double> known = start, fresh = start;
    one.solve(known);
    WideSequentialImpulse<double>({.iterations = 6}).solve(fresh);
    CHECK(same_bits(known, fresh));
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
