// Blocks, discs and hoops on slopes and on the ground: friction, rolling and tipping.
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

double radians(double degrees) { return degrees * pi / 180; }

/// A slope that goes down to the right, and its axes.
struct Slope {
  double angle = 0;  // [rad]
  Vec2<double> along() const { return {std::cos(angle), -std::sin(angle)}; }
  Vec2<double> normal() const { return {std::sin(angle), std::cos(angle)}; }
};

/// A world with a slope through the origin and `body` on it, whose centre is `height` above the surface. Both
/// surfaces have the friction of the body.
World<double> world_on_slope(const Slope& slope, BodySpec body, double height, double frequency = 60) {
  Scene scene({.dt = 1 / frequency});
  scene.add({.type = BodyType::static_body,
             .shapes = {box(40, 1)},
             .position = -0.5 * slope.normal(),
             .angle = -slope.angle,
             .friction = body.friction});
  body.position = height * slope.normal();
  body.angle = -slope.angle;
  scene.add(body);
  return World(scene);
}

/// Of the only body on a slope.
double speed_along(const Slope& slope, const World<double>& world) {
  return slope.along().dot(world.bodies().velocity.back().head<2>());
}
double way_along(const Slope& slope, const World<double>& world) {
  return slope.along().dot(world.bodies().pose.back().position);
}

/// Bisects for the angle [degrees] at which `happens` becomes true, to 0.001 degrees.
double threshold_angle(double lower, double upper, const std::function<bool(const Slope&)>& happens) {
  REQUIRE_FALSE(happens({radians(lower)}));
  REQUIRE(happens({radians(upper)}));
  while (upper - lower > 0.001) {
    const double middle = (lower + upper) / 2;
    (happens({radians(middle)}) ? upper : lower) = middle;
  }
  return (lower + upper) / 2;
}

BodySpec block(double width, double height, double friction) {
  return {.shapes = {box(width, height)}, .mass = 1, .friction = friction};
}

/// A disc, or a hoop: the same shape with all its mass at the rim, m R^2 instead of m R^2 / 2.
BodySpec wheel(double radius, double inertia, double friction) {
  return {.shapes = {circle(radius)}, .mass = 1, .inertia = inertia, .friction = friction};
}

/// A block that slides on the ground at 5 m/s, or a wheel of radius 0.5 m at 6 m/s, on friction 0.3 or 0.2.
World<double> sliding_on_ground(BodySpec body, double height, double speed, double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.friction = body.friction});
  body.position = {0, height};
  body.velocity = {speed, 0};
  scene.add(body);
  return World(scene);
}

}  // namespace

// B5
TEST_CASE("a block stays on a slope up to tan(angle) = mu, found to a hundredth of a degree") {
  const double mu = 0.5;
  const double found = threshold_angle(26, 27, [&](const Slope& slope) {
    World world = world_on_slope(slope, block(1, 0.5, mu), 0.25);
    SequentialImpulse<double> solver;
    run(world, solver, 1);
    // 0.005 degrees above the threshold, it slides with a = g cos(angle) (tan(angle) - mu).
    const double steepness = radians(0.005) * (1 + mu * mu);
    return speed_along(slope, world) > test_gravity * std::cos(slope.angle) * steepness * world.time();
  });
  CHECK(std::abs(found - std::atan(mu) * 180 / pi) <= 0.01);
}

// B5
TEST_CASE("a block that slides down a slope is pulled by g (sin - mu cos)") {
  const double mu = 0.3;
  const Slope slope{radians(30)};
  const double a = test_gravity * (std::sin(slope.angle) - mu * std::cos(slope.angle));
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World world = world_on_slope(slope, block(1, 0.5, mu), 0.25);
    const auto solver = make({.iterations = 50});
    run(world, *solver, 1);
    // The discrete sums are exact; 50 sweeps of a two-point contact leave rounding.
    CHECK(speed_along(slope, world) == doctest::Approx(a).epsilon(1e-9));
    CHECK(way_along(slope, world) == doctest::Approx(a / 2 + a * world.dt() / 2).epsilon(1e-9));
  }
  check_first_order([&](double frequency) {
    World world = world_on_slope(slope, block(1, 0.5, mu), 0.25, frequency);
    SequentialImpulse<double> solver({.iterations = 50});
    run(world, solver, 1);
    return way_along(slope, world) - a / 2;
  });
}

// B6
TEST_CASE("a block that slides at v0 stops after v0^2 / (2 mu g), less v0 dt / 2") {
  const double v0 = 5, mu = 0.3;
  const double ideal = v0 * v0 / (2 * mu * test_gravity);
  const auto stopping_distance = [&](double frequency) {
    World world = sliding_on_ground(block(1, 0.5, mu), 0.25, v0, frequency);
    SequentialImpulse<double> solver({.iterations = 50});
    run(world, solver, 2);
    CHECK(world.bodies().velocity[1].cwiseAbs().maxCoeff() <= 1e-9);
    return world.bodies().pose[1].position.x();
  };
  CHECK(std::abs(stopping_distance(60) - (ideal - v0 * test_dt / 2)) <= 1e-9);
  check_first_order([&](double frequency) { return stopping_distance(frequency) - ideal; });
}

// B8
TEST_CASE("a disc thrown at v0 without spin slips for v0 / (3 mu g) and then rolls at 2/3 v0") {
  const double v0 = 6, mu = 0.2, radius = 0.5;
  const double t = v0 / (3 * mu * test_gravity);  // 1 s
  const double ideal = 5 * v0 * v0 / (18 * mu * test_gravity);
  const BodySpec disc = wheel(radius, radius * radius / 2, mu);
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World world = sliding_on_ground(disc, radius, v0, 60);
    const auto solver = make({});
    run(world, *solver, t);
    CHECK(world.bodies().pose[1].position.x() == doctest::Approx(ideal - v0 * test_dt / 6).epsilon(1e-9));
    run(world, *solver, 1);
    const Vec3<double>& v = world.bodies().velocity[1];
    CHECK(v.x() == doctest::Approx(2.0 / 3 * v0).epsilon(1e-9));
    CHECK(-v.z() * radius == doctest::Approx(v.x()).epsilon(1e-9));  // it rolls
  }
  check_first_order([&](double frequency) {
    World world = sliding_on_ground(disc, radius, v0, frequency);
    SequentialImpulse<double> solver;
    run(world, solver, t);
    return world.bodies().pose[1].position.x() - ideal;
  });
}

// B10
TEST_CASE("a wheel rolls down a slope at g sin / (1 + I / m R^2): 2/3 for a disc, 1/2 for a hoop") {
  const double radius = 0.5;
  const Slope slope{radians(30)};
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double share : {0.5, 1.0}) {  // I / m R^2
      const double least_mu = std::tan(slope.angle) / (1 + 1 / share);
      World world = world_on_slope(slope, wheel(radius, share * radius * radius, 1.01 * least_mu), radius);
      const auto solver = make({});
      run(world, *solver, 1);
      const double a = test_gravity * std::sin(slope.angle) / (1 + share);
      CHECK(speed_along(slope, world) == doctest::Approx(a).epsilon(1e-9));
      CHECK(-world.bodies().velocity.back().z() * radius == doctest::Approx(a).epsilon(1e-9));
    }
  }
}

// B10
TEST_CASE("a wheel slips down a slope where mu is below tan / 3 for a disc, tan / 2 for a hoop") {
  const double radius = 0.5;
  const Slope slope{radians(30)};
  for (const double share : {0.5, 1.0}) {
    const double mu = 0.99 * std::tan(slope.angle) / (1 + 1 / share);
    World world = world_on_slope(slope, wheel(radius, share * radius * radius, mu), radius);
    SequentialImpulse<double> solver;
    run(world, solver, 1);
    const double a = test_gravity * (std::sin(slope.angle) - mu * std::cos(slope.angle));
    const double spin = mu * test_gravity * std::cos(slope.angle) / (share * radius);
    CHECK(speed_along(slope, world) == doctest::Approx(a).epsilon(1e-9));
    CHECK(-world.bodies().velocity.back().z() == doctest::Approx(spin).epsilon(1e-9));
    CHECK(a > spin * radius);
  }
}

// B11
TEST_CASE("a tall block on a rough slope tips over at tan(angle) = width / height") {
  const double width = 1, height = 2;
  const double found = threshold_angle(25.5, 27.5, [&](const Slope& slope) {
    World world = world_on_slope(slope, block(width, height, 1), height / 2);
    SequentialImpulse<double> solver({.iterations = 30});
    run(world, solver, 2);
    // A block 0.15 degrees beyond its balance falls as cosh(p t), p = sqrt(3 g / 4 R): 0.2 rad in 2 s.
    return std::abs(world.bodies().pose.back().angle + slope.angle) > 0.05;
  });
  CHECK(std::abs(found - std::atan(width / height) * 180 / pi) <= 0.15);
}

// B11
TEST_CASE("the same block on a slope of mu below width / height slides and stands") {
  const Slope slope{radians(30)};  // beyond the angle of tipping
  World world = world_on_slope(slope, block(1, 2, 0.4), 1);
  SequentialImpulse<double> solver({.iterations = 50});
  run(world, solver, 1);
  const double a = test_gravity * (std::sin(slope.angle) - 0.4 * std::cos(slope.angle));
  CHECK(speed_along(slope, world) == doctest::Approx(a).epsilon(1e-9));
  CHECK(std::abs(world.bodies().pose.back().angle + slope.angle) <= 1e-9);
}
