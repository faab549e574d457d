// How slowly sweeps converge where bodies bend each other: welded beams, and stacks that friction glues.
//
// Both are cantilevers, clamped at the ground. Their slowest mode is that of a bending moment Q(k) along the
// joints k, which bodies answer by moving across the beam. It costs the bodies the energy sum (Q'')^2 / s,
// and the rows, each for itself, c sum Q^2 / s with a c of the rows' A_ii alone. Gauss-Seidel leaves 1 - 2 q
// of such a mode, q the quotient of the two: beta^4 / (c n^4), where 1 + cos(beta) cosh(beta) = 0, as for a
// vibrating beam (S. Timoshenko, 1928). All that is left out here is of order 1/n^2.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "constraints/weld_joint.hpp"
#include "geometry/shape.hpp"
#include "problems.hpp"
#include "solvers/system_matrix.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

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

/// The solvers of the paper.
std::vector<SolverMaker<double>> beam_solvers() {
  return {maker<SequentialImpulse<double>, double>(), maker<ProjectedGaussSeidel<double>, double>()};
}

/// Boxes of 1 m and 1 kg in a horizontal row, the first welded to the ground, after one step of falling.
VelocityProblem<double> welded_cantilever(int n) {
  Scene scene;
  BodyId last = ground;
  for (int k = 0; k < n; ++k) {
    const BodyId next = scene.add({.shapes = {box(1, 1)}, .position = {k + 0.5, 0}, .mass = 1});
    scene.join<WeldJoint>({.a = last, .b = next, .anchor = {static_cast<double>(k), 0}});
    last = next;
  }
  return World(scene).velocity_problem();
}

/// A stack of boxes that carries its weight already, and whose topmost box is pushed too softly for any
/// contact to slip or open. The rows of an interface: normal, friction, normal, friction.
VelocityProblem<double> glued_boxes(int n, double height) {
  Scene scene;
  scene.add_ground();
  for (int k = 0; k < n; ++k) {
    scene.add({.shapes = {box(1, height)}, .position = {0, (k + 0.5) * height}, .mass = 1});
  }
  VelocityProblem<double> problem = World(scene).velocity_problem();
  REQUIRE(problem.row_count() == 4 * n);
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const int boxes_above = n - static_cast<int>(i) / 4;
    if (i % 2 == 0) problem.impulse[i] = boxes_above * test_gravity * test_dt / 2;
  }
  problem.velocity.back().x() += 1e-3;
  return problem;
}

/// The same with the rows of an interface in the order normal, normal, friction, friction.
VelocityProblem<double> normals_first(const VelocityProblem<double>& problem) {
  VelocityProblem<double> result = problem;
  for (std::size_t first = 0; first < result.rows.size(); first += 4) {
    std::swap(result.rows[first + 1], result.rows[first + 2]);
    std::swap(result.impulse[first + 1], result.impulse[first + 2]);
    result.rows[first + 3].bounds.normal_row = static_cast<int>(first) + 1;
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

/// Sweeps a digit, divided by n^4, once the second mode is gone: it shrinks (4.694 / 1.875)^4 = 39 times as
/// fast as the first, to e^-40 in n^4 / 2 sweeps, in which the first one shrinks to e^-1.
double measured_cost(const SolverMaker<double>& make, const VelocityProblem<double>& problem, int n) {
  const int last = n * n * n * n;
  return -std::log(10.0) / std::log(measured_rate(make, problem, last / 2, last)) / last;
}

/// Checks costs at n = 5 and n = 10 against that of long beams: they differ from it in order 1/n^2.
void check_beam_cost(double five, double ten, double limit) {
  const double correction = five / limit - 1;
  const double order = std::log2(correction / (ten / limit - 1));
  CHECK(order >= 1.8);
  CHECK(order <= 2.2);
  // Extrapolation removes that order and leaves a quarter of the next, which is about the first one's square.
  CHECK((4 * ten - five) / 3 == doctest::Approx(limit).epsilon(correction * correction / 4));
}

}  // namespace

// A7
TEST_CASE("both solvers of the paper find (n - k) m g and (n - k)^2 m g a / 2 at joint k of a welded beam") {
  for (const SolverMaker<double>& make : beam_solvers()) {
    for (const int n : {2, 5, 6}) {
      VelocityProblem<double> problem = welded_cantilever(n);
      // At most 2 n^4 sweeps a digit, and 12 digits.
      make({.iterations = 24 * n * n * n * n})->solve(problem);
      const double weight = test_gravity * test_dt;
      for (int k = 0; k < n; ++k) {
        const auto row = static_cast<std::size_t>(3 * k);
        const int carried = n - k;
        CHECK(std::abs(problem.impulse[row]) <= 1e-10);
        CHECK(problem.impulse[row + 1] == doctest::Approx(carried * weight).epsilon(1e-10));
        CHECK(problem.impulse[row + 2] == doctest::Approx(carried * carried * weight / 2).epsilon(1e-10));
      }
    }
  }
}

// A7
TEST_CASE(
    "a welded beam of n boxes costs 1.12 n^4 sweeps a digit, and a few percent more while it is short") {
  for (const SolverMaker<double>& make : beam_solvers()) {
    const double five = measured_cost(make, welded_cantilever(5), 5);
    const double ten = measured_cost(make, welded_cantilever(10), 10);
    check_beam_cost(five, ten, beam_cost(welded_c));
    CHECK(ten == doctest::Approx(1.15).epsilon(0.05));
  }
}

// A8
TEST_CASE("a stack that friction glues costs 0.93 n^4 sweeps a digit instead of 0.93 n^2") {
  for (const SolverMaker<double>& make : beam_solvers()) {
    const double five = measured_cost(make, normals_first(glued_boxes(5, 1)), 5);
    const double ten = measured_cost(make, normals_first(glued_boxes(10, 1)), 10);
    check_beam_cost(five, ten, beam_cost(glued_c(1)));
    CHECK(ten == doctest::Approx(0.96).epsilon(0.05));
  }
}

// A8
TEST_CASE("a glued stack of boxes four times as high as wide costs 7 n^4 sweeps a digit") {
  // The eigenvalue tells it without as many sweeps.
  const auto cost = [](int n) {
    const double rate = spectral_rate(normals_first(glued_boxes(n, 4)));
    return -std::log(10.0) / std::log(rate) / std::pow(n, 4);
  };
  check_beam_cost(cost(5), cost(10), beam_cost(glued_c(4)));
}

// A8
TEST_CASE("friction rows between the two normal rows of an interface cost a few percent more sweeps") {
  for (const SolverMaker<double>& make : beam_solvers()) {
    const int n = 6;
    const double between = measured_cost(make, glued_boxes(n, 1), n);
    const double behind = measured_cost(make, normals_first(glued_boxes(n, 1)), n);
    CHECK(between > 1.01 * behind);
    CHECK(between < behind * (1 + 1.0 / n));  // of order 1/n: the limit is the same
  }
}

// A7, A8
TEST_CASE("the rate of both solvers is the spectral radius of (D - L)^-1 U") {
  for (const SolverMaker<double>& make : beam_solvers()) {
    for (const int n : {4, 5, 6}) {
      const VelocityProblem<double> beam = welded_cantilever(n), stack_of_boxes = glued_boxes(n, 1);
      for (const VelocityProblem<double>& problem : {beam, stack_of_boxes}) {
        const int last = n * n * n * n;
        const double rate = measured_rate(make, problem, last / 2, last);
        CHECK(std::log(rate) / std::log(spectral_rate(problem)) == doctest::Approx(1).epsilon(1e-6));
      }
    }
  }
}

// A8
TEST_CASE("every interface of a glued stack has one friction row too many, and nothing slips or opens") {
  for (const int n : {1, 4, 8}) {
    const VelocityProblem<double> start = glued_boxes(n, 1);
    const Matrix<double> A = system_matrices(start).A;
    CHECK(Eigen::FullPivLU<Matrix<double>>(A).dimensionOfKernel() == n);
    for (const SolverMaker<double>& make : beam_solvers()) {
      VelocityProblem<double> problem = start;
      make({.iterations = 2000})->solve(problem);
      for (std::size_t i = 0; i < problem.rows.size(); i += 2) {
        CHECK(problem.impulse[i] > 0);
        CHECK(std::abs(problem.impulse[i + 1]) < 0.6 * problem.impulse[i]);
      }
    }
  }
}
