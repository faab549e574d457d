// Floor 9. Rows that are hard to solve: hardly any inertia, the same said twice, and contradictions.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/prismatic_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/constraints/weld_joint.hpp>
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/measure/trajectory.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

/// A body of 1 kg and hardly any inertia, pinned 1 m from its centre: its two rows are nearly one. It can
/// fall by 2 m: 20 J.
Scene pinned_far_out(double inertia) {
  Scene scene;
  const BodyId body = scene.add({.position = {0.6, -0.8}, .mass = 1, .inertia = inertia});
  scene.join<RevoluteJoint>({.a = ground, .b = body, .anchor = {0, 0}});
  return scene;
}

/// The same hung on a rod: one row, which the inertia has no part in.
Scene hung_on_a_rod(double inertia) {
  Scene scene;
  const BodyId body = scene.add({.position = {0.6, -0.8}, .mass = 1, .inertia = inertia});
  scene.join<DistanceJoint>({.a = ground, .b = body, .anchor_b = {0.6, -0.8}});
  return scene;
}

List<ExtremeCase> inertia_cases() {
  AxisCases cases("inertia");
  for (const double inertia : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    const auto add = [&](const std::string& what, const Setting& setting, bool quick, Scene (*make)(double)) {
      cases.add(fmt::format("{:g}, {}", inertia, what), {setting, quick}, ExtremeVerdict::ok,
                [inertia, make](const Setting& tried) {
                  return run_extreme(
                      make(inertia), tried,
                      {.seconds = 5, .measure = joint_drift(), .limit = 0.05, .energy_scale = 20});
                });
    };
    add("pin", setting_of("block", 10), true, pinned_far_out);
    add("pin", setting_of("block-contact", 10), false, pinned_far_out);
    add("pin", setting_of("block", 10, Policy::soft), false, pinned_far_out);
    add("pin", setting_of("block", 10, Policy::split_impulse), false, pinned_far_out);
    add("pin", setting_of("reference", 1), false, pinned_far_out);
    add("rod", setting_of("si", 10), true, hung_on_a_rod);
  }
  return cases.all();
}

/// What one step makes of a ball on a rod that is there `copies` times.
PerBody<Vec3<double>> velocities_with(int copies, const Setting& setting) {
  Scene scene = scene_for(setting);
  const BodyId ball = scene.add({.shapes = {circle(0.1)}, .position = {0.8, -0.6}, .mass = 2});
  for (int i = 0; i < copies; ++i)
    scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_b = {0.8, -0.6}});
  World<double> world(scene);
  const auto solver = make_solver<double>(setting.solver, setting.sweeps);
  for (int step = 0; step < 10; ++step) world.step(*solver);
  return world.bodies().velocity;
}

ExtremeFinding copies_change_nothing(int copies, const Setting& setting) {
  const PerBody<Vec3<double>> once = velocities_with(1, setting), often = velocities_with(copies, setting);
  double gap = 0;
  for (const BodyId body : once.indices())
    gap = std::max(gap, (once[body] - often[body]).cwiseAbs().maxCoeff());
  return judged("velocity beside one copy (m/s)", gap, 1e-9, 1e-9);
}

/// A square of four bars, pinned at its corners and braced by a rod that it does not need.
Scene braced_square() {
  Scene scene;
  const auto bar = [&](double x, double y, double wide, double high) {
    return scene.add(
        {.shapes = {box(wide, high)}, .position = {x, y}, .mass = 1, .filter = {.collides_with = 0}});
  };
  const BodyId low = bar(0.5, 0, 1, 0.1), right = bar(1, 0.5, 0.1, 1), high = bar(0.5, 1, 1, 0.1),
               left = bar(0, 0.5, 0.1, 1);
  scene.join<WeldJoint>({.a = ground, .b = low, .anchor = {0, 0}});
  scene.join<RevoluteJoint>({.a = low, .b = right, .anchor = {1, 0}});
  scene.join<RevoluteJoint>({.a = right, .b = high, .anchor = {1, 1}});
  scene.join<RevoluteJoint>({.a = high, .b = left, .anchor = {0, 1}});
  scene.join<RevoluteJoint>({.a = left, .b = low, .anchor = {0, 0}});
  scene.join<DistanceJoint>({.a = low, .b = high, .anchor_a = {0, 0}, .anchor_b = {1, 1}});
  scene.join<DistanceJoint>({.a = low, .b = high, .anchor_a = {1, 0}, .anchor_b = {0, 1}});
  return scene;
}

/// Two bars in one line, held at both ends: the rows along the line say the same, and A has no inverse.
Scene straight_linkage() {
  Scene scene;
  const BodyId a = scene.add({.shapes = {box(1, 0.1)}, .position = {0.5, 0}, .mass = 1});
  const BodyId b = scene.add({.shapes = {box(1, 0.1)}, .position = {1.5, 0}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = a, .anchor = {0, 0}});
  scene.join<RevoluteJoint>({.a = a, .b = b, .anchor = {1, 0}});
  scene.join<RevoluteJoint>({.a = b, .b = ground, .anchor = {2, 0}});
  return scene;
}

Scene ring_of_welds() {
  const int count = 8;
  Scene scene({.gravity = {0, 0}});
  List<BodyId> ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    ring.push_back(scene.add({.shapes = {circle(0.2)},
                              .position = {std::cos(angle), std::sin(angle)},
                              .velocity = {i == 0 ? 1.0 : 0.0, 0}}));
  }
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + 0.5) / count;
    scene.join<WeldJoint>(
        {.a = ring[i], .b = ring[(i + 1) % count], .anchor = {std::cos(angle), std::sin(angle)}});
  }
  return scene;
}

struct RowScene {
  std::string name;
  Scene (*make)();
  double stored = 0;  // [J] that the errors which it begins with may give it
};

List<ExtremeSetting> settings_for_rows() {
  List<ExtremeSetting> settings = usual_settings();
  settings[3].quick = false;
  settings.push_back({setting_of("block", 10), true});
  settings.push_back({setting_of("reference", 1), false});
  return settings;
}

List<ExtremeCase> redundancy_cases() {
  AxisCases cases("redundancy");
  for (const ExtremeSetting& tried : settings_for_rows()) {
    // Springs, which soft rows are, add up: only rigid rows may be said again.
    const bool rigid = tried.setting.stabilization.policy != Policy::soft;
    for (const int copies : {2, 10, 100}) {
      if (!rigid) continue;
      cases.add(fmt::format("{} copies", copies), tried, ExtremeVerdict::ok,
                [copies](const Setting& setting) { return copies_change_nothing(copies, setting); });
    }
    for (const RowScene& scene :
         {RowScene{"braced square", braced_square}, RowScene{"straight linkage", straight_linkage},
          RowScene{"ring of welds", ring_of_welds}}) {
      cases.add(scene.name, tried, ExtremeVerdict::bound, [make = scene.make](const Setting& setting) {
        return run_extreme(make(), setting, {.measure = joint_drift(), .limit = 0.01, .thinnest = 1e300});
      });
    }
  }
  return cases.all();
}

/// A ball of 0.4 m pinned to two places 0.5 m apart. Of that error a quarter of the ball counts, so that the
/// rows ask for 0.2 * 0.1 m * 60 Hz = 1.2 m/s and for none: the compromise of least squares, 0.6 m/s, gives 1
/// kg 0.18 J.
Scene pinned_twice() {
  Scene scene;
  const BodyId ball = scene.add({.shapes = {circle(0.2)}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = ball, .anchor = {0, 0}});
  displace(scene, ball, {0.5, 0});
  scene.join<RevoluteJoint>({.a = ground, .b = ball, .anchor = {0.5, 0}});
  return scene;
}

/// A box of 1 kg and 1 m in a slot of 0.9 m: 5 cm in each wall, 4.5 cm more than the slop. A wall pushes a
/// body out by half the speed of a fall through that, sqrt(g d / 2), and so may give it m g d / 4; two walls
/// 0.225 J.
Scene narrow_slot() {
  Scene scene;
  scene.add_ground();
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 3)}, .position = {-0.95, 1.5}});
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 3)}, .position = {0.95, 1.5}});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  return scene;
}

/// Two motors of the same strength and endurance that want a slider to go both ways.
Scene quarrelling_motors() {
  Scene scene({.gravity = {0, 0}});
  const BodyId slider = scene.add({.shapes = {box(0.5, 0.5)}, .mass = 1});
  for (const double speed : {1.0, -1.0})
    scene.join<PrismaticJoint>(
        {.a = ground, .b = slider, .motor = PrismaticJoint::Motor{.speed = speed, .max_force = 100}});
  return scene;
}

/// The largest impulse after ten seconds over that after one: 1 where it is bounded, 10 where it drifts.
double impulse_growth(const Scene& scene, const Setting& setting) {
  Scene twin = scene;
  twin.set_settings(with_setting(scene.settings(), setting));
  World<double> world(twin);
  const auto solver = make_solver<double>(setting.solver, setting.sweeps);
  double early = 0, late = 0;
  for (int step = 0; step < 600; ++step) {
    if (world.step(*solver).not_finite) return INFINITY;
    double& largest = step < 60 ? early : late;
    if (step >= 60 && step < 540) continue;
    for (const double impulse : world.last_step().problem.impulse)
      largest = std::max(largest, std::abs(impulse));
  }
  return early > 0 ? late / early : 0;
}

List<ExtremeCase> contradiction_cases() {
  AxisCases cases("contradiction");
  for (const ExtremeSetting& tried : settings_for_rows()) {
    for (const RowScene& scene :
         {RowScene{"pinned twice", pinned_twice, 0.18}, RowScene{"narrow slot", narrow_slot, 0.225},
          RowScene{"two motors", quarrelling_motors}}) {
      cases.add(scene.name + ", motion", tried, ExtremeVerdict::bound,
                [make = scene.make, stored = scene.stored](const Setting& setting) {
                  const double scale = energy_scale(snapshot(World<double>(make())));  // [J]
                  return run_extreme(make(), setting,
                                     {.measure = energy_gained(),
                                      .limit = 1e-6,
                                      .energy_gain = 0.01 + (scale > 0 ? stored / scale : 0)});
                });
      cases.add(scene.name + ", impulses", tried, ExtremeVerdict::bound,
                [make = scene.make](const Setting& setting) {
                  return judged("impulse after 10 s / 1 s", impulse_growth(make(), setting), 1.1, 2);
                });
    }
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> row_axes() {
  const std::string usual = "si and block under every policy, block-contact, PGS, accelerated, reference";
  return {{"inertia", "so much inertia [kg m^2] of 1 kg, pinned 1 m off", "blocks, and si on a rod",
           inertia_cases},
          {"redundancy", "rows that say the same", usual, redundancy_cases},
          {"contradiction", "rows that no impulses can satisfy", usual, contradiction_cases}};
}

}  // namespace cairn
