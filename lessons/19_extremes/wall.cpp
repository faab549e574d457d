// Four scenes, and what is measured of each.
#include "lesson.hpp"

#include <cairn/samples/samples.hpp>

namespace cairn::edges {

namespace {

SceneSettings resting() {
  return {
      .gravity = {0, -gravity}, .dt = time_step, .stabilization = {.policy = StabilizationPolicy::baumgarte}};
}

Vec2<double> place_of(const Snapshot& now) { return now.bodies.back().pose.position; }

/// How far the top of a tower is from where it was, as a share of the height.
SmallWorld stack(const std::string& name, Scene scene, double height, double mass) {
  SmallWorld world{.edge = {.name = name, .quantity = "its height"}, .scene = std::move(scene)};
  world.budget = mass * gravity * height;
  world.off = [height](const Snapshot& now) { return std::abs(height - 0.5 - place_of(now).y()) / height; };
  world.edge.top = height;
  const double shown = std::min(height, 4.0);  // of a tower its upper end, or nothing would be seen
  world.edge.view = {{-0.75 * shown, height - shown - 0.35}, {0.75 * shown, height + 0.15 * shown}};
  if (height > shown) world.edge.view = {{-0.75 * shown, height - 3}, {0.75 * shown, height + 2}};
  return world;
}

SmallWorld tower(const WallSettings& settings) {
  Scene scene(resting());
  scene.add_ground();
  samples::add_stack(scene, settings.boxes,
                     {.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 1, .fixed_rotation = true});
  return stack(fmt::format("tower of {}", settings.boxes), std::move(scene), settings.boxes, settings.boxes);
}

SmallWorld quarrelling() {
  SmallWorld world{.edge = {.name = "two pins", .quantity = "their distance"}, .scene = two_pins_scene()};
  world.budget = std::numeric_limits<double>::infinity();
  world.off = [](const Snapshot& now) {
    return std::max(place_of(now).norm(), (place_of(now) - Vec2<double>(pins_apart, 0)).norm()) / pins_apart;
  };
  world.edge.view = {{-0.3, -0.34}, {0.7, 0.3}};
  return world;
}

}  // namespace

std::string stamp_text(Stamp stamp) {
  const FixedList<std::string, 4> words = {"OK", "SOFT", "λ GROWS", "BROKEN"};
  return words[static_cast<int>(stamp)];
}

double worst(const List<double>& by_step, int step) {
  return *std::max_element(by_step.begin(), by_step.begin() + step + 1);
}

double pull_of(const EdgeCase& edge, int step) {
  const Snapshot& now = edge.frames[step];
  return step == 0 || now.joints.empty() ? 0 : now.joints[0].impulse.norm() / now.dt;
}

Stamp stamp_of(const EdgeCase& edge, int step) {
  const double off = worst(edge.off_by_step, step);
  // A hundred roundings of slack: two pins are off by exactly their distance.
  if (!(worst(edge.energy_by_step, step) <= 0.01) || !(off <= 1 + 1e-13)) return Stamp::broken;
  if (off <= 0.01) return Stamp::ok;
  // In the first steps any joint still finds its λ.
  const bool grows = step >= 10 && pull_of(edge, step) > 1.5 * pull_of(edge, step / 2);
  return grows ? Stamp::growing : Stamp::soft;
}

List<SmallWorld> small_worlds(const WallSettings& settings) {
  const std::string heavy = fmt::format("{:g} kg", settings.ratio);
  const double mass = 1 + settings.ratio;
  return {stack(heavy + " on 1 kg", two_boxes_scene(settings.ratio), 2, mass),
          stack("1 kg on " + heavy, two_boxes_scene(1 / settings.ratio), 2, mass), tower(settings),
          quarrelling()};
}

Scene two_pins_scene() {
  Scene scene({.gravity = {0, 0},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = pins_beta}});
  const BodyId body = scene.add({.shapes = {box(0.3, 0.3)}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = body});
  displace(scene, body, {pins_apart, 0});
  scene.join<RevoluteJoint>({.a = ground, .b = body, .anchor = {pins_apart, 0}});
  return scene;
}

double quarrel_by_formula(const WallSettings& settings, int step) {
  return step * settings.sweeps * pins_beta * pins_apart / (time_step * time_step);
}

}  // namespace cairn::edges
