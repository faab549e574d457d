// Floor 8. What Baumgarte stabilization leaves of a rod that turns: B23.
#include <cmath>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double rotor_beta = 0.2;

/// A bead on a rod of 1 m around the origin, without gravity, that is `radius` away and goes across at
/// `speed` [m/s].
Scene rotor(double radius, double speed) {
  Scene scene({.gravity = {0, 0},
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = rotor_beta}});
  const BodyId bead =
      scene.add({.position = {radius, 0}, .velocity = {0, speed}, .mass = 2, .fixed_rotation = true});
  scene.join<DistanceJoint>({.a = ground, .b = bead, .anchor_b = {radius, 0}, .length = 1});
  return scene;
}

/// The rod takes beta C back along its direction, which turns by f meanwhile: beta C = (L + C) (1 - cos f).
void add_steady_rotor(const EngineMaker& make, double turn, const std::string& name,
                      ValidationResult& result) {
  const double stretch = (1 - std::cos(turn)) / (rotor_beta - 1 + std::cos(turn));
  const double radius = 1 + stretch;
  Motion bead(make, rotor(radius, radius * std::sin(turn) / standard_dt), 1);
  Worst length, angle;
  for (int step = 0; step < 600; ++step) {
    const Vec2<double> before = bead.position({1});
    bead.step();
    const Vec2<double> after = bead.position({1});
    length.add(measured("steady stretch at f = " + name + ", worst of 600 steps", after.norm() - 1, "m")
                   .by("L (1 - cos f)/(beta - 1 + cos f)", stretch)
                   .within(64 * double_epsilon / rotor_beta * radius,
                           "64 eps r/beta: rounding, of which the rod takes beta back in a step"));
    angle.add(measured("turn of a step at f = " + name + ", worst of 600 steps",
                       std::atan2(cross<double>(before, after), before.dot(after)), "rad")
                  .by("f", turn)
                  .within(1e-12, "1e-12: rounding of 600 steps"));
  }
  result.numbers.insert(result.numbers.end(), {length.number(), angle.number()});
}

/// Let go at its own length.
Measured settled_rotor(const EngineMaker& make, double omega) {
  Motion bead(make, rotor(1, omega), 1);
  bead.run(5);
  const double ideal = std::pow(omega * standard_dt, 2) / (2 * rotor_beta);
  return measured("stretch after 5 s from " + std::to_string(std::lround(omega)) + " rad/s",
                  bead.position({1}).norm() - 1, "m")
      .by("L w^2 dt^2/(2 beta)", ideal)
      .within(4 * ideal * ideal, "4 C^2/L: longer by C it turns slower by 2 C/L, as r^2 w is kept");
}

ValidationResult rotor_stretch(const EngineMaker& make) {
  ValidationResult result;
  add_steady_rotor(make, 0.02, "0.02 rad", result);
  add_steady_rotor(make, 0.0833, "0.0833 rad", result);
  add_steady_rotor(make, 0.17, "0.17 rad", result);
  for (const double omega : {1.0, 5.0, 10.0}) result.add(settled_rotor(make, omega));
  return result;
}

}  // namespace

void add_rotor_cases(ValidationCases& cases) {
  cases.push_back({.id = "B23",
                   .title = "A rotor is stretched by L w^2 dt^2 / (2 beta) under Baumgarte stabilization",
                   .asks = Asks::any_engine,
                   .run = rotor_stretch});
}

}  // namespace cairn
