// Bodies that a solve leaves going through each other are stopped; nothing else is touched.
#include <doctest/doctest.h>

#include <limits>

#include "geometry/shape.hpp"
#include "math/list.hpp"
#include "solvers/impulse_energy.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/last_word.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// The ground, and so many bodies one above the other that cannot turn, each with a normal row to the one
/// below.
VelocityProblem<double> falling_column(const List<double>& masses, const List<double>& speeds) {
  VelocityProblem<double> problem;
  problem.dt = 1;
  problem.inverse_mass.push_back(Vec3<double>::Zero());
  problem.velocity.push_back(Vec3<double>::Zero());
  for (int i = 0; i < masses.size(); ++i) {
    problem.inverse_mass.push_back({1 / masses[i], 1 / masses[i], 0});
    problem.velocity.push_back({0, speeds[i], 0});
    problem.rows.push_back({.a = BodyId{i},
                            .b = BodyId{i + 1},
                            .jacobian_a = {0, -1, 0},
                            .jacobian_b = {0, 1, 0},
                            .bounds = Bounds<double>::unilateral()});
  }
  problem.impulse.assign(masses.size(), 0);
  return problem;
}

List<ContactLimit<double>> limits_from_the_top(int rows) {
  List<ContactLimit<double>> limits;
  for (int row = rows - 1; row >= 0; --row) limits.push_back({row, 0, 0.1});
  return limits;
}

double column_energy(const VelocityProblem<double>& problem) {
  double energy = 0;
  for (const BodyId body : problem.velocity.indices()) {
    if (body == ground) continue;
    const double v = problem.velocity[body].y();
    energy += v * v / (2 * problem.inverse_mass[body].y());
  }
  return energy;
}

}  // namespace

TEST_CASE("a column that falls on the ground is stopped from the ground up, whatever weighs on what") {
  VelocityProblem<double> problem = falling_column({1, 1e6, 1e-3, 1e3}, {-1, -2, -3, -4});
  keep_bodies_apart(problem, limits_from_the_top(4), problem.velocity);
  for (const Vec3<double>& velocity : problem.velocity) CHECK(velocity.isZero(0));  // v - v, exactly
}

TEST_CASE("what rises from below is stopped, and throws nothing that is above it") {
  VelocityProblem<double> problem = falling_column({1, 1e6}, {5, -2});
  const double before = column_energy(problem);
  keep_bodies_apart(problem, limits_from_the_top(2), problem.velocity);
  CHECK(problem.velocity[{1}].y() == 0);
  CHECK(problem.velocity[{2}].y() == 0);
  CHECK(column_energy(problem) <= before);
  // A lift moves by itself: it takes what stands on it along.
  VelocityProblem<double> lift = falling_column({1}, {0});
  lift.velocity[ground].y() = 3;
  keep_bodies_apart(lift, limits_from_the_top(1), lift.velocity);
  CHECK(lift.velocity[{1}].y() == 3);
}

TEST_CASE("in free space two bodies that approach go on with their common momentum") {
  VelocityProblem<double> problem = falling_column({1, 3}, {4, 0});
  problem.inverse_mass[ground].setConstant(1);
  problem.rows.erase(problem.rows.begin());  // between the first body and what was the ground
  keep_bodies_apart(problem, {{0, 0, 0.1}}, problem.velocity);
  CHECK(problem.velocity[{1}].y() == doctest::Approx(1));
  CHECK(problem.velocity[{2}].y() == doctest::Approx(1));
}

TEST_CASE("too deep is deeper than before and deeper than allowed, at the end of the step") {
  VelocityProblem<double> problem = falling_column({1}, {-1});  // 1 m in a step
  CHECK(goes_too_deep(problem, {0, 0.0, 0.5}, problem.velocity));
  CHECK_FALSE(goes_too_deep(problem, {0, 0.6, 0.5}, problem.velocity));
  CHECK_FALSE(goes_too_deep(problem, {0, 0.0, 1.5}, problem.velocity));
  problem.velocity[{1}].y() = 1;
  CHECK_FALSE(goes_too_deep(problem, {0, -2.0, 0.5}, problem.velocity));
}

TEST_CASE("a heavy box on a light one does not press it through the ground, and the report says so") {
  Scene scene({.guarded = true});
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 1});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 1.5}, .mass = 1e6});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 10});
  int kept_apart = 0;
  for (int step = 0; step < 180; ++step) kept_apart += world.step(solver).kept_apart;
  CHECK(kept_apart > 0);
  CHECK(world.bodies().pose[{1}].position.y() > 0.2);  // at most a quarter of it is in the ground
  CHECK(world.bodies().pose[{2}].position.y() > 0.2);
}

TEST_CASE("a stack that its solver carries is left alone") {
  Scene scene({.guarded = true});
  scene.add_ground();
  for (int i = 0; i < 5; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 10});
  for (int step = 0; step < 180; ++step) CHECK(world.step(solver).kept_apart == 0);
}

TEST_CASE("impulses to start from are limited by a hundred times all that there is to move") {
  VelocityProblem<double> problem = falling_column({2, 1}, {-3, 4});  // 6 and 4 N s
  problem.impulse = {500, 999};
  limit_impulses(problem);
  CHECK(problem.impulse[0] == 500);
  CHECK(problem.impulse[1] == 999);
  problem.impulse = {500, 1e9};
  limit_impulses(problem);
  CHECK(problem.impulse[0] == 500);
  CHECK(problem.impulse[1] == doctest::Approx(1000));
  // A spring holds what it holds, and what it pushes may be pushed back by.
  problem.rows[0].softness = 1;
  problem.impulse = {500, 1e9};
  limit_impulses(problem);
  CHECK(problem.impulse[0] == 500);
  CHECK(problem.impulse[1] == doctest::Approx(100 * (10 + 500)));
}
