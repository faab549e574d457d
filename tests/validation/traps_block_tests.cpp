// Solving the rows of a joint together (paper 4.3): exact for one joint, and what is left of that for many.
#include <Eigen/LU>

#include "problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// One sweep over equality rows that solves `size` consecutive rows at a time, exactly.
template <int size>
void sweep_in_blocks(VelocityProblem<double>& problem) {
  for (int first = 0; first < problem.row_count(); first += size) {
    Eigen::Matrix<double, size, size> A;
    Eigen::Matrix<double, size, 1> speed;
    for (int i = 0; i < size; ++i) {
      const ConstraintRow<double>& row = problem.rows[first + i];
      VelocityProblem<double> response = problem;  // of one unit of impulse
      for (Vec3<double>& v : response.velocity) v.setZero();
      apply_impulse(response, row, 1.0);
      for (int j = 0; j < size; ++j) A(j, i) = row_velocity(response, problem.rows[first + j]);
      speed(i) = row_velocity(problem, row);
    }
    const Eigen::Matrix<double, size, 1> impulse = -(A.inverse() * speed);
    for (int i = 0; i < size; ++i) apply_impulse(problem, problem.rows[first + i], impulse(i));
  }
}

/// sqrt(sum (j v)^2): how far the rows are from holding.
double error_of_rows(const VelocityProblem<double>& problem) {
  double sum = 0;
  for (const ConstraintRow<double>& row : problem.rows) sum += std::pow(row_velocity(problem, row), 2);
  return std::sqrt(sum);
}

/// Sweeps for each factor of e that the error shrinks by, in the second half of so many.
template <int size>
double sweeps_each(VelocityProblem<double> problem, int sweeps) {
  for (int sweep = 0; sweep < sweeps / 2; ++sweep) sweep_in_blocks<size>(problem);
  const double half_way = error_of_rows(problem);
  for (int sweep = 0; sweep < sweeps / 2; ++sweep) sweep_in_blocks<size>(problem);
  return sweeps / 2 / std::log(half_way / error_of_rows(problem));
}

/// n rods of 1 m that rise at 45 degrees in a line, the first one held by the ground, after a step of
/// falling.
template <typename Joint>
VelocityProblem<double> oblique_rods(int n) {
  Scene scene;
  const Vec2<double> along = Vec2<double>(1, 1) / std::sqrt(2.0);
  samples::add_chain<Joint>(
      scene, n, {.shapes = {box(1, 0.1)}, .position = along / 2, .angle = pi / 4, .mass = 1}, along);
  return problem_after(scene, 0);
}

}  // namespace

TEST_CASE("one joint is solved exactly in one sweep by its block, and row by row only in the limit") {
  for (const bool welded : {false, true}) {
    VelocityProblem<double> blocks = welded ? oblique_rods<WeldJoint>(1) : oblique_rods<RevoluteJoint>(1);
    VelocityProblem<double> rows = blocks;
    if (welded) {
      sweep_in_blocks<3>(blocks);
    } else {
      sweep_in_blocks<2>(blocks);
    }
    sweep_in_blocks<1>(rows);
    double of_blocks = 0, of_rows = 0;
    for (const ConstraintRow<double>& row : blocks.rows) {
      of_blocks = std::max(of_blocks, std::abs(row_velocity(blocks, row)));
      of_rows = std::max(of_rows, std::abs(row_velocity(rows, row)));
    }
    CHECK(of_blocks <= 1e-14);  // a few roundings of 1/6 m/s, times the condition of A
    CHECK(of_rows > 0.01);
  }
}

TEST_CASE("row by row is what the paper's solvers do") {
  VelocityProblem<double> by_hand = oblique_rods<WeldJoint>(4), by_solver = by_hand;
  for (int sweep = 0; sweep < 20; ++sweep) sweep_in_blocks<1>(by_hand);
  SequentialImpulse<double>({.iterations = 20}).solve(by_solver);
  CHECK(largest_gap(by_hand.velocity, by_solver.velocity) <= 64 * 21 * double_epsilon);
}

TEST_CASE(
    "blocks save 3/5 of the sweeps of a chain of pins at 45 degrees, which is what its direction costs") {
  // The slowest mode is tension. In its own direction a block answers with A = 2 / m; a row along x or y
  // turns the rods as well, by arms of L / 2 sin 45, and divides by 2 (1 / m + L^2 / 8 I) instead.
  const double inertia = (1 + 0.01) / 12;
  const double limit = 1 + 1 / (8 * inertia);  // 2.485
  const auto gain = [](int n) {
    const VelocityProblem<double> chain = oblique_rods<RevoluteJoint>(n);
    return sweeps_each<1>(chain, 8 * n * n) / sweeps_each<2>(chain, 8 * n * n);
  };
  const double four = gain(4), eight = gain(8);
  // What is left out is of order 1/n^2. Extrapolation leaves about the square of that.
  const double correction = four / limit - 1;
  CHECK(correction < 0.05);
  CHECK((4 * eight - four) / 3 == doctest::Approx(limit).epsilon(correction * correction));
}

TEST_CASE("blocks save almost no sweeps of a welded beam, and the less the longer it is") {
  // Its slowest mode is bending, for which A has nothing to couple within a joint but shear: of order 1/n^2.
  const auto gain = [](int n) {
    const VelocityProblem<double> beam = oblique_rods<WeldJoint>(n);
    const int sweeps = 2 * n * n * n * n;
    return sweeps_each<1>(beam, sweeps) / sweeps_each<3>(beam, sweeps) - 1;
  };
  const double three = gain(3), six = gain(6);
  CHECK(six > 0);
  CHECK(six < 0.07);
  CHECK(std::log2(three / six) >= 1.8);
  CHECK(std::log2(three / six) <= 2.2);
}
