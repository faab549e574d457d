// Coulomb friction where it has two answers, or one that sweeps never find.
#include "geometry/shape.hpp"
#include "problems.hpp"
#include "solvers/residual.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A box of 1 kg that fits tightly between two walls, each with one contact and its friction, after one step
/// of falling. Rows: normal and friction of the left wall, then of the right one. Up is along the tangents.
VelocityProblem<double> box_in_slot(double friction) {
  VelocityProblem<double> problem = empty_problem<double>();
  const BodyId slot_box = add_body<double>(problem, 1, 1.0 / 6, {0, -test_gravity * test_dt, 0});
  for (const double side : {-1.0, 1.0}) {
    ConstraintRow<double> normal;
    normal.b = slot_box;
    normal.jacobian_b = {-side, 0, 0};
    normal.bounds = Bounds<double>::unilateral();
    const int place = add_row(problem, normal);
    ConstraintRow<double> tangent = normal;
    tangent.jacobian_b = {0, 1, side / 2};
    tangent.bounds = Bounds<double>::coulomb(friction, place);
    add_row(problem, tangent);
  }
  return problem;
}

/// Of the rod below, by the arm (0.5 cos, -0.5 sin) with tan = 2 from its centre to its lower end and its
/// inertia 1/12: A_nn = 1 + 12 x^2, A_nt = 12 x y, A_tt = 1 + 12 y^2 [1/kg].
const double rod_nn = 1.6, rod_nt = 1.2, rod_tt = 3.4;
const double rod_fall = 0.01;  // [m/s] g dt

/// A uniform rod of 1 m and 1 kg, inclined by atan 2, on its lower end that slides along the floor
/// (P. Painleve, 1895). Its centre is on the left of that end and has the given speed to the right [m/s]:
/// friction turns the end out of the floor when the end goes to the left, and into it when it goes to the
/// right.
template <Scalar Real>
VelocityProblem<Real> painleve_rod(Real speed, Real friction) {
  VelocityProblem<Real> problem = empty_problem<Real>(Real(0.001));
  const Real x = Real(0.5) / std::sqrt(Real(5)), y = -2 * x;
  const BodyId rod = add_body<Real>(problem, 1, Real(1) / 12, {speed, -static_cast<Real>(rod_fall), 0});
  const int normal = add_row(problem, floor_row<Real>(rod, x));
  add_row(problem, floor_friction_row<Real>(rod, y, friction, normal));
  return problem;
}

/// The largest violation of any row by these impulses [m/s]: 0 for a solution.
double violation_by(VelocityProblem<double> problem, const std::vector<double>& impulse) {
  problem.impulse = impulse;
  for (std::size_t i = 0; i < impulse.size(); ++i) {
    apply_impulse(problem, problem.rows[i], impulse[i]);
  }
  return residual(problem, 1.0).velocity;
}

}  // namespace

// A10
TEST_CASE("a box in a tight slot has two answers, and where the impulses start decides between them") {
  const double mu = 0.5, weight = test_gravity * test_dt;
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> cold = box_in_slot(mu);
    make({.iterations = 50})->solve(cold);
    CHECK(cold.velocity[1] == Vec3<double>(0, -weight, 0));
    for (const double impulse : cold.impulse) CHECK(impulse == 0);
    CHECK(violation_by(box_in_slot(mu), cold.impulse) == 0);

    // Walls that press with m g dt / (2 mu) or more each can hold the box.
    for (const double press : {1.0, 1.5}) {
      VelocityProblem<double> warm = box_in_slot(mu);
      const double normal = press * weight / (2 * mu);
      warm.impulse = {normal, weight / 2, normal, weight / 2};
      make({.iterations = 50})->solve(warm);
      CHECK(warm.velocity[1].cwiseAbs().maxCoeff() <= 64 * double_epsilon);
      CHECK(warm.impulse[0] == doctest::Approx(normal).epsilon(1e-14));
      CHECK(warm.impulse[1] + warm.impulse[3] == doctest::Approx(weight).epsilon(1e-14));
      CHECK(violation_by(box_in_slot(mu), warm.impulse) <= 64 * double_epsilon);
    }
  }
}

// A10
TEST_CASE("a box in a slot that presses with less than m g dt / (2 mu) is slowed down, not held") {
  const double mu = 0.5, weight = test_gravity * test_dt;
  for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
    VelocityProblem<double> warm = box_in_slot(mu);
    const double normal = 0.6 * weight / (2 * mu);
    warm.impulse = {normal, 0, normal, 0};
    make({.iterations = 50})->solve(warm);
    CHECK(warm.velocity[1].y() == doctest::Approx(-weight + 2 * mu * normal).epsilon(1e-13));
  }
}

// A20, T12
TEST_CASE_TEMPLATE("a rod that drags its end swings about g dt / (A_nn + mu A_nt) by mu A_nt / A_nn a sweep",
                   Real, float, double, long double) {
  const Real fall = static_cast<Real>(rod_fall);
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    for (const Real mu : {Real(0.3), Real(1), Real(1.25)}) {
      const Real q = mu * static_cast<Real>(rod_nt) / static_cast<Real>(rod_nn);
      const Real answer = fall / (static_cast<Real>(rod_nn) * (1 + q));
      VelocityProblem<Real> problem = painleve_rod<Real>(-1, mu);
      ImpulseTrace<Real> trace;
      make({.iterations = 100})->solve(problem, &trace);
      Real power = 1;  // (-q)^k
      for (int k = 0; k <= 100; ++k, power *= -q) {
        const Real normal = trace.sweeps[static_cast<std::size_t>(k)][0];
        // Velocities of 1 m/s, rounded in every sweep.
        const Real tolerance = 64 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + k);
        CHECK(std::abs(normal - answer * (1 - power)) <= tolerance);
      }
    }
  }
}

// A20, T12
TEST_CASE("above mu = A_nn / A_nt = 4/3 there is an answer, and sweeps go round it in a circle of two") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {1.4, 2.0, 10.0}) {
      const VelocityProblem<double> start = painleve_rod<double>(-1, mu);
      const double answer = rod_fall / (rod_nn + mu * rod_nt);
      CHECK(violation_by(start, {answer, mu * answer}) <= 64 * double_epsilon);

      VelocityProblem<double> problem = start;
      ImpulseTrace<double> trace;
      const SolveReport report = make({.iterations = 1000, .patience = 3})->solve(problem, &trace);
      CHECK(report.stop == Stop::cycle);
      CHECK_FALSE(report.converged);
      CHECK(report.largest_change == doctest::Approx(rod_fall / rod_nn * std::max(mu, 1.0)).epsilon(1e-12));
      for (std::size_t k = 1; k < trace.sweeps.size(); ++k) {
        // Odd sweeps find no friction yet; even ones find too much of it.
        const double normal = k % 2 == 1 ? rod_fall / rod_nn : 0;
        CHECK(std::abs(trace.sweeps[k][0] - normal) <= 64 * double_epsilon);
        CHECK(std::abs(trace.sweeps[k][1] - mu * normal) <= 64 * double_epsilon * mu);
      }
      CHECK(violation_by(start, problem.impulse) >= 0.9 * rod_fall);
    }
  }
}

// T12
TEST_CASE("a relaxation below 2 / (1 + mu A_nt / A_nn) brings the circling rod to its answer") {
  const double mu = 2;
  const double answer = rod_fall / (rod_nn + mu * rod_nt);
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    // Each sweep leaves |1 - omega (1 + mu A_nt / A_nn)| = |1 - 2.5 omega| of the error: 0.75 of it at 0.7,
    // more than all of it at 0.85.
    for (const double relaxation : {0.3, 0.5, 0.7}) {
      VelocityProblem<double> problem = painleve_rod<double>(-1, mu);
      make({.iterations = 200, .relaxation = relaxation})->solve(problem);
      CHECK(std::abs(problem.impulse[0] - answer) <= 64 * double_epsilon);
    }
    VelocityProblem<double> problem = painleve_rod<double>(-1, mu);
    make({.iterations = 200, .relaxation = 0.85})->solve(problem);
    CHECK(std::abs(problem.impulse[0] - answer) > 0.1 * answer);
  }
}

// A20
TEST_CASE("a rod pushed against its end slides under g dt / (A_nn - mu A_nt), while friction is small") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {0.3, 0.9, 1.2}) {
      VelocityProblem<double> problem = painleve_rod<double>(1, mu);
      make({.iterations = 400})->solve(problem);  // (mu A_nt / A_nn)^400 = 0.9^400 = 5e-19
      // 1 / (1 - 0.9) roundings of 1 m/s.
      const double tolerance = 640 * double_epsilon;
      const double answer = rod_fall / (rod_nn - mu * rod_nt);
      CHECK(std::abs(problem.impulse[0] - answer) <= tolerance);
      CHECK(std::abs(problem.impulse[1] + mu * answer) <= tolerance * mu);
    }
  }
}

// A20
TEST_CASE("above mu = 4/3 a rod pushed against its end jams: an impact without a collision") {
  const double speed = 1;
  const double determinant = rod_nn * rod_tt - rod_nt * rod_nt;                 // 4
  const double normal = (rod_tt * rod_fall + rod_nt * speed) / determinant;     // 0.3085, not of order dt
  const double friction = -(rod_nn * speed + rod_nt * rod_fall) / determinant;  // -0.403
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {1.34, 1.4, 2.0, 1e6}) {
      VelocityProblem<double> problem = painleve_rod<double>(speed, mu);
      // First the impulses grow, by mu A_nt / A_nn or more a sweep; once the end sticks, the error shrinks to
      // A_nt^2 / (A_nn A_tt) = 0.26 of itself.
      const SolveReport report = make({.iterations = 20000, .patience = 3})->solve(problem);
      CHECK(report.stop == Stop::stalled);
      CHECK(std::abs(problem.impulse[0] - normal) <= 64 * double_epsilon);
      CHECK(std::abs(problem.impulse[1] - friction) <= 64 * double_epsilon);
    }
  }
}

// A20
TEST_CASE("a step of a world says that the rod's contact went in circles") {
  for (const double mu : {1.2, 1.45}) {
    const double angle = std::atan(2.0), thickness = 1e-6;
    Scene scene({.dt = 0.001});
    scene.add_ground({.friction = mu});
    const double height = (std::sin(angle) + thickness * std::cos(angle)) / 2;
    scene.add({.shapes = {box(1, thickness)},
               .position = {0, height},
               .angle = -angle,
               .velocity = {-1, 0},
               .mass = 1,
               .friction = mu});
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      World world(scene);
      const auto solver = make({.iterations = 5000, .patience = 3});
      const StepReport report = world.step(*solver);
      CHECK(report.solve.stop != Stop::sweeps);
      if (mu < 4.0 / 3) {  // it has come to rest, but for a circle of roundings
        CHECK(report.solve.largest_change <= 64 * double_epsilon);
      } else {
        CHECK(report.solve.stop == Stop::cycle);
        CHECK(report.solve.largest_change >= rod_fall / rod_nn);
      }
    }
  }
}
