// Floor 9. From ice to glue, and from clay to rubber.
#include <fmt/format.h>

#include <cmath>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

Scene sliding_block(double friction) {
  Scene scene;
  scene.add_ground({.material = {.friction = friction}});
  scene.add({.shapes = {box(2, 0.2)},
             .position = {0, 0.1},
             .velocity = {2, 0},
             .material = {.friction = friction}});
  return scene;
}

/// It stops after v^2 / (2 mu g), or after 1 s it still has v t - mu g t^2 / 2 behind it.
ExtremeFinding slide(double friction, const Setting& setting) {
  const double v = 2, g = 10, seconds = 1,
               end = friction > 0 ? std::min(seconds, v / (friction * g)) : seconds;
  const double way = v * end - friction * g * end * end / 2;
  return run_extreme(sliding_block(friction), setting,
                     {.seconds = seconds,
                      .measure = {"error of the way (m)",
                                  [way](const TrialResult& run) { return std::abs(run.farthest - way); }},
                      .limit = v * setting.dt,  // friction acts from the end of the first step on
                      .thinnest = 0.2,
                      .floor = 0});
}

/// A rod that stands at 45 degrees on the ground and pushes itself in: where mu > 4/3 it has no one answer.
Scene leaning_rod(double friction) {
  const double length = 2, lean = pi / 4;
  Scene scene;
  scene.add_ground({.material = {.friction = friction}});
  scene.add({.shapes = {capsule({-length / 2, 0}, {length / 2, 0}, 0.05)},
             .position = {0, length / 2 * std::sin(lean) + 0.05},
             .angle = lean,
             .velocity = {-3, -1},
             .material = {.friction = friction}});
  return scene;
}

ExtremeFinding lean(double friction, const Setting& setting) {
  return run_extreme(
      leaning_rod(friction), setting,
      {.seconds = 2,
       .measure = {"penetration (m)", [](const TrialResult& run) { return run.worst_penetration; }},
       .limit = 0.02,
       .thinnest = 0.1,
       .floor = 0});
}

List<ExtremeCase> friction_cases() {
  AxisCases cases("friction");
  for (const double friction : {0.0, 1e-9, 0.5, 4.0 / 3, 10.0, 1e6}) {
    const std::string value = fmt::format("{:.4g}", friction);
    for (const ExtremeSetting& tried : usual_settings()) {
      cases.add(value + ", a sliding box", tried, friction < 10 ? ExtremeVerdict::ok : ExtremeVerdict::bound,
                [friction](const Setting& setting) { return slide(friction, setting); });
      cases.add(value + ", a rod digs in", tried, ExtremeVerdict::bound,
                [friction](const Setting& setting) { return lean(friction, setting); });
    }
  }
  for (const double friction : {-1e-9, -1.0, double(INFINITY), double(NAN)}) {
    cases.add_refusal(shortest(friction), [friction] {
      Scene().add({.shapes = {box(1, 1)}, .material = {.friction = friction}});
    });
  }
  return cases.all();
}

/// A ball falls 1 m, and rebounds to e^2 m.
ExtremeFinding rebound(double restitution, const Setting& setting) {
  const double radius = 0.2, fall = 1, g = 10, speed = std::sqrt(2 * g * fall);
  Scene scene;
  scene.add_ground();
  scene.add(
      {.shapes = {circle(radius)}, .position = {0, radius + fall}, .material = {.restitution = restitution}});
  double before = fall, apex = 0;
  bool rises = false;
  const auto look = [&](const Snapshot& now) {
    const double height = now.bodies[{1}].pose.position.y() - radius;
    rises = rises || height > before + 1e-9;
    if (rises) apex = std::max(apex, height);
    before = height;
    return false;
  };
  const double expected = restitution * restitution * fall;
  // The ball meets the ground within a step: its speed is known to g dt, its place to v dt.
  const double limit = expected * (2 * g * setting.dt / speed) + restitution * speed * setting.dt + 0.01;
  return run_extreme(
      scene, setting,
      {.seconds = 1.2,
       .measure = {"error of the apex (m)", [&](const TrialResult&) { return std::abs(apex - expected); }},
       .limit = limit,
       .thinnest = 2 * radius,
       .floor = 0,
       // Velocities are half a step ahead of positions: m g v dt / 2 of m g h while it falls.
       .energy_gain = 0.01 + speed * setting.dt / (2 * fall),
       .energy_scale = pi * radius * radius * g * fall,
       .escaped = look});
}

List<ExtremeCase> restitution_cases() {
  AxisCases cases("restitution");
  for (const double restitution : {0.0, 0.5, 1.0}) {
    cases.add_usual(shortest(restitution), ExtremeVerdict::ok,
                    [restitution](const Setting& setting) { return rebound(restitution, setting); });
  }
  for (const double restitution : {-0.1, 1.0001, 2.0, double(NAN)}) {
    cases.add_refusal(shortest(restitution), [restitution] {
      Scene().add({.shapes = {circle(1)}, .material = {.restitution = restitution}});
    });
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> material_axes() {
  const std::string usual = "si and block under every policy, block-contact, PGS, accelerated";
  return {{"friction", "coefficients of friction", usual, friction_cases},
          {"restitution", "coefficients of restitution, a ball that falls 1 m", usual, restitution_cases}};
}

}  // namespace cairn
