// Free fall, bounces and damping: what needs no solver, or hardly one.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

TEST_CASE("a thrown body follows x_0 + v_0 t - g t^2 / 2 - g t dt / 2 in both engines") {
  const Vec2<double> velocity(3, 8);  // [m/s]
  Scene scene;
  const BodyId stone = scene.add({.shapes = {circle(0.1)}, .velocity = velocity, .angular_velocity = 2});
  Engines engines(scene);
  const int steps = 60;
  engines.step(steps);
  const double dt = scene.settings().dt;
  const double t = steps * dt;
  const Vec2<double> gravity = scene.settings().gravity;
  const Vec2<double> formula = velocity * t + gravity * (t * t + t * dt) / 2;

  const SnapshotBody cairn = body(snapshot(engines.cairn), stone);
  CHECK((cairn.pose.position - formula).norm() < 64 * 2.2e-16 * steps);
  CHECK(cairn.pose.angle == doctest::Approx(2 * t).epsilon(1e-13));
  // Each step rounds a position of at most 4 m and a velocity of at most 8 m/s.
  const SnapshotBody box2d = body(engines.box2d.snapshot(), stone);
  const double tolerance = 4 * float_rounding * steps + 8 * float_rounding * steps * t / 2;
  CHECK((box2d.pose.position - formula).norm() < tolerance);
  CHECK((box2d.velocity.head<2>() - (velocity + t * gravity)).norm() < 8 * float_rounding * steps);
}

TEST_CASE("an elastic ball regains its height exactly in Cairn, and gains v dt with every bounce in Box2D") {
  const double radius = 0.25;  // [m]
  const double height = 1;     // [m] of the fall
  const double g = 10;         // [m/s^2]
  Scene scene;
  scene.add_ground();
  const BodyId ball = scene.add(
      {.shapes = {circle(radius)}, .position = {0, radius + height}, .material = {.restitution = 1}});
  const double dt = scene.settings().dt;

  // The ball falls for n steps until it overlaps Box2D's skin: y_n = h - g dt^2 n (n + 1) / 2.
  int n = 0;
  while (height - g * dt * dt * n * (n + 1) / 2 > box2d_skin) ++n;
  // Cairn sends it back at the speed g n dt that it came with, and it climbs what it fell. Box2D takes the
  // speed after one more step of gravity, g (n + 1) dt = v, and it climbs v dt more.
  const double speed = g * (n + 1) * dt;

  Engines engines(scene);
  Box2DWorld continuous(scene, {.continuous = true});
  double cairn_apex = 0;  // [m] above the point where it was let go
  double box2d_apex = 0;
  double continuous_apex = 0;
  for (int step = 0; step < 3 * n; ++step) {
    engines.step();
    continuous.step();
    if (step < n) continue;
    const double start = radius + height;
    cairn_apex = std::max(cairn_apex, body(snapshot(engines.cairn), ball).pose.position.y() - start);
    box2d_apex = std::max(box2d_apex, body(engines.box2d.snapshot(), ball).pose.position.y() - start);
    continuous_apex = std::max(continuous_apex, body(continuous.snapshot(), ball).pose.position.y() - start);
  }
  CHECK(std::abs(cairn_apex) < 64 * 2.2e-16 * 3 * n);
  CHECK(std::abs(box2d_apex - speed * dt) < 3 * n * speed * float_rounding);
  CHECK(continuous_apex > 0);  // it is stopped at the surface first, and gains less, but gains
  CHECK(continuous_apex < box2d_apex);
}

TEST_CASE("damping, gravity scale and kinematic motion follow the same formulas in both engines") {
  const double damping = 0.8;  // [1/s], both kinds
  Scene scene;
  const BodyId damped = scene.add({.shapes = {circle(0.1)},
                                   .velocity = {5, 0},
                                   .angular_velocity = 3,
                                   .damping = {.linear = damping, .angular = damping},
                                   .gravity_scale = 0});
  const BodyId heavy = scene.add({.shapes = {circle(0.1)}, .position = {5, 0}, .gravity_scale = 2});
  const BodyId belt = scene.add({.type = BodyType::kinematic,
                                 .shapes = {box(1, 1)},
                                 .position = {-5, 0},
                                 .velocity = {0, 1},
                                 .angular_velocity = 0.5});
  Engines engines(scene);
  const int steps = 60;
  engines.step(steps);
  const double dt = scene.settings().dt;
  const double decay = std::pow(1 / (1 + damping * dt), steps);  // implicit Euler
  for (const Snapshot& seen : {snapshot(engines.cairn), engines.box2d.snapshot()}) {
    const double tolerance = 2 * steps * float_rounding;  // relative: two roundings a step
    CHECK(body(seen, damped).velocity.x() == doctest::Approx(5 * decay).epsilon(tolerance));
    CHECK(body(seen, damped).velocity.z() == doctest::Approx(3 * decay).epsilon(tolerance));
    CHECK(body(seen, heavy).velocity.y() == doctest::Approx(-2 * 10 * steps * dt).epsilon(tolerance));
    CHECK(body(seen, belt).velocity == Vec3<double>(0, 1, 0.5));
    CHECK(body(seen, belt).pose.position.y() == doctest::Approx(steps * dt).epsilon(tolerance));
    CHECK(body(seen, belt).pose.angle == doctest::Approx(0.5 * steps * dt).epsilon(tolerance));
  }
}

}  // namespace

}  // namespace cairn::reference_tests
