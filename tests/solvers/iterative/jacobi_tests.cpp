// Jacobi's method against its closed forms: how fast, when not at all, and what damping changes (paper 4.4).
#include <numeric>

#include "validation/problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double weight_dt = 6;  // [N s] m g dt of the box on three feet: 30 kg, 10 m/s^2, 0.02 s

/// A box of 1 m and 30 kg that has fallen for one step, on feet under its middle and 0.25 m to each side.
/// A_ii is (1 + 3/8) / m at the outer feet and 1 / m in the middle.
template <Scalar Real>
VelocityProblem<Real> box_on_three_feet() {
  VelocityProblem<Real> problem = empty_problem<Real>(Real(0.02));
  const BodyId box = add_body<Real>(problem, 30, 5, {0, Real(-2) / 10, 0});
  for (const Real x : {Real(-0.25), Real(0), Real(0.25)}) add_row(problem, floor_row<Real>(box, x));
  return problem;
}

VelocityProblem<double> glued(VelocityProblem<double> problem) {
  for (ConstraintRow<double>& row : problem.rows) row.bounds = Bounds<double>::equality();
  return problem;
}

/// A box of 1 kg on so many feet, evenly spread under its 1 m.
VelocityProblem<double> box_on_even_feet(int feet) {
  List<double> places;
  for (int i = 0; i < feet; ++i) places.push_back(-0.5 + i / (feet - 1.0));
  return box_on_feet<double>(places, {0, -test_gravity * test_dt, 0});
}

template <Scalar Real>
Real sum_of(const PerRow<Real>& impulses) {
  return std::accumulate(impulses.begin(), impulses.end(), Real(0));
}

}  // namespace

TEST_CASE_TEMPLATE("Jacobi passes a weight on by one box a sweep: (10, 0, 0), (10, 5, 0), (15, 5, 2.5)", Real,
                   float, double) {
  VelocityProblem<Real> problem = hand_made_stack<Real>(3, 10, 1);  // m g dt = 10 N s
  ImpulseTrace<Real> trace;
  Jacobi<Real>({.iterations = 3}).solve(problem, &trace);
  CHECK(trace.sweeps[1] == PerRow<Real>{10, 0, 0});
  CHECK(trace.sweeps[2] == PerRow<Real>{10, 5, 0});
  CHECK(trace.sweeps[3] == PerRow<Real>{15, 5, Real(2.5)});
}

TEST_CASE_TEMPLATE("a box on three feet: plain Jacobi flips for ever between 27/11 of its weight and nothing",
                   Real, float, double) {
  VelocityProblem<Real> problem = box_on_three_feet<Real>();
  ImpulseTrace<Real> trace;
  Jacobi<Real>({.iterations = 1000}).solve(problem, &trace);
  const Real tolerance = 64 * std::numeric_limits<Real>::epsilon() * Real(weight_dt);
  for (int k = 1; k < trace.sweeps.size(); ++k) {
    // Every foot takes the whole weight for itself: m g dt (8/11 + 1 + 8/11). Then all of them let go.
    const Real expected = k % 2 == 1 ? Real(weight_dt) * 27 / 11 : Real(0);
    CHECK(std::abs(sum_of(trace.sweeps[k]) - expected) <= tolerance);
  }
  CHECK(weight_dt * 27 / 11 == doctest::Approx(14.73).epsilon(0.005 / 14.73));  // as lessons print it
  problem = box_on_three_feet<Real>();
  CHECK(Jacobi<Real>({.iterations = 1000, .patience = 10}).solve(problem).stop == Stop::cycle);
}

TEST_CASE("glued to three feet, the box leaves for ever: the spectral radius is 16/11") {
  VelocityProblem<double> problem = glued(box_on_three_feet<double>());
  ImpulseTrace<double> trace;
  Jacobi<double>({.iterations = 40}).solve(problem, &trace);
  double power = 1;  // (-16/11)^k
  for (int k = 0; k < trace.sweeps.size(); ++k, power *= -16.0 / 11) {
    const double tolerance = 64 * double_epsilon * static_cast<double>(1 + k) * std::abs(power) * weight_dt;
    CHECK(std::abs(sum_of(trace.sweeps[k]) - weight_dt * (1 - power)) <= tolerance);
  }
}

TEST_CASE("a share omega of every correction leaves 1 - 27/11 omega of the error: 1/2 and 1/3 converge") {
  for (const double omega : {0.1, 1.0 / 3, 0.5, 0.75}) {
    VelocityProblem<double> problem = box_on_three_feet<double>();
    ImpulseTrace<double> trace;
    Jacobi<double>({.iterations = 200, .relaxation = omega}).solve(problem, &trace);
    for (int k = 0; k < trace.sweeps.size(); ++k) {
      const double left = std::pow(1 - omega * 27 / 11, static_cast<double>(k));
      CHECK(std::abs(sum_of(trace.sweeps[k]) - weight_dt * (1 - left)) <= 64 * double_epsilon * weight_dt);
    }
    // What a lesson prints after five sweeps.
    if (omega == 0.5) CHECK(sum_of(trace.sweeps[5]) == doctest::Approx(6.004).epsilon(0.0005 / 6));
    if (omega < 0.4 && omega > 0.3)
      CHECK(sum_of(trace.sweeps[5]) == doctest::Approx(5.9988).epsilon(0.00005 / 6));
  }
}

TEST_CASE("omega = 1 / feet converges for any number of feet; plain Jacobi stops at three, far apart") {
  for (int feet = 2; feet <= 12; ++feet) {
    CAPTURE(feet);
    const double scale = residual_scale(box_on_even_feet(feet));
    VelocityProblem<double> damped = box_on_even_feet(feet), plain = damped;
    // All feet ask for the same speed, and answer it with so much of it: the sum of 1 / (1 + 6 x^2).
    double answer = 0;
    for (const ConstraintRow<double>& row : plain.rows) {
      answer += 1 / inverse_effective_mass(plain, row);
    }
    CHECK((answer < 2) == (feet <= 3));
    Jacobi<double>({.iterations = 2000, .relaxation = 1.0 / feet}).solve(damped);
    CHECK(residual(damped, scale).energy <= 1e-12);
    Jacobi<double>({.iterations = 2000}).solve(plain);
    CHECK((residual(plain, scale).energy <= 1e-12) == (answer < 2));
  }
}

TEST_CASE("on one body, splitting the mass in n parts is damping by 1 / n") {
  for (int feet = 2; feet <= 12; ++feet) {
    VelocityProblem<double> split = box_on_even_feet(feet), damped = split;
    Jacobi<double>({.iterations = 30}, Splitting::mass).solve(split);
    Jacobi<double>({.iterations = 30, .relaxation = 1.0 / feet}).solve(damped);
    for (int i = 0; i < split.impulse.size(); ++i) {
      CHECK(std::abs(split.impulse[i] - damped.impulse[i]) <=
            64 * 31 * double_epsilon * test_gravity * test_dt);
    }
  }
}

TEST_CASE("with split masses three feet leave 1 - 9/11 omega of the error: every omega below 2 converges") {
  for (const double omega : {0.5, 1.0, 1.5, 1.99}) {
    VelocityProblem<double> problem = glued(box_on_three_feet<double>());
    ImpulseTrace<double> trace;
    Jacobi<double>({.iterations = 100, .relaxation = omega}, Splitting::mass).solve(problem, &trace);
    for (int k = 0; k < trace.sweeps.size(); ++k) {
      const double left = std::pow(1 - omega * 9 / 11, static_cast<double>(k));
      CHECK(std::abs(sum_of(trace.sweeps[k]) - weight_dt * (1 - left)) <= 64 * double_epsilon * weight_dt);
    }
  }
}

TEST_CASE("on symmetric feet Jacobi's impulses are symmetric to the last bit, and Gauss-Seidel's are not") {
  VelocityProblem<double> problem = box_on_three_feet<double>(), sequential = problem;
  Jacobi<double>({.iterations = 2}, Splitting::mass).solve(problem);
  CHECK(problem.impulse[0] == problem.impulse[2]);
  SequentialImpulse<double>({.iterations = 2}).solve(sequential);
  CHECK(std::abs(sequential.impulse[0] - sequential.impulse[2]) > 0.1);
}

TEST_CASE("friction is bounded by the normal impulse of the sweep's beginning") {
  const double friction = 0.25;
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId box = add_body<double>(problem, 1, 1.0 / 6, {5, -test_gravity * test_dt, 0});
  add_row(problem, floor_row<double>(box, 0));
  add_row(problem, floor_friction_row<double>(box, -0.5, friction, 0));
  ImpulseTrace<double> trace;
  Jacobi<double>({.iterations = 3}).solve(problem, &trace);
  const double weight = test_gravity * test_dt;
  CHECK(trace.sweeps[1] == PerRow<double>{weight, 0});
  // 5 m/s would need more than mu m g dt to stop: the bound is reached, one sweep late.
  CHECK(trace.sweeps[2][1] == doctest::Approx(-friction * weight));
  CHECK(trace.sweeps[3][1] == doctest::Approx(-friction * weight));
}

TEST_CASE("Jacobi keeps two numbers a row and a count a body, and has a name for each splitting") {
  VelocityProblem<double> problem = stack<double>(7);
  Jacobi<double> plain({.iterations = 1}), split({.iterations = 1}, Splitting::mass);
  CHECK(plain.memory() == 0);
  plain.solve(problem);
  CHECK(plain.memory() == 2 * 7 * sizeof(double) + 8 * sizeof(int));
  CHECK(plain.name() == "Jacobi");
  CHECK(split.name() == "mass-splitting Jacobi");
  CHECK_THROWS_AS(Jacobi<double>({.relaxation = 2.0}), std::invalid_argument);
}
