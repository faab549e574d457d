// Newton's method as a solver for steps.
#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double speed_of_a_step = 10 * 0.02;  // [m/s] what a body gains in a step

/// Boxes of 1 kg with one of `top` kg on them.
VelocityProblem<double> loaded_stack(int boxes, double top) {
  VelocityProblem<double> problem = hand_made_stack<double>(boxes, 10, 0.02);
  problem.inverse_mass.back() = Vec3<double>(1 / top, 1 / top, 6 / top);
  return problem;
}

/// A box that is pushed along the ground on two feet, faster or slower than friction allows.
VelocityProblem<double> pushed_box(double speed) {
  return box_on_feet<double>({-0.5, 0.5}, {speed, -speed_of_a_step, 0}, 0.5);
}

}  // namespace

TEST_CASE("Newton's method carries every stack exactly, 100 boxes or a load of 1000 t, in a few systems") {
  struct Stack {
    int boxes;
    double top;  // [kg]
  };
  for (const Stack& stack : {Stack{1, 1}, Stack{10, 1}, Stack{100, 1}, Stack{10, 1e3}, Stack{10, 1e6}}) {
    CAPTURE(stack.boxes);
    CAPTURE(stack.top);
    VelocityProblem<double> problem = loaded_stack(stack.boxes, stack.top);
    // R_E is measured by what the lowest row lacks alone, and impulses are rounded as the load's are.
    const double tolerance = std::max(1e-12, 16 * std::numeric_limits<double>::epsilon() * stack.top);
    const SolveReport report =
        NewtonSolver<double>({.iterations = 30, .tolerance = tolerance}).solve(problem);
    CHECK(report.converged);
    // Row j carries the boxes above it: m g dt each.
    for (int j = 0; j < stack.boxes; ++j) {
      const double carried = (stack.boxes - 1 - j + stack.top) * speed_of_a_step;
      CHECK(problem.impulse[j] == doctest::Approx(carried).epsilon(1e-6));
    }
    // A sum over up to 100 rows of what R_E leaves of each, in velocities of the lowest row's size.
    for (const Vec3<double>& v : problem.velocity)
      CHECK(std::abs(v.y()) <= 100 * tolerance * speed_of_a_step);
  }
}

TEST_CASE("where the warm start is the answer, Newton's method solves no system and changes no impulse") {
  VelocityProblem<double> problem = loaded_stack(20, 100);
  const VelocityProblem<double> start = problem;
  NewtonSolver<double> solver({.iterations = 30, .tolerance = 1e-9});
  solver.solve(problem);
  VelocityProblem<double> again = start;
  again.impulse = problem.impulse;
  const SolveReport report = solver.solve(again);
  CHECK(report.iterations == 0);
  CHECK(report.converged);
  for (int i = 0; i < again.impulse.size(); ++i) {
    // Units are divided by and multiplied with: two roundings.
    CHECK(again.impulse[i] == doctest::Approx(problem.impulse[i]).epsilon(4e-16));
  }
}

TEST_CASE("Newton's method owns up to the sweeps that lead it on, and to what takes as long as some") {
  // To look at the warm start takes as long as three sweeps. At the limit of friction one linear system is
  // not enough, and the first failure is followed by 30.
  VelocityProblem<double> pushed = pushed_box(0.5 * speed_of_a_step);
  const SolveReport led = NewtonSolver<double>({.iterations = 1}).solve(pushed);
  CHECK(led.iterations == 1);
  CHECK(led.extra_sweeps >= 3 + 30);
  CHECK(led.extra_sweeps % 2 == 1);  // beside them steps by kept factors, each as long as two
  VelocityProblem<double> solved = loaded_stack(10, 1e3), again = solved;
  NewtonSolver<double>({.iterations = 50}).solve(solved);
  again.impulse = solved.impulse;
  const SolveReport warm = NewtonSolver<double>({.iterations = 50, .tolerance = 1e-9}).solve(again);
  CHECK(warm.iterations == 0);
  CHECK(warm.extra_sweeps == 3);
}

TEST_CASE("factors are kept: a problem like the last one needs steps by them, and no new system") {
  NewtonSolver<double> kept({.iterations = 30, .tolerance = 1e-9});
  VelocityProblem<double> last = loaded_stack(100, 1);
  CHECK(kept.solve(last).iterations > 0);
  VelocityProblem<double> next = loaded_stack(100, 1);
  for (Vec3<double>& velocity : next.velocity) velocity *= 1.5;
  VelocityProblem<double> by_new = next;
  const VelocityProblem<double> start = next;
  const SolveReport report = kept.solve(next);
  CHECK(report.converged);
  CHECK(report.iterations == 0);
  CHECK(NewtonSolver<double>({.iterations = 30, .tolerance = 1e-9}).solve(by_new).iterations > 0);
  CHECK(residual(next, exact_scale(start)).energy <= 1e-11);
  for (int i = 0; i < next.row_count(); ++i) CHECK(next.impulse[i] == doctest::Approx(by_new.impulse[i]));
  // Another number of bodies, and one with another mass: what was kept does not help, nor does it harm.
  for (const auto& [boxes, top] : {std::pair(10, 1.0), std::pair(100, 1e3)}) {
    VelocityProblem<double> other = loaded_stack(boxes, top);
    CHECK(kept.solve(other).converged);
    CHECK(other.impulse[0] == doctest::Approx((boxes - 1 + top) * speed_of_a_step).epsilon(1e-6));
  }
}

TEST_CASE("a stack that is solved again rises as its lowest row asks, soft or not, from whatever impulses") {
  const int boxes = 10;
  const double top = 50, mass = boxes - 1 + top, bias = 0.05;  // [kg], [kg], [m/s]
  for (const double softness : {0.0, 0.01}) {
    for (const double share : {1.0, 0.5}) {
      CAPTURE(softness);
      CAPTURE(share);
      const VelocityProblem<double> start = loaded_stack(boxes, top);
      VelocityProblem<double> problem = start;
      problem.number.renew();
      NewtonSolver<double> solver({.iterations = 30, .tolerance = 1e-12});
      solver.solve(problem);
      problem.velocity = start.velocity;
      problem.rows[0].bias = bias;
      problem.rows[0].softness = softness;
      for (double& impulse : problem.impulse) impulse *= share;
      CHECK(solver.solve(problem).converged);
      // v + gamma p = bias in the lowest row, for v = p / m - g dt of all boxes: the other rows are rigid.
      const double p = (speed_of_a_step + bias) * mass / (1 + softness * mass);
      for (int j = 0; j < boxes; ++j) {
        const double above = boxes - 1 - j + top;
        CHECK(problem.impulse[j] == doctest::Approx(above * p / mass).epsilon(1e-9));
        CHECK(problem.velocity[{j + 1}].y() == doctest::Approx(p / mass - speed_of_a_step).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("a tolerance that is looser than 1e-7 leaves no step more to do than 1e-7") {
  for (const double asked : {1e-3, 1e-1}) {
    VelocityProblem<double> loose = loaded_stack(50, 100), near = loose;
    const double scale = exact_scale(loose);
    NewtonSolver<double> solver({.iterations = 30, .tolerance = asked});
    NewtonSolver<double> other({.iterations = 30, .tolerance = 1e-7});
    solver.solve(loose);
    other.solve(near);
    CHECK(loose.impulse == near.impulse);
    CHECK(residual(loose, scale).energy <= 1e-9);
    // What was asked for is what is told of: without systems the start is 1 off.
    CHECK_FALSE(NewtonSolver<double>({.iterations = 0, .tolerance = asked})
                    .solve(loose = loaded_stack(50, 100))
                    .converged);
    loose = loaded_stack(50, 100);
    loose.impulse = near.impulse;
    loose.impulse[0] += 0.5 * asked * scale / std::sqrt(inverse_effective_mass(near, near.rows[0]));
    CHECK(NewtonSolver<double>({.iterations = 0, .tolerance = asked}).solve(loose).converged);
  }
}

TEST_CASE("Newton's method goes on to a hundredth of the tolerance, where it has to solve at all") {
  VelocityProblem<double> solved = loaded_stack(50, 100);
  const VelocityProblem<double> start = solved;
  NewtonSolver<double>({.iterations = 30, .tolerance = 1e-7}).solve(solved);
  const double scale = exact_scale(start);
  CHECK(residual(solved, scale).energy <= 1e-9);
  // Good enough for the tolerance, but not for a hundredth of it: solved. For that hundredth: left alone.
  for (const double off : {0.5e-6, 0.5e-8}) {
    VelocityProblem<double> near = start;
    near.impulse = solved.impulse;
    near.impulse[0] += off * scale / std::sqrt(inverse_effective_mass(start, start.rows[0]));
    const double before = near.impulse[0];
    CHECK(NewtonSolver<double>({.iterations = 30, .tolerance = 1e-7}).solve(near).converged);
    CHECK((near.impulse[0] == doctest::Approx(before).epsilon(4e-16)) == (off < 1e-9));
  }
}

TEST_CASE("what is solved again keeps its answer where that answers it too, from whatever warm start") {
  const VelocityProblem<double> start = loaded_stack(20, 100);
  VelocityProblem<double> problem = start;
  problem.number.renew();
  NewtonSolver<double> solver({.iterations = 30, .tolerance = 1e-9});
  solver.solve(problem);
  const PerRow<double> answer = problem.impulse;
  problem.velocity = start.velocity;
  problem.impulse = start.impulse;
  const SolveReport again = solver.solve(problem);
  CHECK(again.converged);
  CHECK(again.iterations == 0);
  CHECK(again.extra_sweeps == 3);  // to look
  CHECK(problem.impulse == answer);
}

TEST_CASE("Newton's method slides and sticks as Coulomb says") {
  const double weight = speed_of_a_step;  // [N s] of 1 kg
  for (const double speed : {0.01, 0.09, 0.2, 3.0}) {
    CAPTURE(speed);
    VelocityProblem<double> problem = pushed_box(speed);
    const VelocityProblem<double> start = problem;
    CHECK(NewtonSolver<double>({.iterations = 60, .tolerance = 1e-12}).solve(problem).converged);
    CHECK(problem.impulse[0] + problem.impulse[2] == doctest::Approx(weight).epsilon(1e-9));
    // It may take mu m g dt, and needs m v; the box turns with neither foot off the ground.
    const double friction = std::min(0.5 * weight, speed);
    CHECK(-(problem.impulse[1] + problem.impulse[3]) == doctest::Approx(friction).epsilon(1e-9));
    CHECK(residual(problem, exact_scale(start)).energy <= 1e-11);
  }
}

TEST_CASE("no number in, no number out: Newton's method comes back from a problem with a NaN") {
  VelocityProblem<double> problem = loaded_stack(3, 1);
  problem.velocity[{2}].y() = std::numeric_limits<double>::quiet_NaN();
  const SolveReport report = NewtonSolver<double>({.iterations = 30}).solve(problem);
  CHECK_FALSE(report.converged);
  CHECK(report.iterations == 0);
}

TEST_CASE_TEMPLATE("Newton's method gives the same bits for the same sequence of problems, in every scalar",
                   Real, float, double) {
  const VelocityProblem<Real> start = hand_made_stack<Real>(30, 10, Real(0.02));
  NewtonSolver<Real> one({.iterations = 20}), other({.iterations = 20});
  CHECK(one.memory() == 0);
  for (int solve = 0; solve < 3; ++solve) {
    VelocityProblem<Real> first = start, second = start;
    one.solve(first);
    other.solve(second);
    CHECK(first.impulse == second.impulse);
    // Of n (n + 1) / 2 boxes' weights in all, to the roundings of a float's answer.
    CHECK(static_cast<double>(first.impulse[0]) == doctest::Approx(30 * speed_of_a_step).epsilon(4e-7));
  }
  CHECK(one.memory() > 0);
}

TEST_CASE("without systems Newton's method applies the warm start, inside its bounds") {
  VelocityProblem<double> problem = hand_made_stack<double>(1, 10, 0.5);
  problem.impulse[0] = 2;
  const SolveReport report = NewtonSolver<double>({.iterations = 0}).solve(problem);
  CHECK(report.iterations == 0);
  CHECK(problem.velocity[{1}].y() == doctest::Approx(-5 + 2));
  CHECK_THROWS_AS(NewtonSolver<double>({.iterations = -1}), std::invalid_argument);
}

TEST_CASE("where all rests and no row asks for anything, Newton's method drops the warm start") {
  VelocityProblem<double> problem = loaded_stack(3, 10);
  for (Vec3<double>& v : problem.velocity) v.setZero();
  for (ConstraintRow<double>& row : problem.rows) row.bias = 0;
  problem.impulse.assign(problem.row_count(), 2);
  NewtonSolver<double>({.iterations = 20}).solve(problem);
  for (const double impulse : problem.impulse) CHECK(impulse == 0);
  for (const Vec3<double>& v : problem.velocity) CHECK(v.isZero(0));
}
