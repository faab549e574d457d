// A tall block that rocks from one bottom corner to the other (G. Housner, The behavior of inverted pendulum
// structures during earthquakes, 1963).
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double rocker_half_width = 0.5;                                                 // [m]
const double rocker_half_height = 2;                                                  // [m]
const double rocker_slenderness = std::atan(rocker_half_width / rocker_half_height);  // alpha
const double rocker_diagonal = std::hypot(rocker_half_width, rocker_half_height);  // [m] R, from its centre
const double rocker_rate = std::sqrt(3 * test_gravity / (4 * rocker_diagonal));    // [1/s] p

/// When the block, let go at `start` [rad], is upright again [s]: d^2 q/dt^2 = -p^2 sin(alpha - q), with
/// I = 4/3 m R^2 about the corner. From the energy dq/dt = p sqrt(2 (cos(alpha - start) - cos(alpha - q))),
/// with q = start - s^2 to have no pole, by the midpoint rule.
double exact_quarter(double start) {
  const int pieces = 20000;
  const double end = std::sqrt(start);
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double s = (i + 0.5) / pieces * end;
    // cos(x) - cos(y) = 2 sin((x + y) / 2) sin((y - x) / 2), with y - x = s^2
    const double x = rocker_slenderness - start;
    const double fall = 4 * std::sin(x + s * s / 2) * std::sin(s * s / 2);
    sum += 2 * s / std::sqrt(fall);
  }
  return sum * end / pieces / rocker_rate;
}

struct Rocking {
  double quarter = 0;  // [s] until it is upright
  double before = 0;   // [rad/s] how fast it turns there
  double after = 0;    // [rad/s] after the other corner has hit the ground
};

/// Lets the block go at rest, leaning to the right on its right corner by `start` [rad].
Rocking rocking(double start, double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.friction = 2});
  const double lean = rocker_slenderness - start;  // of the diagonal from the vertical
  const BodyId block =
      scene.add({.shapes = {box(2 * rocker_half_width, 2 * rocker_half_height)},
                 .position = {-rocker_diagonal * std::sin(lean), rocker_diagonal * std::cos(lean)},
                 .angle = -start,
                 .mass = 1,
                 .friction = 2});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 300});
  Rocking result;
  while (world.time() < 3) {
    const double angle = pose_of(world, block).angle, speed = velocity_of(world, block).z();
    world.step(solver);
    if (result.quarter == 0 && pose_of(world, block).angle > -speed * world.dt() / 2) {
      // The other corner stops it where it hits: the last step is cut short.
      result.quarter = world.time() - world.dt() - angle / speed;
      result.before = speed;
      for (int step = 0; step < 2; ++step) world.step(solver);
      result.after = velocity_of(world, block).z();
      return result;
    }
  }
  return result;
}

}  // namespace

// B40
TEST_CASE("a rocking block let go at an angle is upright after acosh(1 / (1 - angle / alpha)) / p") {
  for (const double share : {0.25, 0.5, 0.75}) {
    const double start = share * rocker_slenderness;
    const double linear = std::acosh(1 / (1 - share)) / rocker_rate;
    const Rocking found = rocking(start, 240);
    CHECK(found.quarter == doctest::Approx(linear).epsilon(0.02));  // sin(alpha - q) for alpha - q, and dt
    check_first_order(
        [=](double frequency) { return rocking(start, frequency).quarter - exact_quarter(start); });
  }
}

// B40
TEST_CASE("a rocking block keeps 1 - 3/2 sin^2(alpha) of its speed when it lands on its other corner") {
  const double kept = 1 - 1.5 * std::pow(std::sin(rocker_slenderness), 2);
  for (const double share : {0.25, 0.5, 0.75}) {
    for (const double frequency : {60.0, 240.0, 960.0}) {
      const Rocking found = rocking(share * rocker_slenderness, frequency);
      // Angular momentum about the new corner is kept, but for gravity in the step that is cut short and the
      // two after it: each takes p^2 sin(alpha) dt.
      const double braked = 3 * rocker_rate * rocker_rate * std::sin(rocker_slenderness) / frequency;
      CHECK(std::abs(found.after - kept * found.before) <= braked);
    }
  }
}
