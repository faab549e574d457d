// One solver on one problem: errors by formula, work counted, cycles and plateaus told apart.
#include <cairn/study/solve_trial.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <cairn/solvers/exact/reference_solver.hpp>
#include <cairn/validation/case_problems.hpp>

using namespace cairn;

namespace {

constexpr SolveTiming untimed{.repetitions = 0, .seconds = 0};

/// Two boxes of 1 and M kg on each other, normals only, `fall` m/s into the ground: row 0 from the ground,
/// row 1 between them. A = [[1, -1], [-1, 1 + 1/M]] (1/kg), w = A lambda + v_free rows (-fall, 0).
VelocityProblem<double> two_boxes(double heavy, double fall) {
  VelocityProblem<double> problem = cases::column<double>({1, heavy});
  for (const BodyId box : {BodyId{1}, BodyId{2}}) problem.velocity[box] = {0, -fall, 0};
  return problem;
}

/// One row twice, which asks for 1 m/s and for -1 m/s at once: no velocity is both.
VelocityProblem<double> contradiction() {
  VelocityProblem<double> problem = two_boxes(1, 1);
  ConstraintRow<double> row = problem.rows[0];
  row.bounds = {};
  row.bias = 1;
  ConstraintRow<double> against = row;
  against.bias = -1;
  against.key.part = 7;
  problem.rows = {row, against};
  return problem;
}

}  // namespace

TEST_CASE("the residual of two boxes after k sweeps is the formula's, and every sweep costs both rows") {
  // With q = M / (1 + M) and p = fall: lambda_2^(k) = M p (1 - q^k), lambda_1^(k) = p + lambda_2^(k-1).
  // After row 2 its own e is 0; e_1 = lambda_2^(k) - lambda_2^(k-1) = M p q^(k-1) (1 - q) = p q^k.
  // With A_11 = 1 and at impulse 0, e = (p, 0): R_E = q^k.
  for (const double heavy : {1.0, 4.0, 100.0}) {
    const double q = heavy / (1 + heavy);
    for (const int k : {1, 2, 5, 33}) {
      const SolveOutcome outcome =
          try_solver(two_boxes(heavy, 0.3), {.solver = "si", .sweeps = k}, {}, untimed);
      CAPTURE(heavy);
      CAPTURE(k);
      CHECK(outcome.status == "ok");
      // Each sweep rounds numbers of size M p, of which e is a difference: 8 roundings of each.
      const double rounding = 8 * k * heavy * std::numeric_limits<double>::epsilon();
      CHECK(std::abs(outcome.error.returned.energy - std::pow(q, k)) <= rounding);
      CHECK(std::abs(outcome.error.from_impulses.energy - std::pow(q, k)) <= rounding);
      CHECK(outcome.row_updates == 2 * k);
      CHECK_FALSE(outcome.error.velocity);  // no truth was given
    }
  }
}

TEST_CASE("E_M of two boxes after k sweeps is the formula's") {
  // The truth is rest. v_1 = -p + lambda_1 - lambda_2 = -p q^k by the above, v_2 = -p + lambda_2 / M = -p
  // q^k: all velocities shrink alike, so that E_M = q^k.
  const double heavy = 4, q = heavy / (1 + heavy);
  const PerBody<Vec3<double>> rest(3, Vec3<double>::Zero());
  for (const int k : {1, 3, 20}) {
    const SolveOutcome outcome =
        try_solver(two_boxes(heavy, 0.3), {.solver = "si", .sweeps = k}, rest, untimed);
    REQUIRE(outcome.error.velocity);
    CHECK(std::abs(*outcome.error.velocity - std::pow(q, k)) <= 8 * k * heavy * 2.3e-16);  // as above
  }
}

TEST_CASE("a cold start forgets the impulses of the problem, a warm one begins with them") {
  VelocityProblem<double> solved = two_boxes(4, 0.3);
  solved.impulse = {5 * 0.3, 4 * 0.3};  // the answer: each carries what is above it
  const SolveOutcome warm =
      try_solver(solved, {.solver = "si", .sweeps = 1, .start = Start::warm}, {}, untimed);
  const SolveOutcome cold =
      try_solver(solved, {.solver = "si", .sweeps = 1, .start = Start::cold}, {}, untimed);
  CHECK(warm.error.returned.energy <= 16 * 4 * 2.3e-16);                     // roundings of M p over p
  CHECK(cold.error.returned.energy == doctest::Approx(0.8).epsilon(1e-14));  // q^1
}

TEST_CASE(
    "sweeps over the rod of Painleve go in a cycle from the friction 4/3 on, and below it they arrive") {
  for (const std::string solver : {"si", "pgs", "pgs-sparse"}) {
    for (const auto scalar : {Precision::single_precision, Precision::double_precision}) {
      CAPTURE(solver);
      const auto status = [&](double friction, int sweeps) {
        return try_solver(cases::painleve_rod<double>(-1, friction), {solver, sweeps, scalar, Start::cold},
                          {}, untimed);
      };
      const SolveOutcome jammed = status(1.4, 256);
      CHECK(jammed.status == "cycle");
      CHECK(jammed.row_updates == 512);            // looking for the cycle does not cut the solve short
      CHECK(jammed.error.returned.energy >= 0.1);  // it is no circle of roundings round the answer
      // A sweep multiplies the error by mu A_nt / A_nn = 0.75 mu: 0.9 at mu = 1.2, 2e-12 after 256;
      // float has 1e-7 of the impulse, ten times that with this rate.
      CHECK(status(1.2, 256).error.returned.energy <= 1e-5);
      CHECK(status(1.2, 16).status == "ok");
    }
  }
}

TEST_CASE("rows that contradict each other end on a plateau, once there are sweeps enough to see it") {
  // The second row has the last word, so that v = -1 and the first misses 2 m/s: as much as at the start,
  // where the second happens to be right. R_E = 1, after every sweep; 64 roundings of impulses up to 2 *
  // 4096.
  for (const std::string solver : {"si", "pgs", "block"}) {
    const SolveOutcome early = try_solver(contradiction(), {.solver = solver, .sweeps = 64}, {}, untimed);
    const SolveOutcome late = try_solver(contradiction(), {.solver = solver, .sweeps = 4096}, {}, untimed);
    CAPTURE(solver);
    CHECK(early.status == "ok");
    CHECK(late.status == "plateau");
    CHECK(late.row_updates == 2 * 4096);
    for (const SolveOutcome& outcome : {early, late}) {
      CHECK(std::abs(outcome.error.returned.energy - 1) <= 64 * 2 * 4096 * 2.3e-16);
    }
  }
}

TEST_CASE("a stack that converges is neither a cycle nor a plateau while it is on its way") {
  // q^k = 0.99^256 = 0.08: a hundred times above rounding.
  CHECK(try_solver(two_boxes(100, 0.3), {.solver = "si", .sweeps = 256}, {}, untimed).status == "ok");
}

TEST_CASE("velocities that are no numbers are a status, and so is a solver that refuses") {
  VelocityProblem<double> endless = two_boxes(1, 0.3);
  endless.velocity[{2}].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(try_solver(endless, {.solver = "si", .sweeps = 4}, {}, untimed).status == "nan");

  VelocityProblem<double> crowd = two_boxes(1, 0.3);
  crowd.rows.assign(5001, crowd.rows[0]);
  crowd.impulse.assign(crowd.rows.size(), 0);
  crowd.blocks.clear();
  for (int i = 0; i < crowd.row_count(); ++i) crowd.blocks.push_back({i, 1});
  const SolveOutcome refused = try_solver(crowd, {.solver = "pgs", .sweeps = 1}, {}, untimed);
  CHECK(refused.status == "refused");
  CHECK_FALSE(refused.reason.empty());
  CHECK(refused.row_updates == 0);
}

TEST_CASE("the same solve has the same hash, timed or not, and times are in order") {
  const SolveChoice choice{.solver = "si", .sweeps = 8};
  const SolveOutcome plain = try_solver(two_boxes(4, 0.3), choice, {}, untimed);
  const SolveOutcome timed = try_solver(two_boxes(4, 0.3), choice, {}, {.repetitions = 5, .seconds = 0});
  CHECK(plain.state_hash == timed.state_hash);
  CHECK(plain.state_hash != try_solver(two_boxes(4, 0.4), choice, {}, untimed).state_hash);
  CHECK(plain.times.repetitions == 0);
  CHECK(timed.times.repetitions == 5);
  CHECK(timed.times.least > 0);
  CHECK(timed.times.median >= timed.times.least);
  CHECK(timed.times.quartile_range >= 0);
  CHECK(SolveTimes{.repetitions = 4, .least = 1, .median = 8, .quartile_range = 2}.spread() == 0.25);
  CHECK(SolveTimes{}.spread() == 0);
}
