// One step that decides everything: sliding feet, impacts, rows in a line.
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Discs of radius 0.5 m and mass 1 kg in a row, touching, without gravity; the first moves to the right at 1
/// m/s.
Scene row_of_discs(int n) {
  Scene scene({.gravity = {0, 0}, .restitution_threshold = 0});
  for (int i = 0; i < n; ++i) {
    scene.add({.shapes = {circle(0.5)},
               .position = {static_cast<double>(i), 0},
               .velocity = {i == 0 ? 1.0 : 0.0, 0},
               .mass = 1,
               .friction = 0,
               .restitution = 1});
  }
  return scene;
}

struct Bounce {
  double speed = 0;  // [m/s] to the right
  double spin = 0;   // [rad/s]
  double rise = 0;   // [m/s]
};

/// A disc of radius R that comes down at v_n with u to the right and no spin (R. Garwin's bouncing ball).
Bounce expected_bounce(double u, double v_n, double mu, double e, double radius) {
  const double friction = mu * (1 + e) * v_n;  // [m/s] the most that friction can change
  const double change = std::min(u / 3, friction);
  return {.speed = u - change, .spin = -2 * change / radius, .rise = e * v_n};
}

}  // namespace

// A11
TEST_CASE("a sliding box of half width b and centre height h leans on its front foot by mu h / b") {
  const double b = 1, h = 0.5;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double mu : {0.0, 0.1, 0.4}) {
      VelocityProblem<double> problem = empty_problem<double>();
      const double fall = test_gravity * test_dt;
      const BodyId box = add_body<double>(problem, 1, (4 * b * b + 4 * h * h) / 12, {5, -fall, 0});
      for (const double x : {-b, b}) {
        const int normal = add_row(problem, floor_row(box, x));
        add_row(problem, floor_friction_row(box, -h, mu, normal));
      }
      make({.iterations = 1000})->solve(problem);
      // The two normal rows shrink each other's error to less than half a sweep; what is left is rounding.
      CHECK(problem.impulse[0] == doctest::Approx(fall / 2 * (1 - mu * h / b)).epsilon(1e-12));
      CHECK(problem.impulse[2] == doctest::Approx(fall / 2 * (1 + mu * h / b)).epsilon(1e-12));
      CHECK(problem.impulse[1] == doctest::Approx(-mu * problem.impulse[0]));
      CHECK(problem.impulse[3] == doctest::Approx(-mu * problem.impulse[2]));
    }
  }
}

// A11
TEST_CASE(
    "a box that slides through a world has 0.6 of its weight on the front foot and 0.4 on the rear one") {
  Scene scene;
  scene.add_ground({.friction = 0.4});
  const BodyId box_body = scene.add(
      {.shapes = {box(2, 1)}, .position = {0, 0.5}, .velocity = {5, 0}, .mass = 1, .friction = 0.4});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 100});
  run(world, solver, 0.5);
  const Snapshot now = snapshot(world);
  REQUIRE(now.contacts.size() == 2);
  const double x = pose_of(world, box_body).position.x();
  for (const SnapshotContact& contact : now.contacts) {
    const double share = contact.position.x() > x ? 0.6 : 0.4;
    CHECK(contact.normal_impulse == doctest::Approx(share * test_gravity * test_dt).epsilon(1e-9));
  }
}

// A12
TEST_CASE("an elastic disc that hits a row of n at rest gives each 2 / n of its speed and keeps 2 / n - 1") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const int n : {2, 3, 5}) {
      World world(row_of_discs(n));
      // cos^2(pi / n) a sweep: for n = 5 that is 0.65, and 0.65^200 = 1e-37 leaves rounding only.
      const auto solver = make({.iterations = 200});
      world.step(*solver);
      double energy = 0;
      for (int i = 0; i < n; ++i) {
        const double expected = i == 0 ? 2.0 / n - 1 : 2.0 / n;
        const double speed = velocity_of(world, {i + 1}).x();
        CHECK(std::abs(speed - expected) <= 64 * double_epsilon / (1 - 0.655));
        energy += speed * speed;
      }
      CHECK(energy == doctest::Approx(1).epsilon(1e-12));
    }
  }
}

// A14
TEST_CASE(
    "a disc that hits the ground without spin rolls off when |u| <= 3 mu (1 + e) v_n, and slips otherwise") {
  const double v_n = 4, mu = 0.5, e = 0.5, radius = 0.4;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double u : {3.0, 6.0, 12.0}) {
      VelocityProblem<double> problem = empty_problem<double>();
      const BodyId disc = add_body<double>(problem, 2, 2 * radius * radius / 2, {u, -v_n, 0});
      ConstraintRow<double> normal = floor_row<double>(disc, 0);
      normal.bias = e * v_n;
      const int place = add_row(problem, normal);
      add_row(problem, floor_friction_row(disc, -radius, mu, place));
      make({.iterations = 1})->solve(problem);  // the rows do not act on each other: one sweep is enough
      const Bounce expected = expected_bounce(u, v_n, mu, e, radius);
      CHECK(problem.velocity[1].x() == doctest::Approx(expected.speed).epsilon(1e-14));
      CHECK(problem.velocity[1].y() == doctest::Approx(expected.rise).epsilon(1e-14));
      CHECK(problem.velocity[1].z() == doctest::Approx(expected.spin).epsilon(1e-14));
    }
  }
}

// A14
TEST_CASE("in a world a disc bounces off the ground with the speed and spin of the one-step algebra") {
  const double v_n = 4, mu = 0.5, e = 0.5, radius = 0.4;
  for (const double u : {3.0, 6.0, 12.0, -12.0}) {
    Scene scene({.gravity = {0, 0}});
    scene.add_ground({.friction = mu});
    // It touches where the step begins: a gap C would change the arm of friction to R + C / 2.
    const BodyId disc = scene.add({.shapes = {circle(radius)},
                                   .position = {0, radius},
                                   .velocity = {u, -v_n},
                                   .friction = mu,
                                   .restitution = e});
    World world(scene);
    SequentialImpulse<double> solver;
    run(world, solver, 0.25);  // it leaves in the first step, and flies on
    const Bounce expected = expected_bounce(std::abs(u), v_n, mu, e, radius);
    const double side = u > 0 ? 1 : -1;
    CHECK(velocity_of(world, disc).x() == doctest::Approx(side * expected.speed).epsilon(1e-12));
    CHECK(velocity_of(world, disc).y() == doctest::Approx(expected.rise).epsilon(1e-12));
    CHECK(velocity_of(world, disc).z() == doctest::Approx(side * expected.spin).epsilon(1e-12));
  }
}
