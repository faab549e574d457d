// Floor 8. A wheel with corners that rolls down a slope: every corner takes its share of the speed.
#include <fmt/format.h>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double corner_radius = 0.5;            // [m] R, from the centre to a corner
const double corner_slope = in_radians(10);  // of the slope
const double corner_frequency = 960;         // [1/s] steps

/// A regular polygon of 1 kg: m R^2 (2 + cos(2 pi/N)) / 6 about its centre.
double inertia_of_corners(int corners) {
  return corner_radius * corner_radius * (2 + std::cos(2 * pi / corners)) / 6;
}

/// On a face at rest, but for the speed at which it turns over its lowest corner.
Scene cornered_wheel(int corners, double spin) {
  Scene scene({.dt = 1 / corner_frequency});
  const Vec2<double> along(std::cos(corner_slope), -std::sin(corner_slope));
  const Vec2<double> up(std::sin(corner_slope), std::cos(corner_slope));
  scene.add({.type = BodyType::static_body,
             .shapes = {box(80, 1)},
             .position = 30 * along - 0.5 * up,
             .angle = -corner_slope,
             .material = {.friction = 1}});
  List<Vec2<double>> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = -pi / 2 + (2 * i + 1) * pi / corners;  // a face is below
    points.push_back(corner_radius * Vec2<double>(std::cos(angle), std::sin(angle)));
  }
  const double half = pi / corners;  // half the angle between two corners
  const Vec2<double> arm = -corner_radius * std::sin(half) * along + corner_radius * std::cos(half) * up;
  scene.add({.shapes = {polygon(points)},
             .position = corner_radius * std::cos(half) * up,
             .angle = -corner_slope,
             .velocity = cross<double>(-spin, arm),
             .angular_velocity = -spin,
             .mass = 1,
             .inertia = inertia_of_corners(corners),
             .material = {.friction = 1}});
  return scene;
}

/// Of the last impact that a rolling wheel had.
struct CornerImpact {
  double before = 0;  // [rad/s]
  double after = 0;   // [rad/s]
};

/// A speed that drops within two steps by more than a twentieth is an impact.
CornerImpact last_impact(const EngineMaker& make, int corners, double spin, double seconds) {
  const std::unique_ptr<Engine> wheel = make(cornered_wheel(corners, spin), 50);
  List<double> speeds;
  const auto steps = std::lround(seconds * corner_frequency);
  for (long step = 0; step < steps; ++step) {
    wheel->step();
    speeds.push_back(-wheel->snapshot().bodies.back().velocity.z());
  }
  CornerImpact impact;
  for (int i = 1; i + 3 < speeds.size(); ++i) {
    if (speeds[i] < speeds[i - 1] || speeds[i + 1] > speeds[i]) continue;  // not at its fastest
    if (speeds[i + 2] < 0.95 * speeds[i]) impact = {speeds[i], speeds[i + 2]};
  }
  return impact;
}

const std::string corner_reason =
    "an impact takes two steps and begins up to one early, with gravity in each: 3 g dt/(R w)";

// About the corner that meets the slope angular momentum is kept: the centre's part turns by 2 pi/N, so that
// w+/w- = (I + m R^2 cos(2 pi/N))/(I + m R^2). From one to the next it sinks by 2 R sin(pi/N) sin(slope).
// In w^2 a wheel comes nearer to the speed at which that is in balance by (w+/w-)^2 at every impact.
ValidationResult rolling_on_corners(const EngineMaker& make) {
  ValidationResult result;
  for (const int corners : {6, 8}) {
    const double I = inertia_of_corners(corners), R = corner_radius;
    const double ratio = (I + R * R * std::cos(2 * pi / corners)) / (I + R * R);
    const double drop = 2 * R * std::sin(pi / corners) * std::sin(corner_slope);
    const double steady = std::sqrt(2 * standard_gravity * drop / (I + R * R) / (1 - ratio * ratio));
    const double share = 3 * standard_gravity / corner_frequency / (R * steady);
    const CornerImpact impact = last_impact(make, corners, 1.2 * steady, 6);
    result.add(measured(fmt::format("speed after an impact over that before, N = {}", corners),
                        impact.after / impact.before)
                   .by("(I + m R^2 cos(2 pi/N))/(I + m R^2)", ratio)
                   .within(share * ratio, corner_reason));
    result.add(measured(fmt::format("steady speed before an impact, N = {}", corners), impact.before, "rad/s")
                   .by("w^2 = 4 m g R sin(pi/N) sin(slope)/(I + m R^2)/(1 - (w+/w-)^2)", steady)
                   .within(share * steady, corner_reason));
  }
  return result;
}

}  // namespace

void add_wheel_cases(ValidationCases& cases) {
  cases.push_back(
      {.id = "B43",
       .title = "A wheel with corners comes to roll steadily, when impacts take what the slope gives",
       .source = "T. McGeer, 1990",
       .asks = Asks::any_engine,
       .run = rolling_on_corners});
}

}  // namespace cairn
