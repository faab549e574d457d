// Why the sum of impulses is clamped, and where effective masses are computed (paper 3.2 and 4.2).
#include <random>

#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double fall_of_one_step = 10.0 / 60;  // g dt [m/s]

/// Rows of every kind between four bodies, with numbers drawn from a fixed seed.
template <Scalar Real>
VelocityProblem<Real> tangle_of_rows() {
  std::mt19937 random(7);
  const auto number = [&random] { return Real(random() % 2001) / 1000 - 1; };
  VelocityProblem<Real> problem;
  problem.velocity = {Vec3<Real>::Zero()};
  problem.inverse_mass = {Vec3<Real>::Zero()};
  for (int body = 1; body <= 4; ++body) {
    problem.velocity.push_back({number(), number(), number()});
    problem.inverse_mass.push_back({2 + number(), 2 + number(), 2 + number()});
  }
  for (int i = 0; i < 12; ++i) {
    ConstraintRow<Real> row;
    row.a = {i % 4};
    row.b = {i % 4 + 1};
    row.jacobian_a = {number(), number(), number()};
    row.jacobian_b = {number(), number(), number()};
    row.bias = number();
    row.softness = i % 4 == 3 ? Real(0.1) : Real(0);
    if (i % 3 == 1) row.bounds = Bounds<Real>::unilateral();
    if (i % 3 == 2) row.bounds = Bounds<Real>::coulomb(Real(0.4), i - 1);
    problem.blocks.push_back({i, 1});
    problem.rows.push_back(row);
  }
  problem.impulse.assign(problem.rows.size(), Real(0));
  return problem;
}

/// After one step of falling, left and right of the middle.
VelocityProblem<double> box_on_two_feet(double foot) {
  return box_on_feet<double>({-foot, foot}, {0, -fall_of_one_step, 0});
}

}  // namespace

TEST_CASE("clamping increments throws a box with narrow feet up for ever; clamping sums carries it") {
  const double foot = 0.2;
  // By hand, impulses in units of m g dt. A_11 = A_22 = 1 + 6 foot^2, A_12 = 1 - 6 foot^2. The first foot
  // gives 1 / A_11; the second stops what is left of the fall, (1 - A_12 / A_11) / A_11. The first is now
  // lifted off by 6 foot^2 too much and should give some of it back, which an increment that is clamped
  // cannot do.
  const double A_11 = 1 + 6 * foot * foot, A_12 = 1 - 6 * foot * foot;
  const double sum = (2 - A_12 / A_11) / A_11;
  CHECK(sum == doctest::Approx(1.119).epsilon(0.001));
  for (const int sweeps : {1, 10, 1000}) {
    VelocityProblem<double> wrong = box_on_two_feet(foot);
    SequentialImpulse<double>({.iterations = sweeps}, {.clamp = Clamp::increment}).solve(wrong);
    CHECK((wrong.impulse[0] + wrong.impulse[1]) / fall_of_one_step == doctest::Approx(sum).epsilon(1e-13));
    CHECK(wrong.velocity[{1}].y() ==
          doctest::Approx((sum - 1) * fall_of_one_step).epsilon(1e-12));  // 0.0198 m/s
    // The second foot is at rest, v + foot omega = 0.
    CHECK(wrong.velocity[{1}].z() == doctest::Approx(-wrong.velocity[{1}].y() / foot).epsilon(1e-12));
  }
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> right = box_on_two_feet(foot);
    make({.iterations = 1000})->solve(right);
    for (const double impulse : right.impulse) {
      CHECK(impulse / fall_of_one_step == doctest::Approx(0.5).epsilon(1e-13));
    }
    CHECK(right.velocity[{1}].cwiseAbs().maxCoeff() <= 64 * double_epsilon);
  }
}

TEST_CASE("with feet at its corners a box does not show the mistake: test the narrow one") {
  // A_12 = 1 - 6 / 4 < 0: each foot presses the other down, and no impulse is ever too large.
  for (const Clamp clamp : {Clamp::accumulated, Clamp::increment}) {
    VelocityProblem<double> problem = box_on_two_feet(0.5);
    SequentialImpulse<double>({.iterations = 100}, {.clamp = clamp}).solve(problem);
    for (const double impulse : problem.impulse) {
      CHECK(impulse / fall_of_one_step == doctest::Approx(0.5).epsilon(1e-13));
    }
  }
}

TEST_CASE("a warm start that is twice too large is taken back by clamped sums, never by clamped increments") {
  VelocityProblem<double> warm = box_on_two_feet(0.2);
  warm.impulse = {fall_of_one_step, fall_of_one_step};
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = warm;
    make({.iterations = 1000})->solve(problem);
    CHECK(problem.velocity[{1}].cwiseAbs().maxCoeff() <= 64 * double_epsilon);
  }
  VelocityProblem<double> wrong = warm;
  SequentialImpulse<double>({.iterations = 1000}, {.clamp = Clamp::increment}).solve(wrong);
  CHECK(std::abs(wrong.velocity[{1}].y() - fall_of_one_step) <= 1e-15);
}

TEST_CASE_TEMPLATE("effective masses computed in the loop give the same bits as those computed before it",
                   Real, float, double, long double) {
  for (const int sweeps : {1, 2, 50}) {
    for (const double omega : {1.0, 1.3}) {
      VelocityProblem<Real> before = tangle_of_rows<Real>();
      VelocityProblem<Real> inside = before;
      const SolverSettings settings = {.iterations = sweeps, .relaxation = omega};
      SequentialImpulse<Real>(settings).solve(before);
      SequentialImpulse<Real>(settings, {.effective_mass = EffectiveMass::in_the_loop}).solve(inside);
      CHECK(before.impulse == inside.impulse);
      CHECK(before.velocity == inside.velocity);
      CHECK(std::abs(before.impulse[0]) > 0);
    }
  }
}
