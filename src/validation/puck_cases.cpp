// Floor 8. Pucks on a table, seen from above, cones and pyramids of friction: B38.
#include <cmath>
#include <string>

#include <cairn/constraints/friction_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double puck_mass = 2;   // [kg]
const double puck_grip = 4;   // [m/s^2] mu g
const double puck_speed = 4;  // [m/s] v0

Scene puck_scene(FrictionShape shape, double direction, double frequency) {
  Scene scene({.gravity = {0, 0}, .dt = 1 / frequency});
  const BodyId puck =
      scene.add({.velocity = puck_speed * Vec2<double>(std::cos(direction), std::sin(direction)),
                 .mass = puck_mass,
                 .inertia = 0.5});
  scene.join<FrictionJoint>({.b = puck, .max_force = puck_mass * puck_grip, .shape = shape});
  return scene;
}

/// Where it comes to rest [m].
Vec2<double> place_of_rest(const EngineMaker& make, FrictionShape shape, double direction, double frequency) {
  Motion puck(make, puck_scene(shape, direction, frequency), 2);
  puck.run(1.1 * puck_speed / puck_grip);
  return puck.position({1});
}

/// How far semi-implicit Euler goes from v, which friction brakes by mu g dt in every step [m].
double braking_way(double v, double dt) {
  const double lost = puck_grip * dt;
  const double steps = std::floor(v / lost + 1e-9);
  return dt * (steps * v - lost * steps * (steps + 1) / 2);
}

void see_round_puck(const EngineMaker& make, FrictionShape shape, Worst& distance, Worst& across) {
  const std::string which = shape == FrictionShape::circle ? "circle" : "square along the velocity";
  for (const double degrees : {0.0, 30.0, 45.0, 100.0, 260.0}) {
    const double direction = in_radians(degrees);
    const Vec2<double> along(std::cos(direction), std::sin(direction));
    const Vec2<double> place = place_of_rest(make, shape, direction, 60);
    distance.add(measured("way in the " + which + ", worst of 5 directions and 5 solvers", place.norm(), "m")
                     .by("v0^2/(2 mu g) - v0 dt/2",
                         puck_speed * puck_speed / (2 * puck_grip) - puck_speed * standard_dt / 2)
                     .within_share(1e-12, "1e-12: rounding of 60 steps"));
    across.add(measured("sideways in the " + which + ", worst of 5 directions and 5 solvers",
                        cross(along, place), "m")
                   .zero_within(1e-12, "1e-12: nothing but rounding turns it"));
  }
}

/// In a square of fixed axes each axis brakes by itself.
void see_square_puck(const EngineMaker& make, double degrees, Worst& distance, Worst& heading) {
  const double c = std::cos(in_radians(degrees)), s = std::sin(in_radians(degrees));
  const Vec2<double> place = place_of_rest(make, FrictionShape::square, in_radians(degrees), 60);
  const Vec2<double> expected(braking_way(puck_speed * c, standard_dt),
                              braking_way(puck_speed * s, standard_dt));
  const std::string from = " in the fixed square from " + std::to_string(std::lround(degrees)) + " degrees";
  distance.add(measured("way" + from + ", worst of 5 solvers", place.norm(), "m")
                   .by("hypot of dt sum (v0 cos, v0 sin - k mu g dt)", expected.norm())
                   .within_share(1e-12, "1e-12: rounding of 60 steps"));
  heading.add(measured("heading" + from + ", worst of 5 solvers", std::atan2(place.y(), place.x()), "rad")
                  .by("atan2 of the same sums", std::atan2(expected.y(), expected.x()))
                  .within_share(1e-12, "1e-12: rounding of 60 steps"));
}

/// The ratio of ways in the fixed square and in the circle, at small steps.
Measured square_ratio(double degrees) {
  const double frequency = 1920, dt = 1 / frequency, direction = in_radians(degrees);
  const double c = std::cos(direction), s = std::sin(direction);
  const EngineMaker make = cairn_engine();
  const double square = place_of_rest(make, FrictionShape::square, direction, frequency).norm();
  const double round = place_of_rest(make, FrictionShape::circle, direction, frequency).norm();
  // Every way is v0 dt / 2 short; the shortest is that of an axis, s v0 / mu g / 2 of it.
  return measured("way in the square over way in the circle, from " + std::to_string(std::lround(degrees)) +
                      " degrees at 1920 Hz",
                  square / round)
      .by("sqrt(cos^4 + sin^4)", std::sqrt(std::pow(c, 4) + std::pow(s, 4)))
      .within_share(2 * puck_grip * dt / puck_speed / s,
                    "2 mu g dt/(v0 sin): each way is short by half a step of its speed");
}

ValidationResult pucks(const EngineMaker&) {
  Worst round, across, aligned, aligned_across, way_30, heading_30, way_45, heading_45;
  for (const EngineMaker& make : gauss_seidel_engines()) {
    see_round_puck(make, FrictionShape::circle, round, across);
    see_round_puck(make, FrictionShape::aligned_square, aligned, aligned_across);
    see_square_puck(make, 30, way_30, heading_30);
    see_square_puck(make, 45, way_45, heading_45);
  }
  ValidationResult result;
  for (const Worst& worst :
       {round, across, aligned, aligned_across, way_30, heading_30, way_45, heading_45}) {
    result.add(worst.number());
  }
  for (const double degrees : {30.0, 45.0}) result.add(square_ratio(degrees));
  const double distance = puck_speed * puck_speed / (2 * puck_grip);
  result.convergence = converges("way of a puck in the circle", [distance](double frequency) {
    return place_of_rest(cairn_engine(), FrictionShape::circle, pi / 6, frequency).norm() - distance;
  });
  return result;
}

}  // namespace

void add_puck_cases(ValidationCases& cases) {
  cases.push_back(
      {.id = "B38",
       .title =
           "A puck in the friction circle goes straight, and v0^2 / (2 mu g) far; a square bends its way",
       .run = pucks});
}

}  // namespace cairn
