// The two solvers of the paper do the same arithmetic in another order: their impulses agree sweep by sweep.
#include "../geometry/random_shapes.hpp"
#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

template <Scalar Real>
Vec3<Real> random_triple(test::Random& random, double reach) {
  const Vec2<double> xy = random.point(reach);
  return {static_cast<Real>(xy.x()), static_cast<Real>(xy.y()),
          static_cast<Real>(random.uniform(-reach, reach))};
}

template <Scalar Real>
ConstraintRow<Real> random_row(test::Random& random, int bodies) {
  ConstraintRow<Real> row;
  row.a = {random.below(bodies)};
  row.b = {(row.a.index + 1 + random.below(bodies - 1)) % bodies};
  row.jacobian_a = random_triple<Real>(random, 1);
  row.jacobian_b = random_triple<Real>(random, 1);
  row.bias = static_cast<Real>(random.uniform(-0.5, 0.5));
  return row;
}

/// Eight bodies, the ground among them, and 20 rows that mean nothing: half of them one-sided, and if
/// `friction` is positive with a friction row behind each of those.
template <Scalar Real>
VelocityProblem<Real> random_problem(double friction) {
  test::Random random(1);
  const int bodies = 8, rows = 20;
  VelocityProblem<Real> problem = empty_problem<Real>();
  while (problem.body_count() < bodies) {
    const Real mass = static_cast<Real>(random.uniform(0.5, 2));
    add_body<Real>(problem, mass, mass / 6, random_triple<Real>(random, 2));
  }
  for (int i = 0; i < rows; ++i) {
    ConstraintRow<Real> row = random_row<Real>(random, bodies);
    if (i % 2 == 1) row.bounds = Bounds<Real>::unilateral();
    const int normal = add_row(problem, row);
    if (!row.bounds.is_unilateral() || !(friction > 0)) continue;
    ConstraintRow<Real> sideways = random_row<Real>(random, bodies);
    sideways.bias = 0;
    sideways.bounds = Bounds<Real>::coulomb(static_cast<Real>(friction), normal);
    add_row(problem, sideways);
  }
  return problem;
}

/// Boxes on boxes, a bar on a pin, a ball on a rod that hits the boxes, and a few steps on: warm impulses
/// too.
template <Scalar Real>
VelocityProblem<Real> problem_of_a_scene() {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < 4; ++i)
    scene.add({.shapes = {box(1, 1)}, .position = {0.1 * i, 0.5 + i}, .angle = 0.01 * i});
  const BodyId bar = scene.add({.shapes = {box(2, 0.2)}, .position = {3, 3}, .velocity = {0, 1}});
  const BodyId ball = scene.add({.shapes = {circle(0.5)}, .position = {-1.1, 2.5}, .velocity = {3, 0}});
  scene.join<RevoluteJoint>({.a = ground, .b = bar, .anchor = {2, 3}});
  scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_a = {-1, 6}, .anchor_b = {-1.1, 2.5}});
  scene.join<DistanceJoint>({.a = bar, .b = ball, .anchor_a = {4, 3}, .anchor_b = {-1.1, 2.5}});
  World<Real> world(scene);
  SequentialImpulse<Real> solver;
  for (int step = 0; step < 12; ++step) world.step(solver);
  return world.velocity_problem();
}

/// How many impulses are at a bound: those of one-sided rows that are 0, and of friction rows at the cone.
template <Scalar Real>
int rows_at_bounds(const VelocityProblem<Real>& problem) {
  int count = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    const Bounds<Real>& bounds = problem.rows[i].bounds;
    const Real nudge = std::numeric_limits<Real>::epsilon();
    count += bounds.clamp(problem.impulse[i] + nudge, problem.impulse) <= problem.impulse[i] ||
             bounds.clamp(problem.impulse[i] - nudge, problem.impulse) >= problem.impulse[i];
  }
  return count;
}

template <Scalar Real>
void check_agreement(const VelocityProblem<Real>& start) {
  for (const int sweeps : {1, 2, 5, 50}) {
    CAPTURE(sweeps);
    VelocityProblem<Real> by_impulses = start, by_matrix = start;
    SequentialImpulse<Real>({.iterations = sweeps}).solve(by_impulses);
    ProjectedGaussSeidel<Real>({.iterations = sweeps}).solve(by_matrix);
    Real largest = 0;  // [N s]
    Real fastest = 0;  // [m/s]
    for (const Real impulse : by_impulses.impulse) largest = std::max(largest, std::abs(impulse));
    for (const Vec3<Real>& v : start.velocity) fastest = std::max(fastest, v.cwiseAbs().maxCoeff());
    // A row update is one sum of some 20 products; each sweep rounds it anew.
    const Real tolerance = 64 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + sweeps);
    for (int i = 0; i < start.impulse.size(); ++i) {
      CHECK(std::abs(by_impulses.impulse[i] - by_matrix.impulse[i]) <= tolerance * largest);
    }
    for (const BodyId body : start.velocity.indices()) {
      const Vec3<Real> gap = by_impulses.velocity[body] - by_matrix.velocity[body];
      CHECK(gap.cwiseAbs().maxCoeff() <= tolerance * fastest);
    }
    CHECK(rows_at_bounds(by_impulses) > 0);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("PGS and SI give the same impulses after every sweep on 20 random rows", Real, float,
                   double, long double) {
  check_agreement(random_problem<Real>(0));
}

TEST_CASE_TEMPLATE("PGS and SI give the same impulses with friction too", Real, float, double, long double) {
  check_agreement(random_problem<Real>(0.3));
}

TEST_CASE_TEMPLATE("PGS and SI give the same impulses for boxes, pins and rods in a world", Real, float,
                   double) {
  const VelocityProblem<Real> problem = problem_of_a_scene<Real>();
  CHECK(problem.row_count() >= 4 + 4 * 2);  // four of the joints, and friction behind every normal row
  check_agreement(problem);
}
