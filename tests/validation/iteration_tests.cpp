// One step, many sweeps: the iteration itself, held against its closed forms, for every solver.
#include <algorithm>
#include <numeric>

#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

double squared_cosine(double angle) { return std::cos(angle) * std::cos(angle); }

/// The box of 1 m and 1 kg that has fallen for one step on to contacts at the given places from its middle
/// [m].
VelocityProblem<double> box_on_points(const std::vector<double>& places) {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId box = add_body<double>(problem, 1, 1.0 / 6, {0, -test_gravity * test_dt, 0});
  for (const double x : places) add_row(problem, floor_row(box, x));
  return problem;
}

}  // namespace

// A1
TEST_CASE("every contact in a stack of n boxes carries the weight of what lies above it") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int n : {1, 2, 5, 10}) {
      VelocityProblem<double> problem = stack<double>(n);
      // One sweep shrinks the error by rate, so that this many leave less than a rounding of it.
      const double rate = n > 1 ? squared_cosine(pi / (2 * n)) : 0;
      const int sweeps = n > 1 ? static_cast<int>(std::log(double_epsilon / n) / std::log(rate)) + n : 1;
      make({.iterations = sweeps})->solve(problem);
      for (int j = 0; j < n; ++j) {
        const double weight = (n - j) * test_gravity * problem.dt;
        const double total = n * test_gravity * problem.dt;
        // Each sweep rounds anew, and every rounding lives for 1 / (1 - rate) sweeps.
        const double tolerance = 64 * double_epsilon * total / (1 - rate);
        CHECK(std::abs(problem.impulse[static_cast<std::size_t>(j)] - weight) <= tolerance);
      }
    }
  }
}

// A2, and with it the order in which a sweep sees fresh values: any slip of an index breaks the trace.
TEST_CASE_TEMPLATE("two boxes of mass m and M approach their weights by M / (M + m) a sweep, exactly", Real,
                   float, double, long double) {
  const Real m = 1;
  const int sweeps = 200;
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    for (const Real M : {Real(0.25), Real(1), Real(4), Real(100)}) {
      VelocityProblem<Real> problem = column<Real>({m, M});
      ImpulseTrace<Real> trace;
      make({.iterations = sweeps})->solve(problem, &trace);
      const Real g_dt = static_cast<Real>(test_gravity) * problem.dt;
      const Real q = M / (M + m);
      Real power = 1;  // q^(k - 1)
      for (int k = 1; k <= sweeps; ++k, power *= q) {
        const std::vector<Real>& impulse = trace.sweeps[static_cast<std::size_t>(k)];
        // A sweep has fewer than 64 roundings of numbers below (m + M) g dt.
        const Real tolerance =
            64 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + k) * (m + M) * g_dt;
        CHECK(std::abs(impulse[0] - g_dt * (m + M * (1 - power))) <= tolerance);
        CHECK(std::abs(impulse[1] - g_dt * M * (1 - power * q)) <= tolerance);
      }
    }
  }
}

// A3
TEST_CASE("a sweep over a stack of n boxes shrinks the error by cos^2(pi / 2n): 0.933 n^2 sweeps a digit") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int n : {5, 10, 20}) {
      const double rate = squared_cosine(pi / (2 * n));
      // By sweep n^2 the next mode, cos^2(3 pi / 2n), is e^(-2 pi^2) = 3e-9 of the slowest, which has itself
      // shrunk to e^(-pi^2 / 4) only; the logarithm is taken over as many sweeps again.
      const double measured = measured_rate(make, stack<double>(n), n * n, 2 * n * n);
      CHECK(std::log(measured) / std::log(rate) == doctest::Approx(1).epsilon(1e-6));
    }
    const int n = 10;
    const double sweeps_a_digit = -std::log(10.0) / std::log(measured_rate(make, stack<double>(n), 100, 200));
    // 4 ln 10 / pi^2 = 0.933, but for (pi / 2n)^2 / 6 = 0.4 % from the next term of the cosine.
    CHECK(sweeps_a_digit == doctest::Approx(4 * std::log(10.0) / (pi * pi) * n * n).epsilon(0.006));
  }
}

// A4
TEST_CASE("a sweep over a free chain of m rods shrinks the error by cos^2(pi / (m + 1))") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int m : {4, 9, 19}) {
      const double rate = squared_cosine(pi / (m + 1));
      // The next mode, cos^2(2 pi / (m + 1)), is e^(-3 pi^2 / 2) = 4e-7 of the slowest at the first sweep.
      const int last = (m + 1) * (m + 1);
      const double measured = measured_rate(make, free_chain(m + 1), last / 2, last);
      CHECK(std::log(measured) / std::log(rate) == doctest::Approx(1).epsilon(1e-5));
    }
  }
}

// A4
TEST_CASE("a chain of n beads pinned at both ends has one row too many, and still shrinks by cos^2(pi / n)") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int n : {5, 10, 20}) {
      VelocityProblem<double> problem = empty_problem<double>();
      const VelocityProblem<double> chain = free_chain(n);
      problem.velocity = chain.velocity;
      // Forward sweeps stop the first bead at once, so that the last one must be struck.
      std::swap(problem.velocity[1], problem.velocity.back());
      problem.inverse_mass = chain.inverse_mass;
      add_row(problem, vertical_row<double>(ground, {1}, Bounds<double>::equality()));
      for (const ConstraintRow<double>& row : chain.rows) add_row(problem, row);
      add_row(problem, vertical_row<double>({n}, ground, Bounds<double>::equality()));
      const double measured = measured_rate(make, problem, n * n / 2, n * n);  // the next mode as above
      CHECK(std::log(measured) / std::log(squared_cosine(pi / n)) == doctest::Approx(1).epsilon(1e-5));
    }
  }
}

// A5
TEST_CASE("a box R times as heavy as the one below it costs 2.3 R sweeps a digit") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
      // Two rows have two modes, of which the other one is gone after the first sweep. Left is the rounding
      // of A_12^2 / (A_11 A_22) = 1 - 1 / (1 + R) against 1: 64 epsilon (1 + R) of the logarithm.
      const double measured = measured_rate(make, column<double>({1, ratio}), 1, 5 + static_cast<int>(ratio));
      const double rate = ratio / (1 + ratio);
      const double tolerance = 64 * double_epsilon * (1 + ratio) * std::exp(1.0);
      CHECK(std::log(measured) / std::log(rate) == doctest::Approx(1).epsilon(tolerance));
      if (ratio < 100) continue;
      // ln 10 / ln(1 + 1/R) = 2.303 (R + 1/2 - ...)
      CHECK(-std::log(10.0) / std::log(measured) ==
            doctest::Approx(std::log(10.0) * ratio).epsilon(1 / ratio));
    }
  }
}

// A5
TEST_CASE("a heavy box on n - 1 light ones costs 2.3 (n - 1) R + 0.93 n^2 sweeps a digit") {
  const double ratio = 100;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int n : {3, 5}) {
      std::vector<double> masses(static_cast<std::size_t>(n), 1.0);
      masses.back() = ratio;
      const double measured = measured_rate(make, column(masses), 1000, 2000);
      const double expected = std::log(10.0) * (n - 1) * ratio + 4 * std::log(10.0) / (pi * pi) * n * n;
      // The formula adds two time scales that act together; that is good to 15 %.
      CHECK(-std::log(10.0) / std::log(measured) == doctest::Approx(expected).epsilon(0.15));
    }
  }
}

// A6
TEST_CASE("a box of a hundredth of the mass of the one below it gains two digits a sweep") {
  const double ratio = 0.01;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    const double measured = measured_rate(make, column<double>({1, ratio}), 1, 4);
    // The residual of sweep 4 is rate^3 = 1e-6 of the first one's, and rounded to epsilon of that.
    CHECK(measured == doctest::Approx(ratio / (1 + ratio)).epsilon(64 * double_epsilon / 1e-6));
  }
}

// A9
TEST_CASE("a box on three points stands still in any order of rows, but the order decides who carries it") {
  const double weight = test_gravity * test_dt;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    std::vector<double> places = {-0.5, 0, 0.5};
    std::vector<double> middle;
    do {
      VelocityProblem<double> problem = box_on_points(places);
      make({.iterations = 1000})->solve(problem);
      CHECK(problem.velocity[1].cwiseAbs().maxCoeff() <= 1e-14);  // 64 epsilon of 1 m/s
      const double sum = std::accumulate(problem.impulse.begin(), problem.impulse.end(), 0.0);
      CHECK(std::abs(sum - weight) <= 1e-14);
      const auto at_middle = std::find(places.begin(), places.end(), 0.0) - places.begin();
      middle.push_back(problem.impulse[static_cast<std::size_t>(at_middle)]);
    } while (std::next_permutation(places.begin(), places.end()));
    const auto [least, most] = std::minmax_element(middle.begin(), middle.end());
    CHECK(*most - *least > 0.01 * weight);  // far above rounding: the impulses are not unique
  }
}
