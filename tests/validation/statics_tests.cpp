// Statics that is decided by one number: blows on a hinged rod, ladders, wedges, overhanging blocks, strings.
#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

double statics_radians(double degrees) { return degrees * pi / 180; }

/// The solvers of the paper, for cases that take long.
std::vector<SolverMaker<double>> statics_solvers() {
  return {maker<SequentialImpulse<double>, double>(), maker<ProjectedGaussSeidel<double>, double>()};
}

// Of the ladder.
const double ladder_length = 2;     // [m]
const double floor_friction = 0.4;  // mu between ladder and floor

/// A ladder at rest, its foot on the floor and its top at a wall on its left. Its own surface has friction 1,
/// so that the pair's is the square root of the other's.
Scene ladder_scene(double angle, double wall_friction) {
  Scene scene({.stabilization = {.slop = 1e-4}});
  scene.add_ground({.friction = floor_friction * floor_friction});
  scene.add({.type = BodyType::static_body,
             .shapes = {box(1, 10)},
             .position = {-0.5, 5.5},
             .friction = wall_friction * wall_friction});
  const double thickness = 1e-3;
  const double reach_x = (ladder_length * std::cos(angle) + thickness * std::sin(angle)) / 2;
  const double reach_y = (ladder_length * std::sin(angle) + thickness * std::cos(angle)) / 2;
  scene.add({.shapes = {box(ladder_length, thickness)},
             .position = {reach_x, reach_y},
             .angle = -angle,
             .mass = 1,
             .friction = 1});
  return scene;
}

/// Whether one step from rest leaves the ladder at rest.
bool ladder_holds(const SolverMaker<double>& make, double angle, double wall_friction) {
  VelocityProblem<double> problem = World(ladder_scene(angle, wall_friction)).velocity_problem();
  make({.iterations = 2000})->solve(problem);
  return problem.velocity.back().cwiseAbs().maxCoeff() < 1e-6 * test_gravity * test_dt;
}

const double block_length = 1;  // [m]

/// n blocks on the edge of a table, each overhanging what is below it by `share` of what can be: the k-th
/// from the top by 1 / 2k of its length.
Scene overhanging_blocks(int n, double share) {
  Scene scene({.stabilization = {.slop = 1e-4}});
  const double height = 0.2;
  scene.add({.type = BodyType::static_body, .shapes = {box(4, 1)}, .position = {-2, -0.5}});
  double edge = 0;  // of the support
  for (int k = n; k >= 1; --k) {
    edge += share * block_length / (2 * k);
    scene.add({.shapes = {box(block_length, height)},
               .position = {edge - block_length / 2, (n - k + 0.5) * height},
               .mass = 1});
  }
  return scene;
}

/// How far the topmost block has sunk after this long [m].
double sinking_of_the_top(int n, double share, double seconds) {
  World world(overhanging_blocks(n, share));
  const double start = world.bodies().pose.back().position.y();
  SequentialImpulse<double> solver({.iterations = 300});
  run(world, solver, seconds);
  return start - world.bodies().pose.back().position.y();
}

}  // namespace

// A15
TEST_CASE("a hinged rod that is struck at d kicks its hinge by J (3 d / 2 L - 1): not at all at d = 2/3 L") {
  const double length = 1.5, mass = 2, blow = 3;  // [m], [kg], [N s]
  const double inertia = mass * length * length / 12;
  const double angle = statics_radians(25);  // so that both rows of the hinge have a share
  const Vec2<double> along(std::cos(angle), std::sin(angle));
  const Vec2<double> across(-std::sin(angle), std::cos(angle));
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double share : {0.0, 0.25, 0.5, 2.0 / 3, 1.0}) {
      const double d = share * length;  // from the hinge to the blow
      Scene scene({.gravity = {0, 0}});
      const BodyId rod = scene.add({.shapes = {capsule({-0.1, 0}, {0.1, 0}, 0.05)},
                                    .position = length / 2 * along,
                                    .angle = angle,
                                    .velocity = blow / mass * across,
                                    .angular_velocity = blow * (d - length / 2) / inertia,
                                    .mass = mass,
                                    .inertia = inertia});
      scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
      World world(scene);
      // A_xy^2 / (A_xx A_yy) = (3 s c)^2 / ((1 + 3 s^2)(1 + 3 c^2)) = 0.25 of the error is left by each
      // sweep.
      const auto solver = make({.iterations = 60});
      world.step(*solver);
      const Vec2<double> kick(world.last_step().problem.impulse[0], world.last_step().problem.impulse[1]);
      // Rounding of numbers of the size of the blow.
      CHECK(std::abs(kick.dot(across) - blow * (3 * d / (2 * length) - 1)) <= 64 * double_epsilon * blow);
      CHECK(std::abs(kick.dot(along)) <= 64 * double_epsilon * blow);
      CHECK(std::abs(velocity_of(world, rod).z() - 3 * blow * d / (mass * length * length)) <=
            64 * double_epsilon * blow / (mass * length));
    }
  }
}

// B12
TEST_CASE("a ladder at a wall stands down to tan(angle) = (1 - mu_f mu_w) / (2 mu_f)") {
  for (const SolverMaker<double>& make : statics_solvers()) {
    for (const double wall_friction : {0.0, 0.3}) {
      const double expected = std::atan((1 - floor_friction * wall_friction) / (2 * floor_friction));
      double slips = expected - statics_radians(3), holds = expected + statics_radians(3);
      REQUIRE_FALSE(ladder_holds(make, slips, wall_friction));
      REQUIRE(ladder_holds(make, holds, wall_friction));
      while (holds - slips > statics_radians(0.001)) {
        const double middle = (holds + slips) / 2;
        (ladder_holds(make, middle, wall_friction) ? holds : slips) = middle;
      }
      CAPTURE(wall_friction);
      // The ladder is thick by 1/2000 of its length and stands on corners: its diagonal is 0.029 degrees off.
      CHECK(std::abs(holds - expected) <= statics_radians(0.03));
    }
  }
}

// B12
TEST_CASE("a ladder 0.3 degrees above its least angle stays for seconds, 0.3 degrees below it slides down") {
  for (const double wall_friction : {0.0, 0.3}) {
    const double least = std::atan((1 - floor_friction * wall_friction) / (2 * floor_friction));
    for (const double degrees : {0.3, -0.3}) {
      World world(ladder_scene(least + statics_radians(degrees), wall_friction));
      SequentialImpulse<double> solver({.iterations = 1000});
      const double start = world.bodies().pose.back().position.x();
      run(world, solver, 2);
      const double way = world.bodies().pose.back().position.x() - start;
      CAPTURE(wall_friction);
      CAPTURE(degrees);
      CAPTURE(way);
      if (degrees > 0) CHECK(std::abs(way) <= 2e-4);  // the slop of two contacts
      // Short of balance by 0.005 rad, it moves off with about 0.005 g: 0.1 m in 2 s.
      if (degrees < 0) CHECK(way > 0.02);
    }
  }
}

// B14
TEST_CASE("a block on a free wedge without friction drives it by m g sin cos / (M + m sin^2)") {
  const double m = 1, M = 3, angle = statics_radians(30);
  const double s = std::sin(angle), c = std::cos(angle);
  const double wedge_acceleration = m * test_gravity * s * c / (M + m * s * s);  // 1.332347
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    Scene scene;
    scene.add_ground({.friction = 0});
    const double width = 6;
    const BodyId wedge =
        scene.add({.shapes = {polygon({{0, 0}, {width, 0}, {0, width * s / c}})}, .mass = M, .friction = 0});
    const Vec2<double> middle_of_face(width / 2, width / 2 * s / c);
    const BodyId block = scene.add({.shapes = {box(1, 0.5)},
                                    .position = middle_of_face + 0.25 * Vec2<double>(s, c),
                                    .angle = -angle,
                                    .mass = m,
                                    .friction = 0});
    World world(scene);
    const auto solver = make({.iterations = 300});
    run(world, *solver, 0.5);
    // Constant forces make semi-implicit Euler's velocities exact; what the sweeps leave is rounding.
    const double t = world.time();
    CHECK(velocity_of(world, wedge).x() == doctest::Approx(-wedge_acceleration * t).epsilon(1e-9));
    CHECK(velocity_of(world, block).x() == doctest::Approx(M / m * wedge_acceleration * t).epsilon(1e-9));
    // Seen from the wedge it comes down along the face.
    const double sideways = (1 + M / m) * wedge_acceleration * t;
    CHECK(velocity_of(world, block).y() == doctest::Approx(-sideways * s / c).epsilon(1e-9));
  }
}

// B35
TEST_CASE("n blocks reach 1/2 + 1/4 + ... + 1/2n of a length over the edge: at 99 % they stay for seconds") {
  for (const int n : {1, 3, 5}) {
    CAPTURE(n);
    CHECK(std::abs(sinking_of_the_top(n, 0.99, 3)) <= (n + 1) * 1e-4);  // the slop of every interface
  }
}

// B35
TEST_CASE("n blocks that reach one percent more than they can fall down") {
  for (const int n : {1, 3, 5}) {
    CAPTURE(n);
    // They turn about an edge, at first with g times 0.005 m over their inertia, and ever faster.
    CHECK(sinking_of_the_top(n, 1.01, 3) > 0.1);  // half a block's height
  }
}

// B41
TEST_CASE("two strings that rise at an angle carry a weight W with W / (2 sin angle) each") {
  const double mass = 3, length = 2;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double degrees : {10.0, 30.0, 60.0, 80.0}) {
      const double angle = statics_radians(degrees);
      Scene scene;
      const BodyId weight = scene.add({.shapes = {circle(0.1)}, .mass = mass});
      for (const double side : {-1.0, 1.0}) {
        scene.join<DistanceJoint>({.a = ground,
                                   .b = weight,
                                   .anchor_a = length * Vec2<double>(side * std::cos(angle), std::sin(angle)),
                                   .anchor_b = {0, 0},
                                   .kind = DistanceJoint::Kind::rope});
      }
      World world(scene);
      // cos^2(2 angle) of the error is left by each sweep, 0.883 at most: 300 sweeps leave rounding.
      const auto solver = make({.iterations = 300});
      run(world, *solver, 0.5);
      for (const double impulse : world.last_step().problem.impulse) {
        const double tension = impulse / world.dt();
        CHECK(tension == doctest::Approx(mass * test_gravity / (2 * std::sin(angle))).epsilon(1e-12));
      }
      CHECK(velocity_of(world, weight).cwiseAbs().maxCoeff() <= 1e-13);
    }
  }
}
