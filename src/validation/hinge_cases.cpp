// Floor 8. A blow on a hinged rod.
#include <fmt/format.h>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

// Of the hinged rod.
const double struck_length = 1.5, struck_mass = 2, blow = 3;  // [m], [kg], [N s]

struct Kick {
  double along = 0;   // [N s] that the hinge gives the rod, along it
  double across = 0;  // [N s] in the direction of the blow
  double spin = 0;    // [rad/s] after it
};

/// A rod that is hinged at its end and was struck at a share of its length from there, without the hinge's
/// answer yet; then one step. It is inclined, so that both rows of the hinge have a share.
Kick strike(const EngineMaker& make, double share) {
  const double inertia = struck_mass * struck_length * struck_length / 12, angle = in_radians(25);
  const Vec2<double> along(std::cos(angle), std::sin(angle)), across(-std::sin(angle), std::cos(angle));
  Scene scene({.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const BodyId rod = scene.add({.shapes = {box(0.2, 0.1)},
                                .position = struck_length / 2 * along,
                                .angle = angle,
                                .velocity = blow / struck_mass * across,
                                .angular_velocity = blow * (share - 0.5) * struck_length / inertia,
                                .mass = struck_mass,
                                .inertia = inertia});
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
  // A_xy^2 / (A_xx A_yy) = (3 s c)^2 / ((1 + 3 s^2)(1 + 3 c^2)) = 0.25 of the error is left by each sweep.
  const Snapshot now = run_scene(make, scene, 60, standard_dt);
  const Vec2<double> kick = now.joints.at(0).impulse;
  return {.along = kick.dot(along), .across = kick.dot(across), .spin = now.bodies[{1}].velocity.z()};
}

/// The numbers of blows at five places, in all of these engines.
ValidationResult blows_on_a_hinged_rod(const List<EngineMaker>& engines, const std::string& about) {
  const std::string reason = "64 epsilon of the blow";
  ValidationResult result;
  Worst along = Worst("impulse of the hinge along the rod, d = 0..L" + about, "N s").by("0").since(reason);
  for (const double share : {0.0, 0.25, 0.5, 2.0 / 3, 1.0}) {
    Worst across = Worst("impulse of the hinge, d/L = " + fmt::format("{:.2f}", share) + about, "N s")
                       .by("J (3d/2L - 1)")
                       .since(reason);
    Worst spin = Worst("spin, d/L = " + fmt::format("{:.2f}", share) + about, "rad/s")
                     .by("3 J d / (m L^2)")
                     .since(reason);
    for (const EngineMaker& make : engines) {
      const Kick kick = strike(make, share);
      across.add(blow * (1.5 * share - 1), kick.across, 64 * double_epsilon * blow);
      along.add(0, kick.along, 64 * double_epsilon * blow);
      spin.add(3 * blow * share / (struck_mass * struck_length), kick.spin,
               64 * double_epsilon * blow / (struck_mass * struck_length));
    }
    result.add(across.number());
    result.add(spin.number());
  }
  result.add(along.number());
  return result;
}

// A15. About the hinge I = m L^2 / 3, so that J d = I w; the centre gains w L / 2 = (J + kick) / m.
ValidationResult hinged_rod(const EngineMaker& make) { return blows_on_a_hinged_rod({make}, ""); }

// A15
ValidationResult hinged_rod_in_every_solver(const EngineMaker&) {
  return blows_on_a_hinged_rod(gauss_seidel_engines(), ": worst of 5 solvers");
}

}  // namespace

void add_hinge_cases(ValidationCases& cases) {
  cases.push_back({"A15", "A hinged rod that is struck at 2/3 of its length does not kick its hinge",
                   "derived", Asks::any_engine, hinged_rod});
  cases.push_back({"A15b",
                   "In every solver a hinged rod that is struck at 2/3 of its length does not kick its hinge",
                   "derived", Asks::cairn, hinged_rod_in_every_solver});
}

}  // namespace cairn
