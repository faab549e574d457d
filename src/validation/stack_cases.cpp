// Floor 8. Stacks: what their contacts carry, and how fast sweeps find it out.
#include <algorithm>

#include <cairn/measure/violation.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/case_scenes.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// What a sweep over n equal boxes leaves of the slowest error: with A = tridiag(-1, 2, -1)/m, but 1/m at the
/// ground, Jacobi leaves cos((2 k - 1) pi / 2n) of mode k, and Gauss-Seidel the square of that.
double stack_rate(int n) { return std::pow(std::cos(pi / (2 * n)), 2); }

// A1. The contact j, counted from 0 at the ground, carries n - j boxes.
ValidationResult stack_weights(const EngineMaker&) {
  Worst worst = Worst("impulse of a contact: worst of n = 1, 2, 5, 10 and of 5 solvers", "N s")
                    .by("(n - j) m g dt")
                    .since("64 roundings of the total weight, each of which lives 1 / (1 - rate) sweeps");
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int n : {1, 2, 5, 10}) {
      VelocityProblem<double> problem = stack<double>(n);
      // This many sweeps leave less than a rounding of the error.
      const double rate = n > 1 ? stack_rate(n) : 0;
      const int sweeps = n > 1 ? static_cast<int>(std::log(double_epsilon / n) / std::log(rate)) + n : 1;
      make({.iterations = sweeps})->solve(problem);
      const double box_weight = standard_gravity * problem.dt;
      for (int j = 0; j < n; ++j) {
        worst.add((n - j) * box_weight, problem.impulse[j],
                  64 * double_epsilon * n * box_weight / (1 - rate));
      }
    }
  }
  return {.numbers = {worst.number()}};
}

// A1, in a world that has come to rest.
ValidationResult settled_stack(const EngineMaker& make) {
  const int n = 5, sweeps = 2000;
  const Snapshot now = run_scene(make, box_column(List<double>(n, 1.0)), sweeps, 2);
  ValidationResult result;
  const double box_weight = standard_gravity * standard_dt;
  for (int j = 0; j < n; ++j) {
    // Warm starts bring the sweeps of all steps together: what is left is the rounding of the last 2000.
    result.add(measured("impulse under box " + std::to_string(j + 1) + " of 5, after 2 s",
                        normal_impulse_between(now, {j}, {j + 1}), "N s")
                   .by("(n - j) m g dt", (n - j) * box_weight)
                   .within(64 * double_epsilon * (1 + sweeps) * n * box_weight,
                           "64 roundings in each of the last 2000 sweeps"));
  }
  return result;
}

/// The largest error of any of 200 sweeps over two boxes of m = 1 and M, in its tolerance.
template <Scalar Real>
double worst_of_two_boxes(double heavy) {
  const Real m = 1, M = static_cast<Real>(heavy), q = M / (M + m);
  const int sweeps = 200;
  Real largest = 0;
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    VelocityProblem<Real> problem = column<Real>({m, M});
    ImpulseTrace<Real> trace;
    make({.iterations = sweeps})->solve(problem, &trace);
    const Real g_dt = static_cast<Real>(standard_gravity) * problem.dt;
    Real power = 1;  // q^(k - 1)
    for (int k = 1; k <= sweeps; ++k, power *= q) {
      const PerRow<Real>& impulse = trace.sweeps[k];
      const Real rounding = std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + k) * (m + M) * g_dt;
      const Real first = std::abs(impulse[0] - g_dt * (m + M * (1 - power))) / rounding;
      const Real second = std::abs(impulse[1] - g_dt * M * (1 - power * q)) / rounding;
      // Whatever is not a number is the largest.
      if (!(first <= largest)) largest = first;
      if (!(second <= largest)) largest = second;
    }
  }
  return static_cast<double>(largest);
}

template <Scalar Real>
Measured rounding_of_two_boxes(const std::string& scalar) {
  double largest = 0;
  for (const double heavy : {0.25, 1.0, 4.0, 100.0}) {
    const double error = worst_of_two_boxes<Real>(heavy);
    if (!(error <= largest)) largest = error;
  }
  return measured("error in " + scalar +
                      ", over epsilon (1 + k) (m + M) g dt: worst of k = 1..200, "
                      "M/m = 1/4, 1, 4, 100 and of 5 solvers",
                  largest)
      .zero_within(64, "a sweep has fewer than 64 roundings of numbers below (m + M) g dt");
}

// A2, and with it the order in which a sweep sees fresh values: any slip of an index breaks the trace. Row 2
// sees what row 1 has just done, row 1 what row 2 did a sweep ago:
//   impulse_1 = m g dt + impulse_2,   impulse_2 = m M / (m + M) (impulse_1 / m)
ValidationResult two_boxes_sweep_by_sweep(const EngineMaker&) {
  const double heavy = 4, q = heavy / (heavy + 1), g_dt = standard_gravity * standard_dt;
  const int k = 5;
  VelocityProblem<double> problem = column<double>({1, heavy});
  SequentialImpulse<double>({.iterations = k}).solve(problem);
  const double tolerance = 64 * double_epsilon * (1 + k) * (1 + heavy) * g_dt;
  const std::string reason = "64 roundings a sweep of the total weight";
  ValidationResult result;
  result.numbers = {
      measured("impulse at the ground after 5 sweeps, M = 4 m", problem.impulse[0], "N s")
          .by("(m + M (1 - q^(k-1))) g dt, q = M/(M+m)", g_dt * (1 + heavy * (1 - std::pow(q, k - 1))))
          .within(tolerance, reason),
      measured("impulse between the boxes after 5 sweeps, M = 4 m", problem.impulse[1], "N s")
          .by("M (1 - q^k) g dt", g_dt * heavy * (1 - std::pow(q, k)))
          .within(tolerance, reason),
      rounding_of_two_boxes<float>("float"), rounding_of_two_boxes<double>("double")};
  return result;
}

// A3
ValidationResult stack_sweeps(const EngineMaker&) {
  ValidationResult result;
  for (const int n : {5, 10, 20}) {
    Worst worst = Worst("sweeps a digit, n = " + std::to_string(n) + ": worst of 5 solvers", "sweeps")
                      .by("ln 10 / -ln cos^2(pi/2n)")
                      .since("the next mode is e^(-2 pi^2) = 3e-9 of the slowest by sweep n^2; 1e-6 of all");
    const double expected = sweeps_a_digit(stack_rate(n));
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      worst.add(expected, sweeps_a_digit(measured_rate(make, stack<double>(n), n * n, 2 * n * n)),
                1e-6 * expected);
    }
    result.add(worst.number());
  }
  // ln cos^2(x) = -x^2 - x^4/6 - ...
  const double long_stack = 4 * std::log(10.0) / (pi * pi) * 100;
  Measured rule = result.numbers[1];
  rule.formula = "(4 ln 10 / pi^2) n^2 = 0.933 n^2";
  rule.expected = long_stack;
  rule.tolerance = 0.006 * long_stack;
  rule.reason = "the next term of the cosine is (pi/2n)^2 / 6 = 0.4 %";
  result.add(rule);
  return result;
}

// A3. The modes of Jacobi's method come in pairs of rates +-r, so that only every second sweep compares.
ValidationResult stack_sweeps_of_jacobi(const EngineMaker&) {
  ValidationResult result;
  for (const int n : {5, 10, 20}) {
    const double expected = sweeps_a_digit(std::cos(pi / (2 * n)));
    // The next mode as in Gauss-Seidel, in twice as many sweeps.
    const double rate =
        measured_rate(maker<Jacobi<double>, double>(), stack<double>(n), 2 * n * n, 4 * n * n);
    result.add(
        measured("sweeps a digit of plain Jacobi, n = " + std::to_string(n), sweeps_a_digit(rate), "sweeps")
            .by("ln 10 / -ln cos(pi/2n)", expected)
            .within(1e-6 * expected,
                    "the next mode is e^(-2 pi^2) = 3e-9 of the slowest by sweep 2 n^2; 1e-6 of all"));
  }
  return result;
}

/// D. M. Young (1954): x + omega - 1 = omega mu sqrt(x) for the rate x of SOR, mu that of Jacobi.
double rate_by_young(int n, double omega) {
  const double mu = std::cos(pi / (2 * n));
  const double root = (omega * mu + std::sqrt(omega * omega * mu * mu - 4 * (omega - 1))) / 2;
  return root * root;
}

// A3. Below the best omega, 2 / (1 + sin(pi/2n)) = 1.73 for ten boxes, Young's roots are real: errors shrink
// evenly.
ValidationResult stack_sweeps_relaxed(const EngineMaker&) {
  const int n = 10;
  ValidationResult result;
  for (const double omega : {0.5, 1.25, 1.5}) {
    Worst worst = Worst("sweeps a digit of ten boxes, omega = " + std::to_string(omega).substr(0, 4) +
                            ": worst of 2 solvers",
                        "sweeps")
                      .by("ln 10 / -ln x, x + omega - 1 = omega cos(pi/2n) sqrt(x)")
                      .since("the next mode is below 1e-15 of the slowest in these sweeps; 1e-6 of all");
    const double expected = sweeps_a_digit(rate_by_young(n, omega));
    for (const SolverMaker<double>& make : paper_solvers<double>()) {
      const SolverMaker<double> relaxed = [&](SolverSettings settings) {
        settings.relaxation = omega;
        return make(settings);
      };
      const int last = static_cast<int>(4 * expected);
      worst.add(expected, sweeps_a_digit(measured_rate(relaxed, stack<double>(n), last / 2, last)),
                1e-6 * expected);
    }
    result.add(worst.number());
  }
  return result;
}

}  // namespace

void add_stack_cases(ValidationCases& cases) {
  cases.push_back({"A1", "Every contact in a stack of boxes carries the weight of all boxes above it",
                   "statics", Asks::cairn, stack_weights});
  cases.push_back({"A1b", "In a stack that has settled every box bears the weight of all boxes above it",
                   "statics", Asks::any_engine, settled_stack});
  cases.push_back({"A2",
                   "A sweep over two boxes of mass m and, on top, M leaves M / (M + m) of the error, exactly",
                   "derived", Asks::cairn, two_boxes_sweep_by_sweep});
  cases.push_back({"A3", "A sweep over a stack of n boxes leaves cos^2(pi / 2n) of the error", "derived",
                   Asks::cairn, stack_sweeps});
  cases.push_back({"A3b", "A sweep of Jacobi over a stack of n boxes leaves cos(pi / 2n) of the error",
                   "derived", Asks::cairn, stack_sweeps_of_jacobi});
  cases.push_back({"A3c", "Over-relaxed sweeps over a stack converge as fast as Young's theory says",
                   "D. M. Young, 1954", Asks::cairn, stack_sweeps_relaxed});
}

}  // namespace cairn
