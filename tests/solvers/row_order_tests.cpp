// In which order rows are visited, and what that changes.
#include <map>
#include <set>

#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr RowOrder every_row_order[] = {RowOrder::as_written, RowOrder::reverse, RowOrder::alternating,
                                        RowOrder::shuffled, RowOrder::coloured};

List<int> rows_of_sweep(const VelocityProblem<double>& problem, RowOrder order, std::uint64_t seed,
                        int sweep) {
  RowSequence sequence;
  for (int number = 1; number <= sweep; ++number) order_rows(problem, order, seed, number, sequence);
  return sequence.rows;
}

/// A body in the middle, tied to `arms` others, each of which stands on the ground.
VelocityProblem<double> star_of_bodies(int arms) {
  VelocityProblem<double> problem = hand_made_stack<double>(arms + 1, 10, 0.02);
  for (int arm = 0; arm < arms; ++arm) problem.rows[arm].a = ground;
  problem.rows.pop_back();
  for (int arm = 0; arm < arms; ++arm) {
    ConstraintRow<double> row = problem.rows.front();
    row.a = {arm + 1};
    row.b = {arms + 1};
    problem.rows.push_back(row);
  }
  problem.impulse.assign(problem.rows.size(), 0);
  return problem;
}

}  // namespace

TEST_CASE("rows can be visited as written, backwards, or up and down in turn") {
  const VelocityProblem<double> problem = hand_made_stack<double>(4, 10, 0.02);
  const List<int> up = {0, 1, 2, 3}, down = {3, 2, 1, 0};
  for (const int sweep : {1, 2, 3, 4}) {
    CHECK(rows_of_sweep(problem, RowOrder::as_written, 1, sweep) == up);
    CHECK(rows_of_sweep(problem, RowOrder::reverse, 1, sweep) == down);
    CHECK(rows_of_sweep(problem, RowOrder::alternating, 1, sweep) == (sweep % 2 == 1 ? up : down));
  }
}

TEST_CASE("in every order a sweep visits every row once, and no sweep but the first allocates") {
  const VelocityProblem<double> problem = star_of_bodies(7);
  for (const RowOrder order : every_row_order) {
    RowSequence sequence;
    order_rows(problem, order, 1, 1, sequence);
    const int* const memory = sequence.rows.data();
    const int* const scratch = sequence.waiting.data();
    for (int sweep = 2; sweep <= 20; ++sweep) {
      order_rows(problem, order, 1, sweep, sequence);
      const std::set<int> visited(sequence.rows.begin(), sequence.rows.end());
      CHECK(sequence.rows.size() == problem.rows.size());
      CHECK(visited.size() == problem.rows.size());
      CHECK(*visited.begin() == 0);
      CHECK(*visited.rbegin() == problem.row_count() - 1);
      CHECK(sequence.rows.data() == memory);
      CHECK(sequence.waiting.data() == scratch);
    }
  }
}

TEST_CASE("one seed shuffles in one way; every sweep and every seed shuffles in its own") {
  const VelocityProblem<double> problem = hand_made_stack<double>(20, 10, 0.02);
  std::set<std::vector<int>> orders;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (const int sweep : {1, 2, 3, 4}) {
      const List<int> rows = rows_of_sweep(problem, RowOrder::shuffled, seed, sweep);
      CHECK(rows == rows_of_sweep(problem, RowOrder::shuffled, seed, sweep));
      orders.insert(rows.as_vector());
    }
  }
  CHECK(orders.size() == 16);  // of 20! = 2.4e18: two alike would be no accident
}

TEST_CASE("shuffling makes every order equally likely") {
  const VelocityProblem<double> problem = hand_made_stack<double>(3, 10, 0.02);
  std::map<std::vector<int>, int> count;
  RowSequence sequence;
  const int sweeps = 6000;
  for (int sweep = 1; sweep <= sweeps; ++sweep) {
    order_rows(problem, RowOrder::shuffled, 1, sweep, sequence);
    count[sequence.rows.as_vector()] += 1;
  }
  CHECK(count.size() == 6);
  // A binomial count scatters by sqrt(6000 * 1/6 * 5/6) = 29: within five of those.
  for (const auto& [rows, times] : count) CHECK(std::abs(times - sweeps / 6) <= 5 * 29);
}

TEST_CASE("a stack needs two colours: the ground couples nothing, and odd rows do not touch even ones") {
  const VelocityProblem<double> problem = hand_made_stack<double>(5, 10, 0.02);
  RowSequence sequence;
  order_rows(problem, RowOrder::coloured, 1, 1, sequence);
  CHECK(sequence.rows == List<int>{0, 2, 4, 1, 3});
  CHECK(sequence.colours == List<int>{0, 3, 5});
}

TEST_CASE("boxes side by side need one colour, whichever body of their rows is the ground") {
  VelocityProblem<double> problem = hand_made_stack<double>(4, 10, 0.02);
  for (int i = 0; i < 4; ++i) {
    ConstraintRow<double>& row = problem.rows[i];
    row.a = i % 2 == 0 ? ground : BodyId{i + 1};
    row.b = i % 2 == 0 ? BodyId{i + 1} : ground;
  }
  RowSequence sequence;
  order_rows(problem, RowOrder::coloured, 1, 1, sequence);
  CHECK(sequence.rows == List<int>{0, 1, 2, 3});
  CHECK(sequence.colours == List<int>{0, 4});
}

TEST_CASE(
    "rows of one colour share no body that can move, and there are fewer than twice as many colours as "
    "rows at the busiest body") {
  for (const int arms : {1, 2, 5, 30}) {
    const VelocityProblem<double> problem = star_of_bodies(arms);
    RowSequence sequence;
    order_rows(problem, RowOrder::coloured, 1, 1, sequence);
    const int colours = sequence.colours.size() - 1;
    CHECK(colours >= arms);
    CHECK(colours <= 2 * std::max(arms, 2) - 1);
    CHECK(sequence.colours.back() == problem.row_count());
    for (int colour = 0; colour < colours; ++colour) {
      std::set<BodyId> bodies;
      for (int turn = sequence.colours[colour]; turn < sequence.colours[colour + 1]; ++turn) {
        const ConstraintRow<double>& row = problem.rows[sequence.rows[turn]];
        for (const BodyId body : {row.a, row.b}) {
          if (body != ground) CHECK(bodies.insert(body).second);
        }
      }
    }
  }
}

TEST_CASE("a solver visits the rows in the order of its settings") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const RowOrder order : every_row_order) {
      VelocityProblem<double> problem = star_of_bodies(3);
      List<int> expected;
      for (int sweep = 1; sweep <= 5; ++sweep) {
        const List<int> rows = rows_of_sweep(problem, order, 9, sweep);
        expected.insert(expected.end(), rows.begin(), rows.end());
      }
      RowWatcher<double> watcher;
      make({.iterations = 5, .order = order, .seed = 9})->solve(problem, &watcher);
      CHECK(watcher.rows == expected);
    }
  }
}

TEST_CASE("the row that is solved last is the one that is satisfied") {
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const RowOrder order : every_row_order) {
      VelocityProblem<double> problem = hand_made_stack<double>(6, 10, 0.02);
      for (ConstraintRow<double>& row : problem.rows) row.bounds = Bounds<double>::equality();
      const int last = rows_of_sweep(problem, order, 1, 3).back();
      make({.iterations = 3, .order = order})->solve(problem);
      const ConstraintRow<double>& row = problem.rows[last];
      CHECK(std::abs(row_velocity(problem, row)) <= 64 * std::numeric_limits<double>::epsilon());
    }
  }
}

TEST_CASE_TEMPLATE(
    "in every order a stack settles on the weight above each box, and PGS and SI agree on the "
    "way there",
    Real, float, double, long double) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  const Real weight = Real(10) * Real(0.02);
  for (const RowOrder order : every_row_order) {
    for (const int sweeps : {1, 2, 3, 10, 3000}) {
      VelocityProblem<Real> by_si = hand_made_stack<Real>(5, 10, Real(0.02));
      VelocityProblem<Real> by_pgs = by_si;
      SequentialImpulse<Real>({.iterations = sweeps, .order = order}).solve(by_si);
      ProjectedGaussSeidel<Real>({.iterations = sweeps, .order = order}).solve(by_pgs);
      for (int i = 0; i < 5; ++i) {
        // The same numbers but for rounding, which piles up over sweeps until the slowest error (cos^2(pi/10)
        // = 0.905 a sweep for five boxes) has shrunk: 11 sweeps' worth.
        const Real allowed = 64 * epsilon * Real(std::min(1 + sweeps, 12)) * 5 * weight;
        CHECK(std::abs(by_si.impulse[i] - by_pgs.impulse[i]) <= allowed);
        if (sweeps == 3000) CHECK(std::abs(by_si.impulse[i] - Real(5 - i) * weight) <= allowed);
      }
    }
  }
}
