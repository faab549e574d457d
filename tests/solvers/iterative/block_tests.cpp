// Joints solved as a whole: pins, welds, and what stands beside them in their blocks.
#include <Eigen/LU>

#include "solvers/solver_list.hpp"
#include <cairn/constraints/converted.hpp>
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Two free bodies with a pin at arms that lie oblique to both axes, held apart by a velocity and a bias;
/// `rows` = 3 welds them, 2 pins them.
template <Scalar Real>
VelocityProblem<Real> two_joined_bodies(int rows, Real inertia = Real(0.3)) {
  VelocityProblem<Real> problem;
  problem.velocity = {Vec3<Real>(1, Real(-0.5), 2), Vec3<Real>(-2, Real(0.25), -1)};
  problem.inverse_mass = {Vec3<Real>(1, 1, 1 / inertia), Vec3<Real>(Real(0.5), Real(0.5), Real(0.75))};
  const Vec2<Real> r_a = {Real(0.6), Real(0.8)};
  const Vec2<Real> r_b = {Real(-0.75), Real(-0.5)};
  const Vec3<Real> of_a[] = {{-1, 0, r_a.y()}, {0, -1, -r_a.x()}, {0, 0, -1}};
  const Vec3<Real> of_b[] = {{1, 0, -r_b.y()}, {0, 1, r_b.x()}, {0, 0, 1}};
  for (int i = 0; i < rows; ++i) {
    problem.rows.push_back({.a = {0}, .b = {1}, .jacobian_a = of_a[i], .jacobian_b = of_b[i]});
    problem.rows.back().bias = Real(0.125) * Real(i - 1);
  }
  problem.blocks = {{0, rows}};
  problem.impulse.assign(problem.rows.size(), Real(0));
  return problem;
}

/// `links` bodies of 1 kg in a line, `angle` below the horizontal, each joined to the one before it.
template <typename Joint>
VelocityProblem<double> line_of(int links, double angle) {
  Scene scene;
  const Vec2<double> along = {std::cos(angle), -std::sin(angle)};
  samples::add_chain<Joint>(
      scene, links, {.shapes = {box(1, 0.1)}, .position = along / 2, .angle = -angle, .mass = 1}, along);
  return problem_after(scene, 0);
}

/// Block Gauss-Seidel on A lambda = b with dense matrices: the impulses [N s] after so many sweeps.
PerRow<double> dense_block_gauss_seidel(const VelocityProblem<double>& problem, int sweeps) {
  const SystemMatrices<double> system = system_matrices(problem);
  Vector<double> lambda = Vector<double>::Zero(problem.row_count());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const RowBlock& block : problem.blocks) {
      const Vector<double> error = (system.b - system.A * lambda).segment(block.first, block.count);
      const Matrix<double> A_BB = system.A.block(block.first, block.first, block.count, block.count);
      lambda.segment(block.first, block.count) += A_BB.fullPivLu().solve(error);
    }
  }
  PerRow<double> impulse;
  for (int i = 0; i < problem.row_count(); ++i) impulse.push_back(lambda(i) * problem.dt);
  return impulse;
}

template <typename SolverType>
int sweeps_until(double tolerance, VelocityProblem<double> problem) {
  const SolveReport report = SolverType({.iterations = 100000, .tolerance = tolerance}).solve(problem);
  CHECK(report.converged);
  return report.iterations;
}

/// The largest energy that a body of 1 kg on a pin with an arm of 1 m has in ten seconds [J]; 0 is at rest at
/// the height of the pin. It is let go 0.5 rad from the lowest point, with 5 sweeps a step.
template <typename SolverType>
double largest_energy_of_pendulum(double inertia) {
  Scene scene({.stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const BodyId bob = scene.add(
      {.shapes = {circle(0.1)}, .position = {std::sin(0.5), -std::cos(0.5)}, .mass = 1, .inertia = inertia});
  scene.join<RevoluteJoint>({.a = ground, .b = bob, .anchor = {0, 0}});
  World world(scene);
  SolverType solver({.iterations = 5});
  double largest = -std::numeric_limits<double>::infinity();
  for (int step = 0; step < 600; ++step) {
    world.step(solver);
    largest = std::max(largest, total_energy(snapshot(world)));
  }
  return largest;
}

}  // namespace

TEST_CASE_TEMPLATE("one pin, one weld and one soft weld are satisfied after one sweep", Real, float, double) {
  for (const int rows : {2, 3}) {
    for (const Real softness : {Real(0), Real(0.5)}) {
      VelocityProblem<Real> problem = two_joined_bodies<Real>(rows);
      for (ConstraintRow<Real>& row : problem.rows) row.softness = softness;
      BlockSequentialImpulse<Real>({.iterations = 1}).solve(problem);
      for (int i = 0; i < problem.row_count(); ++i) {
        const ConstraintRow<Real>& row = problem.rows[i];
        const Real left = row_velocity(problem, row) + row.softness * problem.impulse[i] - row.bias;
        // Elimination leaves roundings of A times impulse: A is below 8 1/kg and impulses below 4 N s.
        CHECK(std::abs(left) <= 16 * std::numeric_limits<Real>::epsilon() * 32);
      }
    }
  }
}

TEST_CASE_TEMPLATE("two equality rows side by side are solved to the bits of a block of any size", Real,
                   float, double) {
  for (const Real softness : {Real(0), Real(0.5)}) {
    VelocityProblem<Real> problem = two_joined_bodies<Real>(2);
    for (ConstraintRow<Real>& row : problem.rows) row.softness = softness;
    BlockMatrix<Real> A = {};
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k < 2; ++k) {
        const Real entry = coupling(problem, problem.rows[i], problem.rows[k], problem.inverse_mass);
        A[i][k] = i == k ? entry + softness : entry;
      }
    }
    BlockFactor<Real> block;
    EqualityPair<Real> pair;
    REQUIRE(block.factorize(A, 2));
    REQUIRE(pair.begin(problem, 0, 1));
    BlockVector<Real> x = {Real(0.7), Real(-1.3)}, y = x;
    block.solve(x);
    pair.solve(y[0], y[1]);
    CHECK(x == y);
  }
}

TEST_CASE_TEMPLATE("whoever watches the rows of pins sees what they are without him", Real, float, double) {
  struct Watcher final : SolveObserver<Real> {
    bool watches_rows() const override { return true; }
  } watcher;
  for (const double relaxation : {1.0, 1.3}) {
    VelocityProblem<Real> watched = converted<Real>(line_of<RevoluteJoint>(7, 0.4)), alone = watched;
    BlockSequentialImpulse<Real> solver({.iterations = 5, .relaxation = relaxation});
    solver.solve(watched, &watcher);
    solver.solve(alone);
    CHECK(watched.impulse == alone.impulse);
    CHECK(watched.velocity == alone.velocity);
  }
}

TEST_CASE("two scalar rows of a pin shrink its error by A_xy^2 / (A_xx A_yy) a sweep, a block ends it") {
  for (const double inertia : {0.3, 0.01}) {
    const VelocityProblem<double> problem = two_joined_bodies<double>(2, inertia);
    const SystemMatrices<double> system = system_matrices(problem);
    const double rate = system.A(0, 1) * system.A(0, 1) / (system.A(0, 0) * system.A(1, 1));
    SweepRecorder<double> recorder;
    VelocityProblem<double> scalar = problem;
    SequentialImpulse<double>({.iterations = 5}).solve(scalar, &recorder);
    // Gauss-Seidel on two unknowns: from its first sweep on there is one error, and it shrinks by the rate.
    const double measured = recorder.sweeps()[5].residual_energy / recorder.sweeps()[4].residual_energy;
    CHECK(measured == doctest::Approx(rate).epsilon(1e-9));  // the error is still 1e-5 of the start at least
    VelocityProblem<double> block = problem;
    BlockSequentialImpulse<double>({.iterations = 1}).solve(block);
    CHECK(residual(block, residual_scale(problem)).energy <= 1e-12);  // A_xx / pivot is 1e2 at most: 1e2 eps
  }
}

TEST_CASE("a pin on an arm of 1 m with an inertia of 1e-6 explodes row by row, and swings as a block") {
  // Rate as above: 1 - 6e-6 a sweep, so that five sweeps a step change next to nothing, and warm starting
  // feeds the error back.
  CHECK(largest_energy_of_pendulum<SequentialImpulse<double>>(1e-6) > 1e10);
  CHECK(largest_energy_of_pendulum<SequentialImpulse<double>>(1e-4) > 1e10);
  for (const double inertia : {1e-4, 1e-6}) {
    // It started with -m g cos(0.5). While it swings, w <= w_0 = sqrt(2 g (1 - cos 0.5)) and a step of dt
    // leads off the circle by (w dt)^2 / 2 at most. Baumgarte pulls that back in 1 / beta steps: the stretch
    // is (w dt)^2 / (2 beta), and what it can lift is that times the pull m (g + w^2) of the pin. Besides,
    // the energy of semi-implicit Euler sways by m g w dt / 2 sin, as positions are half a step ahead.
    const double w_squared = 2 * 10 * (1 - std::cos(0.5));
    const double stretch = w_squared / (60 * 60) / (2 * 0.2);
    const double energy = largest_energy_of_pendulum<BlockSequentialImpulse<double>>(inertia);
    const double sway = 10 * std::sqrt(w_squared) / 60 / 2 * std::sin(0.5);
    CHECK(energy <= -10 * std::cos(0.5) + stretch * (10 + w_squared) + sway);
  }
}

TEST_CASE("impulses are those of block Gauss-Seidel on A lambda = b after every sweep") {
  for (const VelocityProblem<double>& start :
       {line_of<RevoluteJoint>(8, pi / 4), line_of<WeldJoint>(8, 0.3)}) {
    for (const int sweeps : {1, 2, 5, 50}) {
      const PerRow<double> expected = dense_block_gauss_seidel(start, sweeps);
      VelocityProblem<double> problem = start;
      BlockSequentialImpulse<double>({.iterations = sweeps}).solve(problem);
      for (int i = 0; i < expected.size(); ++i) {
        // 64 roundings a sweep of impulses below 2 N s, as for SI and PGS; blocks amplify by A_xx / pivot
        // < 4.
        const double tolerance = 4 * 64 * std::numeric_limits<double>::epsilon() * (1 + sweeps) * 2;
        CHECK(std::abs(problem.impulse[i] - expected[i]) <= tolerance);
      }
    }
  }
}

TEST_CASE("blocks help an oblique chain; where the rows of a pin do not couple, they change nothing") {
  // A_xy of a pin is the sum of -r_x r_y / I: 0 for level rods, so that row by row is block by block.
  using Blocks = BlockSequentialImpulse<double>;
  const VelocityProblem<double> level = line_of<RevoluteJoint>(10, 0);
  const VelocityProblem<double> oblique = line_of<RevoluteJoint>(10, pi / 4);
  for (const double tolerance : {1e-2, 1e-6}) {
    CHECK(sweeps_until<Blocks>(tolerance, level) ==
          sweeps_until<SequentialImpulse<double>>(tolerance, level));
    CHECK(sweeps_until<Blocks>(tolerance, oblique) <
          sweeps_until<SequentialImpulse<double>>(tolerance, oblique));
  }
}

TEST_CASE_TEMPLATE("rows that are alone in their blocks are those of SI, to the last bit", Real, float,
                   double) {
  const SolverSettings settings{.iterations = 30, .order = RowOrder::alternating, .relaxation = 1.2};
  VelocityProblem<Real> expected = hand_made_stack<Real>(10, 10, Real(0.02));
  VelocityProblem<Real> problem = expected;
  SequentialImpulse<Real>(settings).solve(expected);
  BlockSequentialImpulse<Real>(settings).solve(problem);
  CHECK(problem.impulse == expected.impulse);
}

TEST_CASE_TEMPLATE("redundant rows in a block are visited one by one: the bits of SI", Real, float, double) {
  VelocityProblem<Real> problem = two_joined_bodies<Real>(3);
  problem.rows.push_back(problem.rows[1]);  // four rows of rank three, with the same bias
  problem.blocks = {{0, 4}};
  problem.impulse.assign(4, Real(0));
  VelocityProblem<Real> expected = problem;
  SequentialImpulse<Real>({.iterations = 40}).solve(expected);
  BlockSequentialImpulse<Real>({.iterations = 40}).solve(problem);
  CHECK(problem.impulse == expected.impulse);
  for (const Real impulse : problem.impulse) CHECK(std::isfinite(impulse));
}

TEST_CASE("half the relaxation takes half of a block's error away") {
  const VelocityProblem<double> start = two_joined_bodies<double>(3);
  VelocityProblem<double> problem = start;
  BlockSequentialImpulse<double>({.iterations = 1, .relaxation = 0.5}).solve(problem);
  for (const ConstraintRow<double>& row : start.rows) {
    const double before = row_velocity(start, row) - row.bias;
    // Velocities of a few m/s, rounded a few dozen times.
    CHECK(std::abs(row_velocity(problem, row) - row.bias - before / 2) <= 1e-14);
  }
}

TEST_CASE("a pin between two immovable bodies does nothing and harms nothing") {
  VelocityProblem<double> problem = two_joined_bodies<double>(2);
  for (Vec3<double>& inverse : problem.inverse_mass) inverse.setZero();
  BlockSequentialImpulse<double>({.iterations = 3}).solve(problem);
  CHECK(problem.impulse == PerRow<double>{0, 0});
  CHECK(problem.velocity[{0}] == Vec3<double>(1, -0.5, 2));
}
