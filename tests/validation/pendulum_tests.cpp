// A rod that swings about its end, against the elliptic integral.
#include "constraints/revolute_joint.hpp"
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double rod_length = 1;  // [m]

/// The arithmetic-geometric mean of a and b.
double agm(double a, double b) {
  while (std::abs(a - b) > 4 * double_epsilon * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

/// 2 pi sqrt(I / (m g d)) / agm(1, cos(theta_0 / 2)) [s], with I = m L^2 / 3 about the end and d = L / 2.
double exact_period(double amplitude) {
  return 2 * pi * std::sqrt(2 * rod_length / (3 * test_gravity)) / agm(1, std::cos(amplitude / 2));
}

/// Lets a thin rod go at rest from `amplitude`, and measures the time between its first and third passage of
/// the vertical: a whole period, in which the half step by which velocities lag behind positions cancels.
double measured_period(double amplitude, double frequency, double baumgarte) {
  Scene scene({.dt = 1 / frequency, .stabilization = {.baumgarte = baumgarte}});
  const Vec2<double> hanging(0, -rod_length / 2);
  const BodyId rod = scene.add({.shapes = {box(0.01, rod_length)},
                                .position = Rotation<double>(amplitude) * hanging,
                                .angle = amplitude,
                                .mass = 1,
                                .inertia = rod_length * rod_length / 12});
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 50});
  std::vector<double> passages;
  while (passages.size() < 3 && world.time() < 20) {
    const double before = pose_of(world, rod).angle;
    world.step(solver);
    const double after = pose_of(world, rod).angle;
    if (before * after <= 0) passages.push_back(world.time() - world.dt() * after / (after - before));
  }
  return passages.at(2) - passages.at(0);
}

double relative_error(double amplitude, double frequency, double baumgarte) {
  return measured_period(amplitude, frequency, baumgarte) / exact_period(amplitude) - 1;
}

/// d ln T / d ln E: how much a period changes with the energy lost or gained on the way.
double sensitivity(double amplitude) {
  const double h = 1e-4;
  const double slope = (exact_period(amplitude + h) - exact_period(amplitude - h)) / (2 * h);
  return slope / exact_period(amplitude) * (1 - std::cos(amplitude)) / std::sin(amplitude);
}

}  // namespace

// B15
TEST_CASE("a rod that swings little has the period 2 pi sqrt(2 L / 3 g), short by (w dt)^2 / 24") {
  const double amplitude = 5 * pi / 180;
  const double omega_squared = 3 * test_gravity / (2 * rod_length);
  for (const double baumgarte : {0.0, 0.2}) {
    for (const double frequency : {60.0, 120.0, 240.0}) {
      // Semi-implicit Euler swings with 2 / dt asin(w dt / 2), faster than w by that share.
      const double tolerance = 1.5 * omega_squared / (frequency * frequency) / 24;
      CHECK(std::abs(relative_error(amplitude, frequency, baumgarte)) <= tolerance);
    }
  }
}

// B15
TEST_CASE("without stabilization the period of a wide swing converges to the elliptic integral like dt") {
  for (const double degrees : {45.0, 90.0}) {
    const double amplitude = degrees * pi / 180;
    check_first_order([=](double frequency) { return relative_error(amplitude, frequency, 0); });
    // Two errors c dt + d dt^2 + ... combine to -d dt^2 / 2 or so, a quarter of it at half the step.
    const auto extrapolated = [=](double frequency) {
      return 2 * relative_error(amplitude, 2 * frequency, 0) - relative_error(amplitude, frequency, 0);
    };
    CHECK(std::abs(extrapolated(240)) <= 1.5 * std::abs(extrapolated(120)) / 4);
  }
}

// B15
TEST_CASE("with Baumgarte stabilization the period of a wide swing converges faster than dt") {
  for (const double degrees : {45.0, 90.0, 150.0}) {
    const double amplitude = degrees * pi / 180;
    const double coarse = std::abs(relative_error(amplitude, 60, 0.2));
    const double middle = std::abs(relative_error(amplitude, 240, 0.2));
    const double fine = std::abs(relative_error(amplitude, 960, 0.2));
    CHECK(middle <= coarse / 4);
    CHECK(fine <= middle / 4);
    // At the bottom the rod turns by w dt in a step, and (w dt)^2 of its energy is at stake.
    const double top_speed_squared = 3 * test_gravity / rod_length * (1 - std::cos(amplitude));
    CHECK(fine <= 1.5 * top_speed_squared / (960.0 * 960.0) * std::max(1.0, sensitivity(amplitude)));
  }
}
