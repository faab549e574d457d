// Rows on the way through the interior of their bounds.
#include <cairn/samples/samples.hpp>
#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double weight = 10 * 0.02;  // [N s] of 1 kg in a step

/// A box of 1 kg on two feet, with mu = 0.5, that slides at a speed and is pressed down, or pulled up.
VelocityProblem<double> box_on_two_feet(double speed, double fall) {
  return box_on_feet<double>({-0.5, 0.5}, {speed, -fall, 0}, 0.5, 0);
}

/// Impulses after so many steps, each of which asks for a tenth of the product.
PerRow<double> impulses_after(const VelocityProblem<double>& problem, int steps) {
  ScaledRows<double> rows;
  rows.begin(problem);
  ProximalCenter<double> center;
  center.go_to(rows, problem.impulse);
  InteriorRows interior;
  REQUIRE(interior.begin(rows, center, center.error_of_a_row()));
  SlopeFactors factors;
  factors.begin();
  Vector<double> change;
  PerRow<double> impulse;
  for (int step = 0; step < steps; ++step) {
    interior.linearize(rows, center.error_of_a_row());
    factors.factorize(rows, interior, 0.0);
    const double target = interior.mean_product(0) / 10;
    interior.find_direction(rows, target, change, [&] { factors.solve(change); });
    interior.go(rows, std::min(1.0, 0.9 * interior.longest_step()));
    rows.copy_impulses(interior.x(), impulse);
    center.go_to(rows, impulse);
  }
  return impulse;
}

}  // namespace

TEST_CASE(
    "through the interior a box finds Coulomb's friction, sliding or not, and lets go where it leaves") {
  for (const double speed : {-3.0, -0.2, 0.02, 0.09, 3.0}) {
    CAPTURE(speed);
    const PerRow<double> impulse = impulses_after(box_on_two_feet(speed, weight), 60);
    CHECK(impulse[0] + impulse[2] == doctest::Approx(weight).epsilon(1e-7));
    const double friction = std::min(0.5 * weight, std::abs(speed));
    CHECK(-(impulse[1] + impulse[3]) == doctest::Approx(std::copysign(friction, speed)).epsilon(1e-7));
  }
  for (const double part : impulses_after(box_on_two_feet(1, -weight), 60)) CHECK(std::abs(part) <= 1e-9);
}

TEST_CASE("equalities go through the interior beside rows with bounds") {
  VelocityProblem<double> problem = box_on_two_feet(0.5, weight);
  problem.rows[1].bounds = problem.rows[3].bounds = Bounds<double>::equality();  // feet that never slide
  const PerRow<double> impulse = impulses_after(problem, 60);
  CHECK(impulse[0] + impulse[2] == doctest::Approx(weight).epsilon(1e-7));
  CHECK(impulse[1] + impulse[3] == doctest::Approx(-0.5).epsilon(1e-7));
}

TEST_CASE("upper bounds have a way through the interior; rows with two bounds, or all without, have none") {
  VelocityProblem<double> problem = box_on_two_feet(0, weight);
  problem.rows.resize(1);
  problem.blocks = {{0, 1}};
  problem.impulse.assign(1, 0);
  problem.rows[0].jacobian_b = {0, 1, 0};
  problem.rows[0].bounds = {.upper = 0.1 * weight};
  CHECK(impulses_after(problem, 60)[0] == doctest::Approx(0.1 * weight).epsilon(1e-7));
  for (const Bounds<double>& bounds : {Bounds<double>::at_most(0.1 * weight), Bounds<double>::equality()}) {
    problem.rows[0].bounds = bounds;
    ScaledRows<double> rows;
    rows.begin(problem);
    List<InteriorMember> members;
    CHECK_FALSE(find_interior_members(rows, members));
  }
}

TEST_CASE("a contact goes through the interior with its friction, wherever both stand among the rows") {
  VelocityProblem<double> problem = box_on_two_feet(1, weight);
  std::swap(problem.rows[0], problem.rows[3]);  // the friction of the second foot, and the first foot
  problem.rows[0].bounds.normal_row = 2;
  problem.rows[1].bounds.normal_row = 3;
  ScaledRows<double> rows;
  rows.begin(problem);
  List<InteriorMember> members;
  REQUIRE(find_interior_members(rows, members));
  REQUIRE(members.size() == 2);
  CHECK(members[0].row == 2);
  CHECK(members[0].friction == 0);
  CHECK(members[1].row == 3);
  CHECK(members[1].friction == 1);
  // mu in sqrt(J): A_ii are 1 + 6 / 4 of a foot and 1 of its friction.
  for (const auto& member : members) CHECK(member.ratio == doctest::Approx(0.5 / std::sqrt(2.5)));
  problem.rows[1].bounds.normal_row = 2;  // two frictions of one contact
  rows.begin(problem);
  CHECK_FALSE(find_interior_members(rows, members));
}

TEST_CASE("a ball that hits a pyramid leaves no step of Newton's method without its answer") {
  Scene scene = samples::pyramid({.base = 6, .pitch = 1.01});
  scene.add({.shapes = {circle(1)}, .position = {0.3, 7.5}, .velocity = {0, -10}, .mass = 300});
  World<double> world(scene);
  NewtonSolver<double> solver({.iterations = 60, .tolerance = 1e-9});
  for (int step = 0; step < 30; ++step) CHECK(world.step(solver).solve.converged);
}
