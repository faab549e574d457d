// Mistakes in the sweep itself: stale values, limits of friction from another moment, contradictory rows, and
// tests so symmetric that they hide what is slow.
#include "problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A box of 1 m and 1 kg on two feet, of which the right one rises by 0.01 m/s, with two friction rows at the
/// given heights from its centre [m] and friction enough to hold it anywhere. Rows: normal, normal, friction,
/// friction.
VelocityProblem<double> box_with_tangents_at(double first, double second) {
  VelocityProblem<double> problem = box_on_feet<double>({-0.5, 0.5}, {0.1, -test_gravity * test_dt, 0});
  problem.rows.back().bias = 0.01;
  add_row(problem, floor_friction_row<double>({1}, first, 100, 0));
  add_row(problem, floor_friction_row<double>({1}, second, 100, 1));
  return problem;
}

/// A stack of unit boxes that friction glues, carrying its weight already but for a push on the topmost box.
VelocityProblem<double> pushed_stack(int n, const Vec3<double>& push) {
  VelocityProblem<double> problem =
      problem_after(samples::stack(n, {.friction_rows = FrictionRows::per_manifold}), 0);
  REQUIRE(problem.row_count() == 3 * n);
  for (int i = 0; i < problem.row_count(); ++i) {
    const int boxes_above = n - i / 3;
    if (!problem.rows[i].bounds.is_friction()) problem.impulse[i] = boxes_above * test_gravity * test_dt / 2;
  }
  problem.velocity.back() += push;
  return problem;
}

/// The exponent p of sweeps a digit ~ n^p between 6 and 12 boxes, for a solver that keeps symmetry.
double order_of_cost(const Vec3<double>& push, int expected) {
  const auto sweeps_a_digit = [&](int n) {
    const int last = 8 * static_cast<int>(std::lround(std::pow(n, expected)));
    const SolverMaker<double> make = mass_splitting_jacobi<double>;
    return -std::log(10.0) / std::log(measured_rate(make, pushed_stack(n, push), last / 2, last));
  };
  return std::log2(sweeps_a_digit(12) / sweeps_a_digit(6));
}

}  // namespace

// The middle box is pressed from both sides: from below by this sweep's impulse, from above by the last
// one's.
TEST_CASE_TEMPLATE("three boxes approach (3, 2, 1) g dt from (1, 1/2, 1/4) g dt by 3/4 a sweep, exactly",
                   Real, float, double) {
  const int sweeps = 60;
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    VelocityProblem<Real> upwards = stack<Real>(3), downwards = stack<Real>(3);
    ImpulseTrace<Real> up, down;
    make({.iterations = sweeps})->solve(upwards, &up);
    make({.iterations = sweeps, .order = RowOrder::reverse})->solve(downwards, &down);
    const Real g_dt = static_cast<Real>(test_gravity) * upwards.dt;
    Real power = 1;  // (3/4)^(k - 1): cos^2(pi / 6) is the only mode of three boxes that is not 0
    for (int k = 1; k <= sweeps; ++k, power *= Real(0.75)) {
      // Up to 64 roundings a sweep of numbers below 3 g dt.
      const Real tolerance = 64 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + k) * 3 * g_dt;
      const PerRow<Real>& rising = up.sweeps[k];
      const PerRow<Real>& falling = down.sweeps[k];
      CHECK(std::abs(rising[0] - g_dt * (3 - 2 * power)) <= tolerance);
      CHECK(std::abs(rising[1] - g_dt * (2 - Real(1.5) * power)) <= tolerance);
      CHECK(std::abs(rising[2] - g_dt * (1 - Real(0.75) * power)) <= tolerance);
      // Downwards the weight arrives from the top one sweep later: 0, 0, 1/4.
      CHECK(std::abs(falling[0] - g_dt * (3 - 2 * power)) <= tolerance);
      CHECK(std::abs(falling[1] - g_dt * (2 - 2 * power)) <= tolerance);
      CHECK(std::abs(falling[2] - g_dt * (k == 1 ? 0 : 1 - power / Real(0.75))) <= tolerance);
    }
  }
}

TEST_CASE_TEMPLATE("the limit of friction is mu times the normal impulse of this sweep, not of the last step",
                   Real, float, double) {
  const Real mu = Real(0.5);
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    for (const Real warm : {Real(0), Real(1)}) {  // what the last step's normal impulse was
      VelocityProblem<Real> problem = empty_problem<Real>();
      const Real weight = static_cast<Real>(test_gravity) * problem.dt;
      const BodyId box = add_body<Real>(problem, 1, 1, {3, -weight, 0});
      const int normal = add_row(problem, floor_row<Real>(box, 0));
      add_row(problem, floor_friction_row<Real>(box, 0, mu, normal));
      problem.impulse[0] = warm;
      VelocityProblem<Real> friction_first = problem;
      make({.iterations = 1})->solve(problem);
      make({.iterations = 1, .order = RowOrder::reverse})->solve(friction_first);
      const Real tolerance = 64 * std::numeric_limits<Real>::epsilon() * 3;  // of speeds up to 3 m/s
      CHECK(std::abs(problem.impulse[0] - weight) <= tolerance);
      CHECK(problem.impulse[1] == -mu * problem.impulse[0]);
      CHECK(friction_first.impulse[1] == -mu * warm);  // that of the moment: what it started from
    }
  }
}

TEST_CASE(
    "rows that contradict each other leave a residual that no sweep lowers, and a velocity that rests") {
  const double contradiction = 0.25, fall = test_gravity * test_dt;  // [m/s]
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = stack<double>(1);
    problem.rows[0].bounds = Bounds<double>::equality();
    ConstraintRow<double> other = problem.rows[0];
    other.bias = contradiction;
    add_row(problem, other);
    SweepRecorder<double> recorder;
    make({.iterations = 400})->solve(problem, &recorder);
    // Row 1 is satisfied last; row 0 is wrong by the contradiction, for ever. Both have A_ii = 1 and
    // b = bias + g dt.
    const double plateau = contradiction / std::hypot(fall, fall + contradiction);
    for (int k = 1; k <= 400; ++k) {
      CHECK(recorder.sweeps()[k].residual_energy == doctest::Approx(plateau).epsilon(1e-12));
    }
    // Impulses up to 400 * 0.25 N s were added up: 64 (1 + k) roundings.
    CHECK(std::abs(problem.velocity[{1}].y() - contradiction) <= 64 * 401 * double_epsilon * contradiction);
    CHECK(problem.impulse[1] == doctest::Approx(400 * contradiction).epsilon(1e-12));
    CHECK(problem.impulse[0] + problem.impulse[1] == doctest::Approx(fall + contradiction).epsilon(1e-11));
  }
}

TEST_CASE("tangents at one height agree; at two heights friction drifts for ever as soon as the box turns") {
  const int sweeps = 400;
  const auto residual_at = [](const SweepRecorder<double>& recorder, int sweep) {
    return recorder.sweeps()[sweep].residual_energy;
  };
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> level = box_with_tangents_at(-0.5, -0.5);
    VelocityProblem<double> uneven = box_with_tangents_at(-0.5, -0.4);
    SweepRecorder<double> of_level, of_uneven;
    ImpulseTrace<double> trace;
    VelocityProblem<double> traced = uneven;
    make({.iterations = sweeps})->solve(level, &of_level);
    make({.iterations = sweeps})->solve(uneven, &of_uneven);
    make({.iterations = sweeps})->solve(traced, &trace);
    CHECK(residual_at(of_level, sweeps) <= 1e-13);  // 64 (1 + k) roundings, and none of them lasts
    CHECK(residual_at(of_uneven, sweeps) > 1e-3);
    CHECK(residual_at(of_uneven, sweeps) ==
          doctest::Approx(residual_at(of_uneven, sweeps / 2)).epsilon(1e-9));
    // d = (-0.1, 0.1, -1, 1) is the null vector of A. Its product with the biases is the contradiction, 0.001
    // m/s, and sweeps add c d each, where c d^T (D - L) d = c d^T D d / 2 is that contradiction.
    const double weighted = 0.01 * (2.5 + 2.5) + 2.5 + (1 + 6 * 0.16);
    const double drift = 100 * 2 * 0.001 / weighted;
    const PerRow<double>&before = trace.sweeps[300], &after = trace.sweeps[400];
    CHECK(after[2] - before[2] == doctest::Approx(-drift).epsilon(1e-9));
    CHECK(after[3] - before[3] == doctest::Approx(drift).epsilon(1e-9));
    CHECK(after[1] - before[1] == doctest::Approx(0.1 * drift).epsilon(1e-9));
  }
}

TEST_CASE("a push from above on a centred stack is gone in n^2 sweeps, a push from the side in n^4") {
  // A solver that visits rows in turn tilts every box a little; mass splitting keeps a centred stack centred.
  const double from_above = order_of_cost({0, -1e-3, 0}, 2);
  const double from_the_side = order_of_cost({1e-3, 0, 0}, 4);
  // The next terms are of order 1/n^2 to 1/n: between 6 and 12 boxes they shift the exponent by less than
  // 0.3.
  CHECK(std::abs(from_above - 2) <= 0.3);
  CHECK(std::abs(from_the_side - 4) <= 0.3);
}
