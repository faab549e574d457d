// Rows without units, a centre, and rows made soft around it.
#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double fall_of_a_step = 10 * 0.02;  // [m/s] what a body gains in a step

/// A box of 1 kg on one foot below its middle, with friction that is written before it or after it.
VelocityProblem<double> box_on_a_foot(double speed, bool friction_first) {
  VelocityProblem<double> problem;
  problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1, 1, 0)};
  problem.velocity = {Vec3<double>::Zero(), Vec3<double>(speed, -fall_of_a_step, 0)};
  const int normal = friction_first ? 1 : 0;
  problem.rows.resize(2);
  problem.rows[normal] = {.b = {1}, .jacobian_b = {0, 1, 0}, .bounds = Bounds<double>::unilateral()};
  problem.rows[1 - normal] = {
      .b = {1}, .jacobian_b = {1, 0, 0}, .bounds = Bounds<double>::coulomb(0.5, normal)};
  problem.impulse.assign(2, 0);
  return problem;
}

}  // namespace

TEST_CASE("rows in sqrt(J) measure R_E by the scale of exact problems") {
  for (const VelocityProblem<double>& problem :
       {hand_made_stack<double>(7, 10, 0.02), box_on_a_foot(3, false), box_on_a_foot(0, true)}) {
    ScaledRows<double> rows;
    rows.begin(problem);
    CHECK(rows.scale() == doctest::Approx(exact_scale(problem)).epsilon(1e-14));
  }
}

TEST_CASE("rows that limit others come before them, wherever they are written") {
  for (const bool friction_first : {false, true}) {
    ScaledRows<double> rows;
    rows.begin(box_on_a_foot(1, friction_first));
    List<int> order;
    rows.for_each_row([&](int i) { order.push_back(i); });
    CHECK(order == (friction_first ? List<int>{1, 0} : List<int>{0, 1}));
  }
}

TEST_CASE("a centre knows the velocities and the error of its impulses, inside their bounds") {
  const VelocityProblem<double> problem = box_on_a_foot(3, true);
  ScaledRows<double> rows;
  rows.begin(problem);
  ProximalCenter<double> center;
  PerRow<double> impulse = {-10, 0.1};  // friction beyond its limit 0.5 * 0.1
  center.go_to(rows, impulse);
  rows.copy_impulses(center.x(), impulse);
  CHECK(impulse[0] == doctest::Approx(-0.05));
  CHECK(impulse[1] == doctest::Approx(0.1));
  const Vec3<double> velocity = rows.velocity_of({1}, problem.velocity[{1}], center.u());
  CHECK(velocity.x() == doctest::Approx(3 - 0.05));
  CHECK(velocity.y() == doctest::Approx(0.1 - fall_of_a_step));
  // The foot lacks what the velocity says; friction is at its limit, and slides as it should.
  CHECK(center.error() == doctest::Approx(fall_of_a_step - 0.1));
}

TEST_CASE(
    "steps of Newton's method end where the velocities of soft rows call for the impulses that make them") {
  for (const double speed : {0.05, 3.0}) {
    for (const bool friction_first : {false, true}) {
      CAPTURE(speed);
      CAPTURE(friction_first);
      const double softness = 0.25;
      ScaledRows<double> rows;
      rows.begin(box_on_a_foot(speed, friction_first));
      ProximalCenter<double> center;
      center.go_to(rows, {0, 0});
      ProximalMap<double> map;
      map.soften(softness);
      NewtonSteps<double> steps;
      SlopeFactors factors;
      factors.begin();
      const NewtonSteps<double>::Place at = {rows, center, map};
      CHECK(steps.solve(at, 1e-12, 10, [&] {
        factors.factorize(rows, map, map.softness());
        Vector<double> change = map.value();
        factors.solve(change);
        return steps.shorten(at, change, 1.0 / 64);
      }));
      PerRow<double> impulse;
      rows.copy_impulses(map.x(), impulse);
      // p + softness p = what is asked for, with friction up to half of the foot's impulse.
      const double foot = fall_of_a_step / (1 + softness);
      const double friction = std::min(speed / (1 + softness), 0.5 * foot);
      CHECK(impulse[friction_first ? 1 : 0] == doctest::Approx(foot).epsilon(1e-11));
      CHECK(impulse[friction_first ? 0 : 1] == doctest::Approx(-friction).epsilon(1e-11));
    }
  }
}

TEST_CASE("beyond a proximal step lies the pull of a straight rope, which hardly moves what hangs in it") {
  const double slope = 1e-3;  // of both halves of a rope with 1 kg in its middle
  VelocityProblem<double> problem;
  problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1, 1, 0)};
  problem.velocity = {Vec3<double>::Zero(), Vec3<double>(0, -fall_of_a_step, 0)};
  for (const double side : {-1, 1}) problem.rows.push_back({.b = {1}, .jacobian_b = {side, slope, 0}});
  problem.impulse.assign(2, 0);
  ScaledRows<double> rows;
  rows.begin(problem);
  ProximalCenter<double> center;
  center.go_to(rows, problem.impulse);
  ProximalMap<double> map;
  map.soften(1e-3);  // both rows together have 2 slope^2, 500 times less
  Vector<double> du = Vector<double>::Zero(rows.freedoms());
  for (int step = 0; step < 2; ++step) {
    SlopeFactors factors;
    factors.begin();
    map.evaluate(rows, center, du);
    factors.factorize(rows, map, map.softness());
    Vector<double> change = map.value();
    factors.solve(change);
    du -= change;
  }
  map.evaluate(rows, center, du);
  center.go_to(rows, map.x(), map.response());
  PerRow<double> impulses;
  rows.copy_impulses(center.x(), impulses);
  const auto is_held = [&](int i) { return map.is_held(i); };
  const double pull = fall_of_a_step / (2 * slope);
  CHECK(impulses[0] < pull / 100);
  center.go_on(rows, is_held);
  rows.copy_impulses(center.x(), impulses);
  // Roundings of w', beside 2 slope^2 of it.
  for (const double impulse : impulses) CHECK(impulse == doctest::Approx(pull).epsilon(1e-9));
  // Nothing has led there now, so there is no way to go on.
  center.go_to(rows, problem.impulse);
  center.go_on(rows, is_held);
  CHECK(center.x()(0) == 0);
}
