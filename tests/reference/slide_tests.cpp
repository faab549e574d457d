// Friction in two engines against Coulomb's formulas. Where they differ, Box2D's skin says by how much.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

/// How far the box has come downhill [m].
double downhill(const Slope& slope, const Snapshot& snapshot) {
  return (body(snapshot, slope.box).pose.position - slope.start).dot(slope.downhill);
}

/// How far it has turned since the start [rad].
double turned(double slope_angle, const Slope& slope, const Snapshot& snapshot) {
  return std::abs(body(snapshot, slope.box).pose.angle + slope_angle);
}

/// The snapshot of either engine: the same question is asked of both.
using View = std::function<Snapshot(const Engines&)>;
const View cairn_view = [](const Engines& engines) { return snapshot(engines.cairn); };
const View box2d_view = [](const Engines& engines) { return engines.box2d.snapshot(); };

/// The angle [rad] in `low` ... `high` at which `moves` changes from false to true, to 2^-12 of the interval.
double threshold(double low, double high, const std::function<bool(double)>& moves) {
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    (moves(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

TEST_CASE("a box holds on a slope up to tan(angle) = mu in both engines, to 0.01 degrees") {
  const double mu = 0.5;
  const double formula = std::atan(mu);  // 26.565 degrees
  for (const View& view : {cairn_view, box2d_view}) {
    // An angle d above the formula gives g d (cos + mu sin) t^2 / 2: 1 mm in 2 s for 0.0026 degrees.
    const auto slides = [&](double angle) {
      const Slope slope = box_on_slope({.angle = angle, .friction = mu});
      Engines engines(slope.scene);
      engines.step(120);
      return downhill(slope, view(engines)) > 1e-3;
    };
    CHECK_FALSE(slides(formula - 0.01 * degree));
    CHECK(slides(formula + 0.01 * degree));
    CHECK(std::abs(threshold(25 * degree, 28 * degree, slides) - formula) < 0.01 * degree);
  }
}

TEST_CASE("a tall box tips where its width over its height says, and Box2D tips earlier by its skin") {
  // On a slope d steeper than the formula the box turns by d (cosh(k t) - 1), where k^2 = 3 g / (2 diagonal):
  // after 4 s by 1.6e4 d, so that 0.2 rad need d = 0.0007 degrees; the bisection adds 0.0004. 100 sweeps,
  // because the first frame would push the box over if its impulses had not converged.
  const double tolerance = 0.002 * degree;
  const auto tipping_angle = [](const View& view) {
    return threshold(25 * degree, 28 * degree, [&view](double angle) {
      const Slope slope = box_on_slope({.angle = angle, .size = {1, 2}, .friction = 0.8});
      Engines engines(slope.scene, {.velocity_iterations = 100});
      engines.step(240);
      return turned(angle, slope, view(engines)) > 0.2;
    });
  };
  const double width = 1;   // [m]
  const double height = 2;  // [m]
  CHECK(std::abs(tipping_angle(cairn_view) - std::atan(width / height)) < tolerance);
  // Box2D lets forces act in the middle of the gap, so that the box stands on a longer lever.
  CHECK(std::abs(tipping_angle(box2d_view) - std::atan(width / (height + box2d_polygon_gap))) < tolerance);
}

TEST_CASE("on one slope a tall box tips and does not slide, and a wide one slides and does not tip") {
  const double angle = 30 * degree;  // tan = 0.577
  for (const View& view : {cairn_view, box2d_view}) {
    const Slope tall = box_on_slope({.angle = angle, .size = {1, 2}, .friction = 0.8});
    Engines tips(tall.scene);
    tips.step(60);
    CHECK(turned(angle, tall, view(tips)) > 0.2);

    const Slope wide = box_on_slope({.angle = angle, .size = {2, 1}, .friction = 0.5});
    Engines slides(wide.scene);
    slides.step(60);
    CHECK(turned(angle, wide, view(slides)) < 1e-3);
    CHECK(downhill(wide, view(slides)) > 0.2);  // g (sin - mu cos) t^2 / 2 = 0.335 m
  }
}

TEST_CASE("a box comes to a halt after v^2 / (2 mu g) - v dt / 2 in both engines") {
  const double mu = 0.3;
  const double velocity = 5;  // [m/s]
  const double g = 10;        // [m/s^2]
  const Slope slope = box_on_slope({.friction = mu, .velocity = velocity});
  Engines engines(slope.scene, {.velocity_iterations = 100});
  engines.step(120);
  const double dt = slope.scene.settings().dt;
  const double formula =
      velocity * velocity / (2 * mu * g) - velocity * dt / 2;  // semi-implicit Euler, exact

  const int steps = 100;  // v / (mu g dt)
  const double cairn_tolerance = 64 * 2.2e-16 * steps;
  CHECK(std::abs(downhill(slope, snapshot(engines.cairn)) - formula) < cairn_tolerance);
  // In float each step rounds a velocity and a position of up to 5: the first errors add up twice.
  const double rounding = velocity * float_rounding;
  const double box2d_tolerance = rounding * steps * steps / 2 * dt + rounding * steps;
  CHECK(std::abs(downhill(slope, engines.box2d.snapshot()) - formula) < box2d_tolerance);
}

TEST_CASE(
    "a disc that slides ends up rolling at 2/3 of its speed, and in Box2D a little slower for its skin") {
  const double velocity = 6;  // [m/s]
  const double radius = 0.5;  // [m]
  Scene scene;
  scene.add_ground({.material = {.friction = 0.2}});
  const BodyId disc = scene.add({.shapes = {circle(radius)},
                                 .position = {0, radius},
                                 .velocity = {velocity, 0},
                                 .material = {.friction = 0.2}});
  Engines engines(scene);
  engines.step(120);

  const SnapshotBody cairn = body(snapshot(engines.cairn), disc);
  CHECK(std::abs(cairn.velocity.x() - velocity * 2 / 3) < 1e-9);
  CHECK(std::abs(cairn.velocity.x() + radius * cairn.velocity.z()) < 1e-9);

  // Friction p acts in the middle of the overlap of disc and skin, at arm r: m (v_0 - v) = p, I w = r p with
  // I = m radius^2 / 2, and v = r' w once it rolls, give v = v_0 q / (1 + q) with q = 2 r r' / radius^2. The
  // overlap is the skin at first and the slop at rest, so that r grows from 0.495 m to r' = 0.4975 m.
  const double first = radius - box2d_skin / 2;
  const double rest = radius - box2d_slop / 2;
  const auto rolling_speed = [&](double arm) {
    const double q = 2 * arm * rest / (radius * radius);
    return velocity * q / (1 + q);
  };
  const SnapshotBody box2d = body(engines.box2d.snapshot(), disc);
  CHECK(box2d.velocity.x() > rolling_speed(first));
  CHECK(box2d.velocity.x() < rolling_speed(rest));  // 3.9866
  CHECK(std::abs(box2d.velocity.x() + rest * box2d.velocity.z()) < 120 * velocity * float_rounding);
}

}  // namespace

}  // namespace cairn::reference_tests
