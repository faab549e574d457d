// The exact solver on problems with a known answer, and against every other way to solve a problem.
#include "validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double reference_fall = test_gravity * test_dt;  // [m/s] of one step

/// Solved by Lemke's method however small it is.
ReferenceSolver<double> by_lemke() { return ReferenceSolver<double>({.max_modes = 0}); }

}  // namespace

// A1
TEST_CASE_TEMPLATE("a stack of n boxes gets (n - j) m g dt at interface j", Real, float, double,
                   long double) {
  for (const int n : {1, 5, 12, 40}) {
    for (const int max_modes : {4096, 0}) {
      VelocityProblem<Real> problem = stack<Real>(n);
      const Real weight = -problem.velocity[{1}].y();
      ReferenceSolver<Real> solver({.max_modes = max_modes});
      const SolveReport report = solver.solve(problem);
      CHECK(report.converged);
      CHECK(report.stop == Stop::tolerance);
      const bool is_enumerated = n <= 12 && max_modes > 0;  // 2^12 modes
      CHECK(solver.report().method ==
            (is_enumerated ? ReferenceMethod::enumeration : ReferenceMethod::lemke));
      CHECK(solver.report().velocity.verdict == Uniqueness::unique);
      CHECK(solver.report().impulse.verdict == Uniqueness::unique);
      for (int j = 0; j < n; ++j) {
        const Real expected = static_cast<Real>(n - j) * weight;
        // One rounding to Real; A has a condition of n^2, which long double has room for.
        CHECK(std::abs(problem.impulse[j] - expected) <=
              std::max(std::numeric_limits<Real>::epsilon() * expected, Real(1e-15) * expected));
      }
    }
  }
}

// A2 in its limit
TEST_CASE("a heavy box on a light one is solved to 1e-12 for a mass ratio of 1e6, and tall stacks of both") {
  for (const double ratio : {1e3, 1e6}) {
    for (const List<double>& masses :
         {List<double>{1, ratio}, {1, 1, 1, 1, ratio}, {1, ratio, 1, ratio, 1, ratio}}) {
      for (const int max_modes : {4096, 0}) {
        VelocityProblem<double> problem = column<double>(masses);
        ReferenceSolver<double> solver({.max_modes = max_modes});
        CHECK(solver.solve(problem).converged);
        double above = 0;
        for (int j = masses.size(); j-- > 0;) {
          above += masses[j];
          // 1e-12 where there is one heavy box; else A has a condition of about n^2 ratio.
          const double n = static_cast<double>(masses.size());
          const double tolerance = std::max(1e-12, n * n * ratio * 1.1e-19);
          CHECK(problem.impulse[j] == doctest::Approx(above * reference_fall).epsilon(tolerance));
        }
      }
    }
  }
}

// A9
TEST_CASE("a box on three points: one velocity, by convexity, and many impulses, by rank") {
  VelocityProblem<double> problem = box_on_feet<double>({-0.5, 0, 0.5}, {0, -reference_fall, 0});
  ReferenceSolver<double> solver = by_lemke();
  CHECK(solver.solve(problem).converged);
  CHECK(problem.velocity[{1}].cwiseAbs().maxCoeff() <= 4 * double_epsilon);
  CHECK(solver.report().velocity.verdict == Uniqueness::unique);
  CHECK(solver.report().velocity.evidence == Evidence::convexity);
  CHECK(solver.report().impulse.verdict == Uniqueness::not_unique);
  CHECK(solver.report().impulse.evidence == Evidence::rank);
}

// A17: (sum r_i) g / (sum r_i^2 / m_i)
TEST_CASE("a rope over three bodies is one row with further terms: its impulse is 12 dt for r = 1, 2, 1") {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId a = add_body<double>(problem, 1, 1, {0, -reference_fall, 0});
  const BodyId b = add_body<double>(problem, 2, 1, {0, -reference_fall, 0});
  const BodyId c = add_body<double>(problem, 3, 1, {0, -reference_fall, 0});
  ConstraintRow<double> rope = vertical_row<double>(a, b, Bounds<double>::equality());
  rope.jacobian_a.y() = 1;
  rope.jacobian_b.y() = 2;
  problem.extra_terms.push_back({c, {0, 1, 0}});
  rope.extra_count = 1;
  add_row(problem, rope);
  ReferenceSolver<double> solver;
  CHECK(solver.solve(problem).converged);
  CHECK(problem.impulse[0] == doctest::Approx(12 * test_dt).epsilon(4 * double_epsilon));
  CHECK(solver.report().impulse.verdict == Uniqueness::unique);
}

TEST_CASE("soft rows, motors at their limit and limits on one side have the answer of one row alone") {
  for (const int max_modes : {4096, 0}) {
    ReferenceSolver<double> solver({.max_modes = max_modes});
    VelocityProblem<double> problem = empty_problem<double>();
    const auto row_on_new_body = [&](const Bounds<double>& bounds, double bias, double softness) {
      const BodyId body = add_body<double>(problem, 2, 1, {0, 0, 0});
      ConstraintRow<double> row = floor_row<double>(body, 0);
      row.bounds = bounds;
      row.bias = bias;
      row.softness = softness;
      add_row(problem, row);
    };
    row_on_new_body(Bounds<double>::unilateral(), 3, 1.5);  // 3 / (1/2 + 1.5)
    row_on_new_body(Bounds<double>::equality(), -3, 1.5);
    row_on_new_body(Bounds<double>::at_most(0.25), 3, 0);    // would need 6
    row_on_new_body(Bounds<double>::at_most(0.25), -3, 0);   // at the other end
    row_on_new_body(Bounds<double>::at_most(0.25), 0.1, 0);  // 0.2: inside
    row_on_new_body({.lower = 0.5, .upper = 7}, 0.1, 0);     // 0.5 at least
    row_on_new_body({.lower = -7, .upper = 0}, -3, 0);       // pulls only: -6
    row_on_new_body({.upper = -0.5}, 0.1, 0);                // no lower bound
    row_on_new_body(Bounds<double>::at_most(0), 3, 0);       // may do nothing
    const PerRow<double> expected = {1.5, -1.5, 0.25, -0.25, 0.2, 0.5, -6, -0.5, 0};
    CHECK(solver.solve(problem).converged);
    for (int i = 0; i < expected.size(); ++i) {
      CHECK(problem.impulse[i] == doctest::Approx(expected[i]).epsilon(4 * double_epsilon));
    }
    CHECK(solver.report().velocity.verdict == Uniqueness::unique);
    CHECK(solver.report().impulse.verdict == Uniqueness::unique);
  }
}

TEST_CASE("one row of friction for two contacts slides at mu times their sum") {
  for (const int max_modes : {4096, 0}) {
    VelocityProblem<double> problem = empty_problem<double>();
    const BodyId body = add_body<double>(problem, 1, 1.0 / 6, {5, -reference_fall, 0});
    const int left = add_row(problem, floor_row<double>(body, -0.5));
    const int right = add_row(problem, floor_row<double>(body, 0.5));
    ConstraintRow<double> friction = floor_friction_row<double>(body, 0, 0.4, left);
    friction.bounds = Bounds<double>::coulomb(0.4, left, right);
    add_row(problem, friction);
    ReferenceSolver<double> solver({.max_modes = max_modes});
    CHECK(solver.solve(problem).converged);
    CHECK(problem.impulse[2] == doctest::Approx(-0.4 * reference_fall).epsilon(1e-14));
    CHECK(problem.velocity[{1}].x() == doctest::Approx(5 - 0.4 * reference_fall).epsilon(1e-14));
  }
}

TEST_CASE("equalities that repeat each other are solved, and those that contradict each other are reported") {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId body = add_body<double>(problem, 1, 1, {0, -reference_fall, 0});
  for (int copy = 0; copy < 3; ++copy) {
    add_row(problem, vertical_row<double>(ground, body, Bounds<double>::equality()));
  }
  VelocityProblem<double> repeated = problem;
  ReferenceSolver<double> solver;
  CHECK(solver.solve(repeated).converged);
  CHECK(std::abs(repeated.velocity[{1}].y()) <= double_epsilon * reference_fall);
  CHECK(solver.report().redundant_equalities);
  CHECK_FALSE(solver.report().contradictory_equalities);
  CHECK(solver.report().impulse.verdict == Uniqueness::not_unique);

  for (int i = 0; i < 3; ++i) problem.rows[i].bias = i;
  const SolveReport report = solver.solve(problem);
  CHECK_FALSE(report.converged);
  CHECK(solver.report().contradictory_equalities);
  CHECK(solver.report().residual > 0.1);
  CHECK(problem.velocity[{1}].y() == doctest::Approx(1).epsilon(1e-14));  // the mean of 0, 1 and 2
}

// A10
TEST_CASE("rows between immovable bodies are left out, with the friction that hangs on them") {
  VelocityProblem<double> problem = stack<double>(2);
  const int idle = add_row(problem, vertical_row<double>(ground, ground, Bounds<double>::unilateral()));
  add_row(problem, floor_friction_row<double>({1}, 0.5, 0.5, idle));
  ReferenceSolver<double> solver;
  CHECK(solver.solve(problem).converged);
  CHECK(problem.impulse[0] == doctest::Approx(2 * reference_fall).epsilon(1e-14));
  CHECK(problem.impulse[2] == 0);
  CHECK(problem.impulse[3] == 0);
}

TEST_CASE("the reference solver refuses settings and rows that it has no meaning for") {
  CHECK_THROWS_AS(ReferenceSolver<double>({.max_modes = -1}), std::invalid_argument);
  CHECK_THROWS_AS(ReferenceSolver<double>({.max_rows = -1}), std::invalid_argument);
  CHECK_THROWS_AS(ReferenceSolver<double>({.newton_rows = -1}), std::invalid_argument);
  CHECK_THROWS_AS(ReferenceSolver<double>({.other_covers = -1}), std::invalid_argument);
  CHECK_THROWS_AS(ReferenceSolver<double>({.tolerance = 0}), std::invalid_argument);
  VelocityProblem<double> problem = stack<double>(1);
  problem.rows[0].bounds = Bounds<double>::equality();  // may pull
  add_row(problem, floor_friction_row<double>({1}, 0.5, 0.5, 0));
  CHECK_THROWS_AS(ReferenceSolver<double>().solve(problem), std::invalid_argument);
}

// A10: each box may fall by g dt, or be held by walls that press it with g dt / (2 mu) or more.
TEST_CASE("boxes in tight slots, beyond what is enumerated, have two answers: Lemke's and Newton's way") {
  for (const int newton_rows : {150, 0}) {
    CAPTURE(newton_rows);
    VelocityProblem<double> problem = empty_problem<double>();
    for (int slot = 0; slot < 4; ++slot) {
      const BodyId body = add_body<double>(problem, 1, 1.0 / 6, {0, -reference_fall, 0});
      for (const double side : {1.0, -1.0}) {
        ConstraintRow<double> row = floor_row<double>(body, 0);
        row.jacobian_b = {side, 0, 0};
        const int wall = add_row(problem, row);
        row.jacobian_b = {0, 1, -side / 2};
        row.bounds = Bounds<double>::coulomb(0.5, wall);
        add_row(problem, row);
      }
    }
    ReferenceSolver<double> solver({.max_modes = 0, .newton_rows = newton_rows, .other_covers = 8});
    CHECK(solver.solve(problem).converged);
    CHECK(solver.report().method == (newton_rows > 0 ? ReferenceMethod::lemke : ReferenceMethod::newton));
    CHECK(solver.report().velocity.verdict == Uniqueness::not_unique);
    CHECK(solver.report().velocity.evidence == Evidence::two_answers);
    CHECK(solver.report().impulse.verdict == Uniqueness::not_unique);
    CHECK(solver.report().solutions >= 2);
  }
}
