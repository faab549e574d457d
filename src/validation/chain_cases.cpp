// Floor 8. Chains and unequal masses: how fast sweeps solve them; and rows that one body has too many.
#include <algorithm>
#include <numeric>

#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

// A4. A = tridiag(-1, 2, -1)/m: Jacobi leaves cos(k pi / (m + 1)) of mode k, Gauss-Seidel the square.
ValidationResult free_chain_sweeps(const EngineMaker&) {
  ValidationResult result;
  for (const int m : {4, 9, 19}) {
    Worst worst = Worst("sweeps a digit of " + std::to_string(m) + " rods: worst of 5 solvers", "sweeps")
                      .by("ln 10 / -ln cos^2(pi/(m+1))")
                      .since("the next mode is e^(-3 pi^2 / 2) = 4e-7 of the slowest at first; 1e-5 of all");
    const double expected = sweeps_a_digit(std::pow(std::cos(pi / (m + 1)), 2));
    const int last = (m + 1) * (m + 1);
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      const double rate = measured_rate(make, free_chain(m + 1), last / 2, last);
      worst.add(expected, sweeps_a_digit(rate), 1e-5 * expected);
    }
    result.add(worst.number());
  }
  return result;
}

/// n beads tied to each other and both ends to the ground: n + 1 rows of rank n. Forward sweeps stop the
/// first bead at once, so that the last one is the one that was struck.
VelocityProblem<double> pinned_chain(int n) {
  VelocityProblem<double> problem = empty_problem<double>();
  const VelocityProblem<double> chain = free_chain(n);
  problem.velocity = chain.velocity;
  std::swap(problem.velocity[{1}], problem.velocity.back());
  problem.inverse_mass = chain.inverse_mass;
  add_row(problem, vertical_row<double>(ground, {1}, Bounds<double>::equality()));
  for (const ConstraintRow<double>& row : chain.rows) add_row(problem, row);
  add_row(problem, vertical_row<double>({n}, ground, Bounds<double>::equality()));
  return problem;
}

// A4. The rows at the ends have A_ii = 1/m, the others 2/m: D^-1 A is that of a walk between walls, and
// Jacobi leaves cos(k pi / n) of mode k = 0..n. Modes 0 and n are one for Gauss-Seidel, and move nothing.
ValidationResult pinned_chain_sweeps(const EngineMaker&) {
  ValidationResult result;
  for (const int n : {5, 10, 20}) {
    Worst worst = Worst("sweeps a digit of " + std::to_string(n) + " beads: worst of 5 solvers", "sweeps")
                      .by("ln 10 / -ln cos^2(pi/n)")
                      .since("the next mode is e^(-3 pi^2 / 2) = 4e-7 of the slowest at first; 1e-5 of all");
    const double expected = sweeps_a_digit(std::pow(std::cos(pi / n), 2));
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      const double rate = measured_rate(make, pinned_chain(n), n * n / 2, n * n);
      worst.add(expected, sweeps_a_digit(rate), 1e-5 * expected);
    }
    result.add(worst.number());
  }
  return result;
}

// A5. Two rows: rho = A_12^2 / (A_11 A_22) = R / (1 + R).
ValidationResult heavy_on_light_sweeps(const EngineMaker&) {
  ValidationResult result;
  for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
    const double expected = sweeps_a_digit(ratio / (1 + ratio));
    Worst worst =
        Worst("sweeps a digit, R = " + std::to_string(std::lround(ratio)) + ": worst of 5 solvers", "sweeps")
            .by("ln 10 / ln(1 + 1/R), about 2.3 (R + 1/2)")
            .since("1 - rate = 1/(1 + R) is rounded: 64 e epsilon (1 + R) of all");
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      const double rate = measured_rate(make, column<double>({1, ratio}), 1, 5 + static_cast<int>(ratio));
      worst.add(expected, sweeps_a_digit(rate), 64 * double_epsilon * (1 + ratio) * std::exp(1.0) * expected);
    }
    result.add(worst.number());
  }
  return result;
}

// A5. The heavy box is known below after R sweeps for each interface, and the light ones as in a stack.
ValidationResult heavy_on_stack_sweeps(const EngineMaker&) {
  const double ratio = 100;
  ValidationResult result;
  for (const int n : {3, 5}) {
    List<double> masses(n, 1.0);
    masses.back() = ratio;
    Worst worst =
        Worst("sweeps a digit, R = 100, n = " + std::to_string(n) + ": worst of 5 solvers", "sweeps")
            .by("ln 10 ((n-1) R + 4 n^2 / pi^2)")
            .since("the formula adds two time scales that act together: 15 %");
    const double expected = std::log(10.0) * ((n - 1) * ratio + 4 / (pi * pi) * n * n);
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      worst.add(expected, sweeps_a_digit(measured_rate(make, column(masses), 1000, 2000)), 0.15 * expected);
    }
    result.add(worst.number());
  }
  return result;
}

// A6
ValidationResult light_on_heavy_sweeps(const EngineMaker&) {
  const double ratio = 0.01;
  Worst worst = Worst("share of the error that a sweep leaves, r = 0.01: worst of 5 solvers")
                    .by("r / (1 + r)")
                    .since("sweep 4 leaves 1e-6 of sweep 1, rounded to 64 epsilon of that");
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    const double expected = ratio / (1 + ratio);
    worst.add(expected, measured_rate(make, column<double>({1, ratio}), 1, 4),
              64 * double_epsilon / 1e-6 * expected);
  }
  return {.numbers = {worst.number()}};
}

/// The box of 1 m and 1 kg that has fallen for one step on to contacts at the given places from its middle
/// [m].
VelocityProblem<double> box_on_points(const List<double>& places) {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId box = add_body<double>(problem, 1, 1.0 / 6, {0, -standard_gravity * standard_dt, 0});
  for (const double x : places) add_row(problem, floor_row(box, x));
  return problem;
}

// A9. A = [2.5 1 -0.5; 1 1 1; -0.5 1 2.5] / m is blind to n = (1, -2, 1): velocities are fixed, impulses are
// not. With T, A on and below its diagonal in the order of the rows, a sweep solves T x' = b - (A - T) x. As
// n A = 0 and n b = 0, it keeps n T x, which is 0 at the start. x = W (0, 1, 0) + s n has that for
//   s = -W n T (0, 1, 0) / (n T n) = 0, 2/9 W or 4/9 W   with the middle row first, second or last.
ValidationResult box_on_three_points(const EngineMaker&) {
  const double weight = standard_gravity * standard_dt;
  const std::string any = ": worst of 6 orders and 5 solvers", some = ": worst of 2 orders and 5 solvers";
  const std::string one = "64 epsilon of 1 N s, more than what the few sweeps before rest round";
  Worst speed = Worst("largest velocity" + any, "m/s").by("0").since(one);
  Worst sum = Worst("sum of impulses" + any, "N s").by("m g dt").since(one);
  List<Worst> middle = {
      Worst("impulse in the middle, its row first" + some, "N s").by("m g dt").since(one),
      Worst("impulse in the middle, its row second" + some, "N s").by("5/9 m g dt").since(one),
      Worst("impulse in the middle, its row last" + some, "N s").by("1/9 m g dt").since(one)};
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    List<double> places = {-0.5, 0, 0.5};
    do {
      VelocityProblem<double> problem = box_on_points(places);
      make({.iterations = 1000})->solve(problem);
      speed.add(0, problem.velocity[{1}].cwiseAbs().maxCoeff(), 64 * double_epsilon);
      sum.add(weight, std::accumulate(problem.impulse.begin(), problem.impulse.end(), 0.0),
              64 * double_epsilon);
      const auto row = std::find(places.begin(), places.end(), 0.0) - places.begin();
      middle[row].add(weight * (1 - 4 * static_cast<double>(row) / 9), problem.impulse[row],
                      64 * double_epsilon);
    } while (std::next_permutation(places.begin(), places.end()));
  }
  ValidationResult result{.numbers = {speed.number(), sum.number()}};
  for (const Worst& place : middle) result.add(place.number());
  return result;
}

}  // namespace

void add_chain_cases(ValidationCases& cases) {
  cases.push_back({"A4", "A sweep over a free chain of m rods leaves cos^2(pi / (m + 1)) of the error",
                   "derived", Asks::cairn, free_chain_sweeps});
  cases.push_back({"A4b",
                   "A sweep over a chain of n beads between two walls leaves cos^2(pi / n) of the error",
                   "derived", Asks::cairn, pinned_chain_sweeps});
  cases.push_back({"A5", "A box R times as heavy as the one below it costs 2.3 R sweeps a digit", "derived",
                   Asks::cairn, heavy_on_light_sweeps});
  cases.push_back({"A5b", "A heavy box on n - 1 light ones costs 2.3 (n - 1) R + 0.93 n^2 sweeps a digit",
                   "derived", Asks::cairn, heavy_on_stack_sweeps});
  cases.push_back({"A6", "A box with a hundredth of the mass of the one below it gains two digits a sweep",
                   "derived", Asks::cairn, light_on_heavy_sweeps});
  cases.push_back(
      {"A9", "A box on three points stands still in any order of rows, but the order decides who carries it",
       "derived", Asks::cairn, box_on_three_points});
}

}  // namespace cairn
