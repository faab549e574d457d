// Floor 8. Free flight, and two discs that meet in it.
#include <fmt/format.h>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// What a body is thrown with in the case of free flight, and when it is looked at.
const double flight_time = 2;  // [s]

Scene thrown_body(double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add(
      {.shapes = {circle(1)}, .position = {1, 2}, .angle = 0.5, .velocity = {3, 4}, .angular_velocity = 2});
  return scene;
}

// A step of v -= g dt, y += v dt adds up to y0 + v0 t - g t (t + dt) / 2: half a g t dt below the parabola.
ValidationResult free_flight(const EngineMaker& make) {
  ValidationResult result;
  const double g = standard_gravity, t = flight_time, parabola = 2 + 4 * t - g * t * t / 2;
  for (const double frequency : {30.0, 60.0, 120.0}) {
    const Snapshot end = run_scene(make, thrown_body(frequency), 1, t);
    const SnapshotBody& body = end.bodies.back();
    // Each step rounds numbers below 20 twice.
    const double rounding = 2 * 20 * double_epsilon * t * frequency;
    const auto add = [&](const char* what, const char* formula, const char* unit, double expected,
                         double got) {
      result.add(measured(fmt::format("{} after 2 s at {} Hz", what, frequency), got, unit)
                     .by(formula, expected)
                     .within(rounding, "rounding of numbers below 20, twice a step"));
    };
    add("height", "y0 + v0 t - g t^2/2 - g t dt/2", "m", parabola - g * t / frequency / 2,
        body.pose.position.y());
    add("way", "x0 + u0 t", "m", 1 + 3 * t, body.pose.position.x());
    add("angle", "q0 + w0 t", "rad", 0.5 + 2 * t, body.pose.angle);
    add("upward speed", "v0 - g t", "m/s", 4 - g * t, body.velocity.y());
  }
  result.convergence = converges("height after 2 s, to the parabola", [&](double frequency) {
    return run_scene(make, thrown_body(frequency), 1, t).bodies.back().pose.position.y() - parabola;
  });
  return result;
}

const double hit_radius = 0.5;  // [m]
const double hit_speed = 2;     // [m/s]

/// A disc that comes along x, and an equal one at rest whose centre is `offset` higher.
Scene oblique_discs(double offset, double frequency) {
  Scene scene({.gravity = {0, 0}, .dt = 1 / frequency});
  const BodySpec disc{
      .shapes = {circle(hit_radius)}, .mass = 1, .material = {.friction = 0, .restitution = 1}};
  BodySpec coming = disc, waiting = disc;
  coming.position = {-2, 0};
  coming.velocity = {hit_speed, 0};
  waiting.position = {0, offset};
  scene.add(coming);
  scene.add(waiting);
  return scene;
}

// The disc at rest takes (v.n) n, the other keeps v - (v.n) n: perpendicular whatever n is.
ValidationResult oblique_hit(const EngineMaker& make) {
  ValidationResult result;
  List<double> products, energies;
  for (const double offset : {0.2, 0.5, 0.8}) {
    for (const double frequency : {60.0, 240.0}) {
      const Snapshot end = run_scene(make, oblique_discs(offset, frequency), 10, 1.5);
      const Vec2<double> first = end.bodies[{1}].velocity.head<2>();
      const Vec2<double> second = end.bodies[{2}].velocity.head<2>();
      products.push_back(first.dot(second));
      energies.push_back((first.squaredNorm() + second.squaredNorm()) / 2);
      result.add(
          measured(fmt::format("direction of the disc hit {} m off centre, at {} Hz", offset, frequency),
                   std::atan2(second.y(), second.x()), "rad")
              .by("asin(offset/2R)", std::asin(offset / (2 * hit_radius)))
              .within(2 * hit_speed / frequency / hit_radius,
                      "the normal is that of the step's begin, up to v dt before they touch: 2 v dt/R"));
    }
  }
  const double energy = hit_speed * hit_speed / 2;
  // The arms are those of the touch, but for half of the way that the two come beside each other until then.
  const double off = hit_speed / 60 / 2;
  const double spin = 2 * 2 * off * off / (hit_radius * hit_radius);
  const std::string reason = "arms off by v dt/2 turn both discs: 2 (v dt/2)^2/R^2 of the energy each";
  result.add(measured("product of the two velocities, worst of six hits", farthest(0, products), "m^2/s^2")
                 .by("v1 . v2 = 0", 0)
                 .within(spin * energy, reason));
  result.add(measured("energy after the hit, worst of six hits", farthest(energy, energies), "J")
                 .by("m v^2/2", energy)
                 .within(spin * energy, reason));
  return result;
}

}  // namespace

void add_flight_cases(ValidationCases& cases) {
  cases.push_back({.id = "B1",
                   .title = "A thrown body flies along its parabola, but g t dt / 2 lower",
                   .asks = Asks::any_engine,
                   .run = free_flight});
  cases.push_back({.id = "B3",
                   .title = "Two equal elastic discs part at a right angle if one of them was at rest",
                   .asks = Asks::any_engine,
                   .run = oblique_hit});
}

}  // namespace cairn
