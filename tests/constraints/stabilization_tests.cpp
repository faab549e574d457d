// How fast errors go: the biases of rows, and what a world does with them.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "constraints/distance_joint.hpp"
#include "constraints/stabilization.hpp"
#include "geometry/shape.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// A row between the ground and body 1 along y, with body 1 at velocity v.
RowSpec<double> row_along_y(double error, const Bounds<double>& bounds, double rebound = 0) {
  RowSpec<double> spec;
  spec.b = {1};
  spec.error = error;
  spec.jacobian_a = {0, -1, 0};
  spec.jacobian_b = {0, 1, 0};
  spec.bounds = bounds;
  spec.rebound = rebound;
  return spec;
}

PerBody<Vec3<double>> moving_at(double v) { return {Vec3<double>::Zero(), Vec3<double>(0, v, 0)}; }

const Stabilization quarter_and_eighth = {.baumgarte = 0.25, .slop = 0.125};  // powers of two: exact results
const double half_second = 0.5;                                               // [s]

double bias_of(const RowSpec<double>& spec, double v = 0) {
  return bias_velocity(spec, quarter_and_eighth, StabilizationPass::velocity, half_second, moving_at(v));
}

}  // namespace

TEST_CASE("an equality asks for a share beta of its error to go in one step, in either direction") {
  const Bounds<double> bounds = Bounds<double>::equality();
  CHECK(bias_of(row_along_y(2, bounds)) == -0.25 * 2 / half_second);
  CHECK(bias_of(row_along_y(-2, bounds)) == 0.25 * 2 / half_second);
  CHECK(bias_of(row_along_y(0, bounds)) == 0);
}

TEST_CASE("an inequality may use up the room that it has, and no more") {
  CHECK(bias_of(row_along_y(2, Bounds<double>::unilateral())) == -2 / half_second);
  CHECK(bias_of(row_along_y(0, Bounds<double>::unilateral())) == 0);
}

TEST_CASE("an overlap within the slop is left alone, and of the rest beta goes in one step") {
  CHECK(bias_of(row_along_y(-0.125, Bounds<double>::unilateral())) == 0);
  CHECK(bias_of(row_along_y(-0.0625, Bounds<double>::unilateral())) == 0);
  CHECK(bias_of(row_along_y(-1.125, Bounds<double>::unilateral())) == 0.25 * 1 / half_second);
}

TEST_CASE("a rebound counts where the bodies would meet within the step, as far as it is the faster") {
  const Bounds<double> bounds = Bounds<double>::unilateral();
  CHECK(bias_of(row_along_y(1, bounds, 3), -4) == 3);  // 1 m away at 4 m/s: they meet in 0.25 s
  CHECK(bias_of(row_along_y(1, bounds, 3), -1) == -1 / half_second);  // in 1 s: not in this step
  CHECK(bias_of(row_along_y(1, bounds, 3), 4) == -1 / half_second);   // they part
  const double push = 0.25 * (81 - 0.125) / half_second;              // deep overlap: stabilization is faster
  CHECK(bias_of(row_along_y(-81, bounds, 3), -4) == push);
}

TEST_CASE("a friction row asks for no sliding, whatever the contact's error") {
  CHECK(bias_of(row_along_y(0, Bounds<double>::coulomb(0.5, 0)), 7) == 0);
}

TEST_CASE("a stabilized row is its spec with a bias, a key, and its normal row found in the problem") {
  const RowSpec<double> spec = row_along_y(0, Bounds<double>::coulomb(0.5, 2));
  VelocityProblem<double> problem;
  problem.dt = half_second;
  problem.velocity = moving_at(0);
  problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1, 1, 1)};
  ConstraintRow<double> row;
  const BodyState<double> begin = {{}, problem.velocity, problem.inverse_mass};
  stabilize_row(spec, quarter_and_eighth, StabilizationPass::velocity, begin, problem, 17, 10, row);
  CHECK(row.bounds.normal_row == 12);
  CHECK(row.bounds.friction == 0.5);
  CHECK(row.key == RowKey{17, spec.part});
  CHECK(row.softness == 0);
  CHECK(row.jacobian_b == spec.jacobian_b);
}

TEST_CASE("a stretched rod loses a share beta of its error in every step") {
  for (const double beta : {0.0, 0.1, 0.2, 1.0}) {
    Scene scene(
        {.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta}});
    const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = {3, 0}, .mass = 2});
    const double length = 2.5;
    scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_b = {3, 0}, .length = length});
    World world(scene);
    SequentialImpulse<double> solver({.iterations = 1});  // one row: solved in one sweep
    for (int k = 1; k <= 40; ++k) {
      world.step(solver);
      const double error = world.bodies().pose[{1}].position.x() - length;
      // Rounding of 3 m in each step.
      const double tolerance = 4 * std::numeric_limits<double>::epsilon() * 3 * k;
      CHECK(std::abs(error - 0.5 * std::pow(1 - beta, k)) <= tolerance);
    }
  }
}

TEST_CASE("two overlapping bodies part until the slop is left, by a share beta in every step") {
  const double depth = 0.1, slop = 0.01, beta = 0.2;
  Scene scene({.gravity = {0, 0}, 
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta, .slop = slop},
               .warm_start = false});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5 - depth}, .mass = 1});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 1});
  world.step(solver);
  const double left = depth - (world.bodies().pose[{1}].position.y() - (0.5 - depth));
  CHECK(left - slop == doctest::Approx((1 - beta) * (depth - slop)).epsilon(1e-12));
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(beta * (depth - slop) * 60).epsilon(1e-12));
}
