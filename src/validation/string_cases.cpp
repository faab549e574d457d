// Floor 8. A weight on two strings: B41.
#include <cmath>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double string_weight = 3;  // [kg]

/// A weight at the origin on two strings of 2 m that rise at an angle [rad].
Scene weight_on_two_strings(double angle) {
  Scene scene;
  const BodyId weight = scene.add({.mass = string_weight, .inertia = 0.1});
  for (const double side : {-1.0, 1.0}) {
    const Vec2<double> end = 2 * Vec2<double>(side * std::cos(angle), std::sin(angle));
    scene.join<DistanceJoint>({.a = ground, .b = weight, .anchor_a = end, .kind = DistanceJoint::Kind::rope});
  }
  return scene;
}

ValidationResult two_strings(const EngineMaker&) {
  ValidationResult result;
  Worst rest;
  for (const double degrees : {10.0, 30.0, 60.0, 80.0}) {
    const double angle = in_radians(degrees);
    Worst tension;
    for (const EngineMaker& make : gauss_seidel_engines()) {
      Motion weight(make, weight_on_two_strings(angle), 300);
      weight.run(0.25);
      for (const SnapshotJoint& string : weight.now().joints) {
        tension.add(measured("tension at " + std::to_string(std::lround(degrees)) +
                                 " degrees, worst of 2 strings and 5 solvers",
                             string.impulse.norm() / weight.dt(), "N")
                        .by("m g/(2 sin a)", string_weight * standard_gravity / (2 * std::sin(angle)))
                        .within_share(1e-12,
                                      "1e-12: a sweep leaves cos^2(2a) <= 0.883; 300 "
                                      "leave rounding"));
      }
      rest.add(
          measured("speed of the weight, worst of 4 angles and 5 solvers", weight.velocity({1}).norm(), "m/s")
              .zero_within(1e-13, "rounding of g dt = 0.17 m/s"));
    }
    result.add(tension.number());
  }
  result.add(rest.number());
  return result;
}

}  // namespace

void add_string_cases(ValidationCases& cases) {
  cases.push_back({.id = "B41",
                   .title = "Two strings that rise at an angle carry W / (2 sin angle) each of a weight W",
                   .run = two_strings});
}

}  // namespace cairn
