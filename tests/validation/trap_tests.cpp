// Mistakes that are easily made in a solver, each with the number that tells it from the right answer.
#include <algorithm>
#include <numeric>

#include "problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();

World<double> settled_stack(int boxes, Solver<double>& solver) {
  World<double> world(samples::stack(boxes));
  run(world, solver, 2);
  return world;
}

double largest_speed(const World<double>& world) {
  double largest = 0;
  for (const Vec3<double>& v : world.bodies().velocity) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

TEST_CASE("a velocity without gravity in it gives no impulse at all: v_1 must hold gravity") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> forgotten = stack<double>(3);
    for (Vec3<double>& v : forgotten.velocity) v.setZero();
    make({.iterations = 100})->solve(forgotten);
    for (const double impulse : forgotten.impulse) CHECK(impulse == 0);
  }
}

TEST_CASE("impulses that are not scaled with dt leave a stack falling by g times the change of dt") {
  const double shorter = 1.0 / 60, longer = 1.0 / 30;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double scale : {1.0, longer / shorter}) {
      VelocityProblem<double> problem = stack<double>(10);
      for (int j = 0; j < 10; ++j) {
        problem.impulse[j] = scale * (10 - j) * test_gravity * shorter;
        problem.velocity[{j + 1}] = {0, -test_gravity * longer, 0};
      }
      problem.dt = longer;
      make({.iterations = 0})->solve(problem);
      const double left = scale == 1 ? test_gravity * (longer - shorter) : 0;
      for (int i = 1; i <= 10; ++i) {
        CHECK(std::abs(problem.velocity[{i}].y() + left) <= 64 * double_epsilon);
      }
    }
  }
}

TEST_CASE("a settled stack stays at rest when dt changes from 1/60 s to 1/30 s and back") {
  // Where friction ties the boxes together, a digit costs about n^4 sweeps, 600 for five boxes: 2000 are
  // enough for every step to leave less than the one before.
  SequentialImpulse<double> solver({.iterations = 2000});
  World world = settled_stack(5, solver);
  CHECK(largest_speed(world) <= 1e-6 * test_gravity * test_dt);
  for (const double frequency : {60.0, 30.0, 60.0}) {
    world.set_dt(1 / frequency);
    take_steps(world, 1, 1);
    // Impulses that were not scaled would move the boxes by g (1/30 - 1/60) = 0.167 m/s.
    CHECK(largest_speed(world) <= 1e-6 * test_gravity * test_dt);
  }
}

TEST_CASE("a kinematic body moves others through j v, and nothing moves it") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = empty_problem<double>();
    problem.velocity.push_back({0, 3, 0});  // a lift: inverse mass 0, and a velocity
    problem.inverse_mass.push_back(Vec3<double>::Zero());
    const BodyId box = add_body<double>(problem, 2, 1, {0, 0, 0});
    add_row(problem, vertical_row<double>({1}, box, Bounds<double>::unilateral()));
    make({.iterations = 1})->solve(problem);
    CHECK(problem.velocity[{2}].y() == 3);
    CHECK(problem.velocity[{1}].y() == 3);
    CHECK(problem.impulse[0] == 2 * 3);
  }
}

TEST_CASE("a kinematic belt carries a box along, by friction up to mu g and never faster than itself") {
  Scene scene;
  const double mu = 0.5, speed = 2;
  const BodyId belt = scene.add({.type = BodyType::kinematic,
                                 .shapes = {box(40, 1)},
                                 .position = {0, -0.5},
                                 .velocity = {speed, 0},
                                 .material = {.friction = mu}});
  const BodyId load =
      scene.add({.shapes = {box(1, 0.5)}, .position = {0, 0.25}, .mass = 1, .material = {.friction = mu}});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 50});
  run(world, solver, 0.2);
  CHECK(velocity_of(world, load).x() == doctest::Approx(mu * test_gravity * 0.2).epsilon(1e-9));
  run(world, solver, 1);
  CHECK(velocity_of(world, load).x() == doctest::Approx(speed).epsilon(1e-9));
  CHECK(velocity_of(world, belt) == Vec3<double>(speed, 0, 0));
}

TEST_CASE("a row between two bodies that cannot move does nothing and harms nothing") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = stack<double>(1);
    problem.velocity.push_back({0, -3, 0});
    problem.inverse_mass.push_back(Vec3<double>::Zero());
    add_row(problem, vertical_row<double>(ground, {2}, Bounds<double>::unilateral()));
    add_row(problem, vertical_row<double>(ground, {2}, Bounds<double>::equality()));
    make({.iterations = 5})->solve(problem);
    CHECK(problem.impulse[0] == doctest::Approx(test_gravity * test_dt).epsilon(1e-15));
    CHECK(problem.impulse[1] == 0);
    CHECK(problem.impulse[2] == 0);
    CHECK(problem.velocity[{2}] == Vec3<double>(0, -3, 0));
  }
}

TEST_CASE("friction is given back when its contact lets go") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = empty_problem<double>();
    const BodyId box = add_body<double>(problem, 1, 1.0 / 6, {0, 1, 0});  // on its way up
    const int normal = add_row(problem, floor_row<double>(box, 0));
    add_row(problem, floor_friction_row<double>(box, 0, 0.5, normal));
    problem.impulse = {0.2, 0.1};  // of the step before
    make({.iterations = 1})->solve(problem);
    CHECK(problem.impulse[0] == 0);
    CHECK(problem.impulse[1] == 0);
    CHECK((problem.velocity[{1}] - Vec3<double>(0, 1, 0)).cwiseAbs().maxCoeff() <= 4 * double_epsilon);
  }
}

TEST_CASE("a NaN is still a NaN after clamping, so that it cannot hide") {
  const PerRow<double> impulse = {1, 1};
  CHECK(std::isnan(Bounds<double>::equality().clamp(quiet_nan, impulse)));
  CHECK(std::isnan(Bounds<double>::unilateral().clamp(quiet_nan, impulse)));
  CHECK(std::isnan(Bounds<double>::at_most(1).clamp(quiet_nan, impulse)));
  CHECK(std::isnan(Bounds<double>::coulomb(0.5, 0).clamp(quiet_nan, impulse)));
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> problem = stack<double>(2);
    problem.velocity[{1}].y() = quiet_nan;
    make({})->solve(problem);
    CHECK(std::isnan(problem.impulse[0]));
  }
}

TEST_CASE("impulses find their rows again when rows before them have gone, and new rows start from 0") {
  Scene scene;
  scene.add_ground();
  const BodyId ball = scene.add({.shapes = {circle(0.5)}, .position = {-3, 0.5}, .mass = 1});
  for (const double x : {0.0, 3.0}) scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5}, .mass = 2});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 20});
  run(world, solver, 0.5);
  const VelocityProblem<double> before = world.last_step().problem;
  world.set_velocity(ball, {0, 3, 0});
  run(world, solver, 0.1);  // the ball, whose rows came first, has left the margin
  const VelocityProblem<double> without = world.velocity_problem();
  CHECK(without.row_count() == before.row_count() - 2);
  for (int i = 0; i < without.row_count(); ++i) {
    CHECK(without.rows[i].key == before.rows[i + 2].key);
    CHECK(without.impulse[i] == doctest::Approx(before.impulse[i + 2]).epsilon(1e-9));
  }
  // It comes down after 0.6 s; watch it from then on until it touches.
  for (int step = 0; step < 60 && world.last_step().problem.row_count() < before.row_count(); ++step) {
    world.step(solver);
  }
  REQUIRE(world.last_step().problem.row_count() == before.row_count());
  CHECK(world.last_step().is_new[0] == 1);
  CHECK(world.last_step().is_new[1] == 1);
  for (int i = 2; i < before.row_count(); ++i) CHECK(world.last_step().is_new[i] == 0);
}
