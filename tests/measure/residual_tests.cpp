// The residual of problems whose answer can be written down.
#include "../validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A sliding box on two feet with friction, and a rod from its middle to the ground: all kinds of rows.
VelocityProblem<double> sliding_box() {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId box = add_body<double>(problem, 1, 1.0 / 6, {2, -test_gravity * test_dt, 0.5});
  for (const double x : {-0.5, 0.5}) {
    const int normal = add_row(problem, floor_row(box, x));
    add_row(problem, floor_friction_row(box, -0.5, 0.3, normal));
  }
  ConstraintRow<double> rod = vertical_row<double>(ground, box, Bounds<double>::equality());
  rod.jacobian_a = {-0.6, -0.8, 0};
  rod.jacobian_b = {0.6, 0.8, 0.1};
  rod.bias = 0.05;
  add_row(problem, rod);
  return problem;
}

/// Gives every body the impulses that the problem holds.
void apply_all(VelocityProblem<double>& problem) {
  for (int i = 0; i < problem.row_count(); ++i) apply_impulse(problem, problem.rows[i], problem.impulse[i]);
}

/// The same rows in other units: row i times the i-th factor, so that its impulse is divided by it. A
/// friction row keeps its normal row's factor, or its bound would have another meaning.
VelocityProblem<double> in_other_units(VelocityProblem<double> problem, const PerRow<double>& factors) {
  for (int i = 0; i < problem.row_count(); ++i) {
    problem.rows[i].jacobian_a *= factors[i];
    problem.rows[i].jacobian_b *= factors[i];
    problem.rows[i].bias *= factors[i];
    problem.rows[i].softness *= factors[i] * factors[i];
    problem.impulse[i] /= factors[i];
  }
  return problem;
}

}  // namespace

TEST_CASE("the residual is 1 with no impulses at all") {
  for (const VelocityProblem<double>& problem : {stack<double>(5), free_chain(5)}) {
    const Residual<double> left = residual(problem, residual_scale(problem));
    CHECK(left.energy == doctest::Approx(1).epsilon(4 * double_epsilon));
  }
}

TEST_CASE("the residual is 0 at the solution, and its velocity is what the eye sees before") {
  VelocityProblem<double> problem = stack<double>(3);
  const double scale = residual_scale(problem);
  const double fall = test_gravity * test_dt;
  // Only the lowest box hits something: the others fall along with it, and their rows ask for nothing.
  CHECK(residual(problem, scale).velocity == doctest::Approx(fall));
  CHECK(residual(problem, scale).velocity_normal == residual(problem, scale).velocity);
  CHECK(residual(problem, scale).velocity_equality == 0);
  problem.impulse = {3 * fall, 2 * fall, fall};
  apply_all(problem);
  CHECK(residual(problem, scale).energy <= 8 * double_epsilon);
  CHECK(residual(problem, scale).velocity <= 8 * double_epsilon * fall);
}

TEST_CASE("an impulse that pulls is a residual, even where the velocity is right") {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId ball = add_body<double>(problem, 2, 1, {0, 3, 0});
  add_row(problem, floor_row<double>(ball, 0));
  const double scale = std::sqrt(2.0) * 3;      // [sqrt(J)] of its kinetic energy
  CHECK(residual(problem, scale).energy == 0);  // it leaves, and nothing holds it
  problem.impulse[0] = -6;                      // glue
  apply_all(problem);
  CHECK(problem.velocity[{1}].y() == 0);
  // e = -6 - max(-6 - 0, 0) = -6 N s, of which 1/2 A e^2 with A = 1/2 is all of its energy.
  CHECK(residual(problem, scale).energy == doctest::Approx(1).epsilon(4 * double_epsilon));
  CHECK(residual(problem, scale).velocity == 3);
}

TEST_CASE("the residual of friction is judged against the cone at the normal impulse as it is") {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId box = add_body<double>(problem, 1, 1, {4, 0, 0});
  add_row(problem, floor_row<double>(box, 0));
  add_row(problem, floor_friction_row<double>(box, 0, 0.5, 0));
  problem.impulse = {2, -1};  // on the cone, against a sliding of 4 m/s: nothing more to ask for
  CHECK(residual(problem, 1.0).velocity_friction == 0);
  problem.impulse = {2, -0.25};  // 0.75 N s are missing, at 1 kg
  CHECK(residual(problem, 1.0).velocity_friction == 0.75);
  CHECK(residual(problem, 1.0).velocity_normal == 0);
}

TEST_CASE("the scale of the residual is the energy of all rows but friction, at impulse 0") {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId first = add_body<double>(problem, 2, 1, {50, -3, 0});
  const BodyId second = add_body<double>(problem, 1, 1, {0, 4, 0});
  const int normal = add_row(problem, floor_row<double>(first, 0));     // wants 3 m/s at 2 kg
  add_row(problem, floor_friction_row<double>(first, 0, 0.5, normal));  // 50 m/s, and does not count
  add_row(problem, floor_row<double>(second, 0));                       // leaves by itself: wants nothing
  add_row(problem, vertical_row<double>(ground, second, Bounds<double>::equality()));  // wants 4 m/s at 1 kg
  CHECK(residual_scale(problem) ==
        doctest::Approx(std::sqrt(2 * 9.0 + 1 * 16.0)).epsilon(8 * double_epsilon));
}

TEST_CASE("the residual does not change when rows are written in other units") {
  VelocityProblem<double> problem = sliding_box();
  problem.rows[4].softness = 0.25;
  problem.impulse = {0.05, 0.01, 0.1, -0.02, 0.03};
  const PerRow<double> factors = {10, 10, 0.001, 0.001, 77};
  const VelocityProblem<double> other = in_other_units(problem, factors);
  CHECK(residual_scale(other) == doctest::Approx(residual_scale(problem)).epsilon(64 * double_epsilon));
  const double scale = residual_scale(problem);
  apply_all(problem);
  VelocityProblem<double> moved = other;
  apply_all(moved);
  CHECK(residual(moved, scale).energy ==
        doctest::Approx(residual(problem, scale).energy).epsilon(64 * double_epsilon));
}

TEST_CASE("a problem with nothing to do has a residual of 0, not a quotient of round-offs") {
  VelocityProblem<double> problem = free_chain(3);
  for (Vec3<double>& v : problem.velocity) v = {0.1, 0.2, 0.3};
  problem.velocity[ground].setZero();
  problem.velocity[{2}].y() += 2 * double_epsilon;
  const double scale = residual_scale(problem);
  CHECK(scale > 0);
  CHECK(residual(problem, scale).energy <= 1e-3);
  for (Vec3<double>& v : problem.velocity) v.setZero();
  CHECK(residual(problem, residual_scale(problem)).energy == 0);
}
