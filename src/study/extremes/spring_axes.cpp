// Floor 9. Springs from slack to much stiffer than a step can follow.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// So many balls of 1 kg one behind the other on springs of 1 m, all pulled out by 10 %.
Scene row_of_balls(int balls, const SwingSoftness& softness) {
  Scene scene({.gravity = {0, 0}});
  BodyId before = ground;
  for (int i = 1; i <= balls; ++i) {
    const Vec2<double> place(1.1 * i, 0);
    const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = place, .mass = 1});
    scene.join<DistanceJoint>({.a = before,
                               .b = ball,
                               .anchor_a = {1.1 * (i - 1), 0},
                               .anchor_b = place,
                               .length = 1,
                               .kind = DistanceJoint::Kind::spring,
                               .softness = softness});
    before = ball;
  }
  return scene;
}

/// A spring cannot throw farther than it was pulled: the swing beside the pull, both in the middles of steps,
/// which are what keeps the energy (softness.hpp).
ExtremeFinding swing(int balls, double frequency_dt, double damping, const Setting& setting) {
  const double pull = 0.1;  // [m] of each spring
  const SwingSoftness softness{.frequency = frequency_dt / setting.dt, .damping_ratio = damping};
  double worst = 0;
  const auto look = [&](const Snapshot& now) {
    for (int i = 1; i < now.bodies.size(); ++i) {
      const auto middle = [&](int body) {
        return now.bodies[{body}].pose.position.x() - now.dt / 2 * now.bodies[{body}].velocity.x();
      };
      const double length = middle(i) - middle(i - 1);
      worst = std::max(worst, std::abs(length - 1));
    }
    // Coupled springs may gather what all of them were pulled, in one of them.
    return worst > 1.01 * pull * balls;
  };
  return run_extreme(row_of_balls(balls, softness), setting,
                     {.seconds = 240 * setting.dt,
                      .measure = {"swing / pull", [&](const TrialResult&) { return worst / pull; }},
                      .limit = 1 + 1e-9,
                      .thinnest = 1e300,
                      .energy_gain = 0.25,  // half a step between v and x shows w h / 2 of it, and goes again
                      .escaped = look});
}

List<ExtremeCase> stiffness_cases() {
  AxisCases cases("stiffness");
  for (const double frequency_dt : {0.01, 0.1, 0.25, 1.0, 10.0, 1e6}) {
    for (const double damping : {0.0, 0.1, 1.0, 10.0}) {
      for (const int balls : {1, 5}) {
        for (ExtremeSetting tried : usual_settings()) {
          if (frequency_dt > 1e5) tried.setting.dt = 1;  // the stiffest that is allowed is 1e6 Hz
          cases.add(fmt::format("f dt {:g}, zeta {:g}, {}", frequency_dt, damping,
                                balls == 1 ? "alone" : "5 in a row"),
                    tried, balls == 1 ? ExtremeVerdict::ok : ExtremeVerdict::bound,
                    [=](const Setting& setting) { return swing(balls, frequency_dt, damping, setting); });
        }
      }
    }
  }
  for (const double frequency : {0.0, -1.0, 1e7, double(INFINITY), double(NAN)}) {
    cases.add_refusal("f " + shortest(frequency) + " Hz",
                      [frequency] { row_of_balls(1, {.frequency = frequency}); });
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> spring_axes() {
  return {{"stiffness", "springs of frequency f and damping ratio zeta, 240 steps",
           "si and block under every policy, block-contact, PGS, accelerated", stiffness_cases}};
}

}  // namespace cairn
