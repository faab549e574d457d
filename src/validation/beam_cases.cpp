// Floor 8. How slowly sweeps converge where bodies bend each other: welded beams, and stacks that
// friction glues.
//
// Both are cantilevers, clamped at the ground. Their slowest mode is that of a bending moment Q(k) along the
// joints k, which bodies answer by moving across the beam. It costs the bodies the energy sum (Q'')^2 / s,
// and the rows, each for itself, c sum Q^2 / s with a c of the rows' A_ii alone. Gauss-Seidel leaves 1 - 2 q
// of such a mode, q the quotient of the two: beta^4 / (c n^4), where 1 + cos(beta) cosh(beta) = 0, as for a
// vibrating beam (S. Timoshenko, 1928). All that is left out here is of order 1/n^2.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

#include <cairn/geometry/shape.hpp>
#include <cairn/solvers/system_matrix.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/case_scenes.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double beam_beta = 1.8751040687;  // the first root of 1 + cos(beta) cosh(beta)

/// Sweeps a digit, divided by n^4, for long beams.
double beam_cost(double c) { return std::log(10.0) * c / (2 * std::pow(beam_beta, 4)); }

/// c of welded boxes of 1 m and 1 kg: I = 1/6, and the angle row has A_ii = 2 / I.
const double welded_c = 12;

/// c of boxes of 1 m by `height`: two normal rows of A_ii = 2 (1 + 0.25 / I) bear the moment by lever arms of
/// 1 m, and friction changes it by its lever arm, the height.
double glued_c(double height) {
  const double inertia = (1 + height * height) / 12;
  return 4 * height * height * (1 + 0.25 / inertia);
}

/// The welded beam after one step of falling.
VelocityProblem<double> welded_cantilever(int n) { return World(welded_beam(n)).velocity_problem(); }

/// A stack of boxes that carries its weight already, and whose topmost box is pushed too softly for any
/// contact to slip or open. The rows of an interface: normal, friction, normal, friction.
VelocityProblem<double> glued_boxes(int n, double height) {
  Scene scene;
  scene.add_ground();
  for (int k = 0; k < n; ++k) {
    scene.add({.shapes = {box(1, height)}, .position = {0, (k + 0.5) * height}, .mass = 1});
  }
  VelocityProblem<double> problem = World(scene).velocity_problem();
  if (problem.row_count() != 4 * n) throw std::logic_error("glued_boxes: an interface must have 4 rows");
  for (int i = 0; i < problem.row_count(); ++i) {
    const int boxes_above = n - i / 4;
    if (i % 2 == 0) problem.impulse[i] = boxes_above * standard_gravity * standard_dt / 2;
  }
  problem.velocity.back().x() += 1e-3;
  return problem;
}

/// The same with the rows of an interface in the order normal, normal, friction, friction.
VelocityProblem<double> normals_first(const VelocityProblem<double>& problem) {
  VelocityProblem<double> result = problem;
  for (int first = 0; first < result.rows.size(); first += 4) {
    std::swap(result.rows[first + 1], result.rows[first + 2]);
    std::swap(result.impulse[first + 1], result.impulse[first + 2]);
    result.rows[first + 3].bounds.normal_row = first + 1;
  }
  return result;
}

/// The largest eigenvalue below 1 of -(D - L)^-1 U, by which a sweep of Gauss-Seidel multiplies errors;
/// eigenvalues of 1 belong to impulses that move nothing.
double spectral_rate(const VelocityProblem<double>& problem) {
  const Matrix<double> A = system_matrices(problem).A;
  const Matrix<double> lower = A.triangularView<Eigen::Lower>();
  const Matrix<double> upper = A - lower;
  const Matrix<double> step = lower.triangularView<Eigen::Lower>().solve(upper);
  const Eigen::VectorXcd eigenvalues = step.eigenvalues();
  double largest = 0;
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i) {
    const double size = std::abs(eigenvalues[i]);
    if (size < 1 - 1e-9) largest = std::max(largest, size);
  }
  return largest;
}

/// Sweeps a digit, divided by n^4, of a rate.
double cost_of(double rate, int n) { return sweeps_a_digit(rate) / std::pow(n, 4); }

/// The same as measured, once the second mode is gone: it shrinks (4.694 / 1.875)^4 = 39 times as fast as the
/// first, to e^-40 in n^4 / 2 sweeps, in which the first one shrinks to e^-1.
double measured_cost(const SolverMaker<double>& make, const VelocityProblem<double>& problem, int n) {
  const int last = n * n * n * n;
  return cost_of(measured_rate(make, problem, last / 2, last), n);
}

/// Costs at n = 5 and n = 10 beside that of long beams.
class BeamNumbers {
 public:
  BeamNumbers(const std::string& about, const std::string& formula, double limit)
      : limit_(limit),
        order_(Worst("order in 1/n of what a short one costs more" + about)
                   .by("2")
                   .since("between n = 5 and 10 the next order still weighs 0.2")),
        cost_(Worst("sweeps a digit / n^4, extrapolated from n = 5 and 10" + about)
                  .by(formula)
                  .since("the next order is the square of the first one's share, a quarter of it left")) {}

  void add(double five, double ten) {
    const double correction = five / limit_ - 1;
    order_.add(2, std::log2(correction / (ten / limit_ - 1)), 0.2);
    cost_.add(limit_, (4 * ten - five) / 3, correction * correction / 4 * limit_);
  }
  List<Measured> numbers() const { return {cost_.number(), order_.number()}; }

 private:
  double limit_;
  Worst order_;
  Worst cost_;
};

// A7
ValidationResult welded_beam_statics(const EngineMaker&) {
  const std::string of = ": worst of all joints, n = 2, 5, 6 and 2 solvers",
                    reason = "12 digits of sweeps, and rounding in each of them: 1e-10 of it";
  Worst along = Worst("impulse along the beam" + of, "N s")
                    .by("0")
                    .since("12 digits of sweeps, of impulses up to 3 N s: 1e-10");
  Worst across = Worst("impulse across the beam" + of, "N s").by("(n - k) m g dt").since(reason);
  Worst moment = Worst("angular impulse" + of, "N m s").by("(n - k)^2 m g a dt / 2").since(reason);
  const double weight = standard_gravity * standard_dt;
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const int n : {2, 5, 6}) {
      VelocityProblem<double> problem = welded_cantilever(n);
      // At most 2 n^4 sweeps a digit, and 12 digits.
      make({.iterations = 24 * n * n * n * n})->solve(problem);
      for (int k = 0; k < n; ++k) {
        const auto row = 3 * k;
        const double load = (n - k) * weight, bending = (n - k) * load / 2;
        along.add(0, problem.impulse[row], 1e-10);
        across.add(load, problem.impulse[row + 1], 1e-10 * load);
        moment.add(bending, problem.impulse[row + 2], 1e-10 * bending);
      }
    }
  }
  return {.numbers = {along.number(), across.number(), moment.number()}};
}

// A7
ValidationResult welded_beam_sweeps(const EngineMaker&) {
  BeamNumbers numbers(": worst of 2 solvers", "ln 10 c / (2 beta^4), c = 12", beam_cost(welded_c));
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    numbers.add(measured_cost(make, welded_cantilever(5), 5), measured_cost(make, welded_cantilever(10), 10));
  }
  return {.numbers = numbers.numbers()};
}

// A8
ValidationResult glued_stack_sweeps(const EngineMaker&) {
  BeamNumbers numbers(": worst of 2 solvers", "ln 10 c / (2 beta^4), c = 4 (1 + 1/(4 I)) = 10",
                      beam_cost(glued_c(1)));
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    numbers.add(measured_cost(make, normals_first(glued_boxes(5, 1)), 5),
                measured_cost(make, normals_first(glued_boxes(10, 1)), 10));
  }
  return {.numbers = numbers.numbers()};
}

// A8. The eigenvalue tells it without as many sweeps.
ValidationResult tall_glued_stack_sweeps(const EngineMaker&) {
  BeamNumbers numbers("", "ln 10 c / (2 beta^4), c = 4 h^2 (1 + 1/(4 I)), h = 4 m", beam_cost(glued_c(4)));
  const auto cost = [](int n) { return cost_of(spectral_rate(normals_first(glued_boxes(n, 4))), n); };
  numbers.add(cost(5), cost(10));
  return {.numbers = numbers.numbers()};
}

// A8. Two friction rows in a line take opposite impulses for nothing: n = (1, -1). Errors x that go as slowly
// as theta, A x = theta T x with T = D - L, therefore have n T x = 0, and so have those of the transposed, n
// T^T y = 0; and theta = y A x / y T x. Friction feels normal impulses at the ground alone, by A_tn = -+1.5
// there, as between boxes the two bodies cancel. With P at the left foot and -P at the right one, in the
// order normal, friction, normal, friction this asks for friction of -0.6 P and 0.6 P in x, 0.6 P and -0.6 P
// in y, which makes y T x larger by 0.9 P^2. All of it is 5 sum Q^2 = 5 n P^2 / 4, as a vibrating beam has a
// quarter of the square of its largest moment on the average. The share is 0.72 / n.
ValidationResult friction_between_normals(const EngineMaker&) {
  const auto share_times_n = [](int n) {
    const VelocityProblem<double> between = glued_boxes(n, 1);
    return n * (cost_of(spectral_rate(between), n) / cost_of(spectral_rate(normals_first(between)), n) - 1);
  };
  const double limit = 0.9 / (5.0 / 4), twenty = share_times_n(20), forty = share_times_n(40);
  const double correction = twenty / limit - 1;
  return {.numbers = {measured("n times the share of more sweeps, extrapolated from n = 20 and 40",
                               2 * forty - twenty)
                          .by("0.9 / (5/4)", limit)
                          .within(correction * correction / 2 * limit,
                                  "the next order is the square of the first one's share, half of it left")}};
}

// A7, A8
ValidationResult rates_are_spectral_radii(const EngineMaker&) {
  Worst worst = Worst(
                    "ln of the rate of sweeps, over that of the eigenvalue: worst of a welded beam, a "
                    "glued stack, n = 4, 5, 6 and 2 solvers")
                    .by("1")
                    .since("the second mode is e^-40 of the first; 1e-6 for rounding of 1 - rate");
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const int n : {4, 5, 6}) {
      const VelocityProblem<double> beam = welded_cantilever(n), stack_of_boxes = glued_boxes(n, 1);
      for (const VelocityProblem<double>& problem : {beam, stack_of_boxes}) {
        const int last = n * n * n * n;
        const double rate = measured_rate(make, problem, last / 2, last);
        worst.add(1, std::log(rate) / std::log(spectral_rate(problem)), 1e-6);
      }
    }
  }
  return {.numbers = {worst.number()}};
}

// A8. Two normal and two friction rows at an interface, and three ways in which boxes can move.
ValidationResult glued_stack_rank(const EngineMaker&) {
  ValidationResult result;
  for (const int n : {1, 4, 8}) {
    const VelocityProblem<double> start = glued_boxes(n, 1);
    const Eigen::FullPivLU<Matrix<double>> factors(system_matrices(start).A);
    result.add({.what = "friction rows too many in a stack of " + std::to_string(n),
                .formula = "n",
                .expected = static_cast<double>(n),
                .got = static_cast<double>(factors.dimensionOfKernel()),
                .reason = "a count"});
    int slipping = 0;
    for (const SolverMaker<double>& make : paper_solvers<double>()) {
      VelocityProblem<double> problem = start;
      make({.iterations = 2000})->solve(problem);
      for (int i = 0; i < problem.row_count(); i += 2) {
        const bool holds =
            problem.impulse[i] > 0 && std::abs(problem.impulse[i + 1]) < 0.6 * problem.impulse[i];
        slipping += holds ? 0 : 1;
      }
    }
    result.add({.what = "contacts that slip or open in a stack of " + std::to_string(n),
                .formula = "0",
                .got = static_cast<double>(slipping),
                .reason = "a count, over 2 solvers"});
  }
  return result;
}

}  // namespace

void add_beam_cases(ValidationCases& cases) {
  cases.push_back(
      {"A7", "Joint k of a welded beam carries the force (n - k) m g and the torque (n - k)^2 m g a / 2",
       "statics", Asks::cairn, welded_beam_statics});
  cases.push_back({"A7b", "A welded beam of n boxes costs 1.12 n^4 sweeps a digit",
                   "S. Timoshenko, 1928; derived", Asks::cairn, welded_beam_sweeps});
  cases.push_back({"A7c", "What a sweep leaves of the error is the spectral radius of (D - L)^-1 U",
                   "D. M. Young, 1954", Asks::cairn, rates_are_spectral_radii});
  cases.push_back({"A8",
                   "A stack that friction glues together costs 0.93 n^4 sweeps a digit instead of 0.93 n^2",
                   "S. Timoshenko, 1928; derived", Asks::cairn, glued_stack_sweeps});
  cases.push_back({"A8b", "A glued stack of boxes four times as high as wide costs 7 n^4 sweeps a digit",
                   "S. Timoshenko, 1928; derived", Asks::cairn, tall_glued_stack_sweeps});
  cases.push_back({"A8c", "Every interface of a glued stack has one friction row too many", "derived",
                   Asks::cairn, glued_stack_rank});
  cases.push_back({"A8d", "Friction rows between the normal rows of an interface cost 0.72 / n more sweeps",
                   "derived", Asks::cairn, friction_between_normals});
}

}  // namespace cairn
