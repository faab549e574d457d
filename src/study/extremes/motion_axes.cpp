// Floor 9. Very fast, and spinning very fast.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/tuning/recommend_scenes.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

List<ExtremeSetting> few_settings() {
  return {{setting_of("si", 10), true},
          {setting_of("si", 10, Policy::baumgarte), false},
          {setting_of("si", 10, Policy::soft), false},
          {setting_of("si", 10, Policy::split_impulse), true},
          {setting_of("block-contact", 10), false},
          {setting_of("accelerated", 10), false},
          {setting_of("reference", 1), false}};
}

/// Whether a body on its straight way from one place to the next goes through the wall, and not over its end.
bool crosses_wall(const Vec2<double>& from, const Vec2<double>& to) {
  const double half_height = 2;  // [m]
  if (!(from.x() < 0) || !(to.x() >= 0)) return false;
  const double share = from.x() / (from.x() - to.x());
  return std::abs(from.y() + share * (to.y() - from.y())) < half_height;
}

/// Long enough for the body to arrive, and not much longer.
ExtremeFinding shoot(const Scene& scene, double speed, const Setting& setting) {
  Vec2<double> before = scene.bodies().back().pose.position;
  const auto look = [&](const Snapshot& now) {
    const Vec2<double> from = before;
    before = now.bodies.back().pose.position;
    return crosses_wall(from, before);
  };
  return run_extreme(scene, setting,
                     {.seconds = std::max(4 / speed, 20 * setting.dt),
                      .measure = energy_gained(),
                      .limit = 1e-9,
                      .thinnest = 0.1,
                      .escaped = look});
}

List<ExtremeCase> speed_cases() {
  struct Bullet {
    std::string text;
    Shape<double> shape;
  };
  AxisCases cases("speed");
  for (const double speed : {1.0, 10.0, 100.0, 1e3, 1e5}) {
    for (const Bullet& bullet : {Bullet{"disc", circle(0.1)}, Bullet{"box", box(0.2, 0.2)}}) {
      for (const double restitution : {0.0, 1.0}) {
        for (const ExtremeSetting& tried : few_settings()) {
          cases.add(fmt::format("{:g} m/s, {}, e {:g}", speed, bullet.text, restitution), tried,
                    ExtremeVerdict::bound, [=, shape = bullet.shape](const Setting& setting) {
                      return shoot(shot_at_wall(speed, shape, restitution), speed, setting);
                    });
        }
      }
    }
  }
  return cases.all();
}

/// A free body keeps its spin, and its angle is that times time.
ExtremeFinding free_spin(double turn, const Setting& setting) {
  const double spin = turn / setting.dt;
  double worst = 0;
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {box(1, 0.5)}, .angular_velocity = spin});
  return run_extreme(scene, setting,
                     {.seconds = 2,
                      .measure = {"error of the angle / turned", [&](const TrialResult&) { return worst; }},
                      .limit = 1e-12,
                      .escaped = [&](const Snapshot& now) {
                        const double expected = spin * setting.dt * now.step;
                        if (now.step == 0) return false;
                        worst = std::max(worst, std::abs(now.bodies[{1}].pose.angle / expected - 1));
                        return false;
                      }});
}

/// A ball on a rod. Its place on the circle is found along the tangent, so that the rod is stretched by
/// L (w dt)^2 / (2 beta) in the long run, and less where joints follow their arcs: then the ball goes along a
/// chord, which begins at the tangent w L dt and ends on the circle. It is longer by the pull inwards,
/// L (1 - sqrt(1 - (w dt)^2)), at most as long as the tangent for any turn: the energy up to twice as much.
ExtremeFinding spin_on_a_rod(double turn, const Setting& setting) {
  const double spin = turn / setting.dt;
  Scene scene({.gravity = {0, 0}});
  const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = {1, 0}, .velocity = {0, spin}});
  scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_b = {1, 0}});
  const double law = turn * turn / (2 * setting.stabilization.baumgarte);
  return run_extreme(scene, setting,
                     {.seconds = 2,
                      .measure = {"drift (m)", joint_drift().of},
                      .limit = 1.5 * law,
                      .energy_gain = setting.stabilization.policy == Policy::relaxed ? 1 : 0.01});
}

/// A box that spins where it touches the ground.
ExtremeFinding spin_on_the_ground(double turn, const Setting& setting) {
  Scene scene;
  scene.add_ground({.half_width = 1e4});
  scene.add({.shapes = {box(1, 0.5)}, .position = {0, 0.6}, .angular_velocity = turn / setting.dt});
  return run_extreme(scene, setting,
                     {.seconds = 2, .measure = energy_gained(), .limit = 1e-3, .thinnest = 0.5, .floor = 0});
}

List<ExtremeCase> spin_cases() {
  struct Turn {
    std::string text;
    double angle;
  };
  AxisCases cases("spin");
  for (const Turn& turn :
       {Turn{"0.01", 0.01}, Turn{"0.1", 0.1}, Turn{"1", 1}, Turn{"pi", pi}, Turn{"100", 100}}) {
    const double angle = turn.angle;
    for (const ExtremeSetting& tried : few_settings()) {
      const auto add = [&](const std::string& what, ExtremeVerdict required, const auto& run) {
        cases.add(turn.text + " rad, " + what, tried, required,
                  [angle, run](const Setting& setting) { return run(angle, setting); });
      };
      add("free", ExtremeVerdict::ok, free_spin);
      const Policy policy = tried.setting.stabilization.policy;
      const bool follows_law = angle <= 0.1 && (policy == Policy::baumgarte || policy == Policy::relaxed);
      add("on a rod", follows_law ? ExtremeVerdict::ok : ExtremeVerdict::bound, spin_on_a_rod);
      add("on the ground", ExtremeVerdict::bound, spin_on_the_ground);
    }
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> motion_axes() {
  const std::string few = "si under every policy, and one of each family";
  return {{"speed", "a fast body of 0.2 m against a wall of 0.1 m", few, speed_cases},
          {"spin", "so many radians a step", few, spin_cases}};
}

}  // namespace cairn
