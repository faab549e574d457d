// Small problems of contacts, all solutions of which are known.
#include <cairn/solvers/exact/contact_modes.hpp>

#include <limits>

#include "validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double modes_fall = test_gravity * test_dt;  // [m/s] of one step

/// The rod of Painleve, whose end moves by `slide` along the floor and by `lift` off it [m/s].
VelocityProblem<double> leaning_rod(double slide, double lift, double friction) {
  VelocityProblem<double> problem = cases::painleve_rod<double>(slide, friction);
  problem.velocity.back().y() = lift;
  return problem;
}

/// A box on three points of the floor, in a line below it; without friction.
VelocityProblem<double> box_on_three_points() {
  return box_on_feet<double>({-0.5, 0, 0.5}, {0, -modes_fall, 0});
}

const double modes_rounding = 64 * double_epsilon;  // of a few products of numbers about 1

}  // namespace

TEST_CASE("c contacts with friction have 4^c modes, and too many are not begun with") {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId body = add_body<double>(problem, 1, 1, {0, -1, 0});
  int expected = 1;
  for (int c = 1; c <= 6; ++c) {
    const int normal = add_row(problem, floor_row<double>(body, 0.1 * c));
    add_row(problem, floor_friction_row<double>(body, -0.5, 0.5, normal));
    expected *= 4;
    if (c > 3) continue;  // enough to see
    const ContactSolutions<double> all = all_contact_solutions(problem);
    CHECK(all.complete);
    CHECK(all.modes == expected);
    CHECK_FALSE(all_contact_solutions(problem, expected - 1).complete);
  }
  CHECK_FALSE(all_contact_solutions(problem, expected - 1).complete);
}

// A10
TEST_CASE("a box in a tight slot falls or is held: both are found, and that walls may press at will") {
  const ContactSolutions<double> all = all_contact_solutions(cases::box_in_slot(0.5));
  REQUIRE(all.complete);
  REQUIRE(all.solutions.size() == 2);
  const ContactSolution<double>& falls = all.solutions[0];
  const ContactSolution<double>& holds = all.solutions[1];
  CHECK(falls.velocity[{1}] == Vec3<double>(0, -modes_fall, 0));
  for (const double impulse : falls.impulse) CHECK(impulse == 0);
  CHECK(falls.unique_impulse);
  // Sliding walls that press with 0 to m g dt / (2 mu) brake it: a family of velocities, from falling on.
  CHECK(falls.in_family);
  CHECK(holds.velocity[{1}].cwiseAbs().maxCoeff() <= modes_rounding);
  CHECK(holds.impulse[0] >= modes_fall - modes_rounding);  // m g dt / (2 mu) at least
  CHECK(holds.impulse[0] == doctest::Approx(holds.impulse[2]).epsilon(1e-14));
  CHECK(holds.impulse[1] + holds.impulse[3] == doctest::Approx(modes_fall).epsilon(1e-14));
  CHECK_FALSE(holds.unique_impulse);
  for (const ContactSolution<double>& solution : all.solutions) CHECK(solution.residual <= 1e-15);
}

// A20
TEST_CASE("a rod whose end slides so that friction lifts it has one answer, g dt / (A_nn + mu A_nt)") {
  for (const double mu : {0.3, 1.0, 1.4, 10.0}) {
    const ContactSolutions<double> all = all_contact_solutions(leaning_rod(-1, -0.01, mu));
    REQUIRE(all.solutions.size() == 1);
    CHECK(all.solutions[0].impulse[0] == doctest::Approx(0.01 / (1.6 + 1.2 * mu)).epsilon(1e-13));
    CHECK(all.solutions[0].impulse[1] == doctest::Approx(mu * 0.01 / (1.6 + 1.2 * mu)).epsilon(1e-13));
    CHECK(all.solutions[0].unique_impulse);
    CHECK_FALSE(all.solutions[0].in_family);
    CHECK(all.solutions[0].residual <= 1e-15);
  }
}

// A20
TEST_CASE(
    "above mu = 4/3 a rod that is dragged into the floor stops at once, by the same impulse for any mu") {
  for (const double mu : {1.4, 2.0, 10.0}) {
    const ContactSolutions<double> all = all_contact_solutions(leaning_rod(1, -0.01, mu));
    REQUIRE(all.solutions.size() == 1);
    // (A_tt g dt + |A_nt| v_t) / (A_nn A_tt - A_nt^2)
    const double normal = (3.4 * 0.01 + 1.2 * 1) / (1.6 * 3.4 - 1.2 * 1.2);
    CHECK(all.solutions[0].impulse[0] == doctest::Approx(normal).epsilon(1e-13));
    CHECK(all.solutions[0].residual <= 1e-15);
  }
}

// A20
TEST_CASE("above mu = 4/3 a rod whose end is dragged and leaves the floor has three answers") {
  const double mu = 2, lift = 0.01;
  const ContactSolutions<double> all = all_contact_solutions(leaning_rod(1, lift, mu));
  REQUIRE(all.solutions.size() == 3);
  CHECK(all.solutions[0].impulse[0] == 0);  // open
  // Stick: (-A_tt v_n + |A_nt| v_t) / det; slip: 0 = v_n + (A_nn - mu |A_nt|) normal.
  const double stick = (-3.4 * lift + 1.2) / (1.6 * 3.4 - 1.2 * 1.2), slip = lift / (mu * 1.2 - 1.6);
  CHECK(all.solutions[1].impulse[0] == doctest::Approx(stick).epsilon(1e-13));
  CHECK(all.solutions[2].impulse[0] == doctest::Approx(slip).epsilon(1e-13));
  for (const ContactSolution<double>& solution : all.solutions) {
    CHECK(solution.residual <= 1e-15);
    CHECK(solution.unique_impulse);
  }
}

// A9
TEST_CASE("a box on three points stands still in one way only, but the points can share its weight") {
  const ContactSolutions<double> all = all_contact_solutions(box_on_three_points());
  REQUIRE(all.complete);
  REQUIRE(all.solutions.size() == 1);
  const ContactSolution<double>& rest = all.solutions[0];
  CHECK(rest.velocity[{1}].cwiseAbs().maxCoeff() <= modes_rounding);
  CHECK(rest.impulse[0] + rest.impulse[1] + rest.impulse[2] == doctest::Approx(modes_fall).epsilon(1e-14));
  CHECK_FALSE(rest.unique_impulse);
  CHECK_FALSE(rest.in_family);
}

TEST_CASE("two points below a box share its weight in one way, and a soft third one makes that one way too") {
  VelocityProblem<double> problem = box_on_three_points();
  problem.rows[1].softness = 0.5;
  const ContactSolutions<double> all = all_contact_solutions(problem);
  REQUIRE(all.solutions.size() == 1);
  // The rigid points keep the box still: w = 0.5 impulse >= 0 is 0 there without impulse.
  CHECK(all.solutions[0].impulse[0] == doctest::Approx(modes_fall / 2).epsilon(1e-14));
  CHECK(std::abs(all.solutions[0].impulse[1]) <= modes_rounding);
  CHECK(all.solutions[0].unique_impulse);
}

TEST_CASE("points that fall apart have no solution, and the list of all says so") {
  // A box between a floor that rises and a ceiling that does not: v >= 1 and -v >= 0.
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId body = add_body<double>(problem, 1, 1, {0, 0, 0});
  ConstraintRow<double> floor = floor_row<double>(body, 0);
  floor.bias = 1;
  add_row(problem, floor);
  ConstraintRow<double> ceiling = floor_row<double>(body, 0);
  ceiling.jacobian_b = {0, -1, 0};
  add_row(problem, ceiling);
  const ContactSolutions<double> all = all_contact_solutions(problem);
  CHECK(all.complete);
  CHECK(all.solutions.empty());
}

TEST_CASE_TEMPLATE("solutions are rounded to the scalar asked for, and no further", Real, float, double,
                   long double) {
  VelocityProblem<Real> problem = stack<Real>(3);
  const ContactSolutions<Real> all = all_contact_solutions(problem);
  REQUIRE(all.solutions.size() == 1);
  const Real weight = -problem.velocity[{1}].y();  // m g dt of one box
  for (int j = 0; j < 3; ++j) {
    CHECK(std::abs(all.solutions[0].impulse[j] - Real(3 - j) * weight) <=
          4 * std::numeric_limits<Real>::epsilon() * weight * 3);
  }
}
