// Eight scenes, one loop that steps and measures them.
#include "wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ratio.hpp"

namespace cairn::edges {

namespace {

const double wall_thickness = 0.1;  // [m]

/// A scene and what is measured of it.
struct Plan {
  EdgeCase edge = {};
  Scene scene = Scene();
  double budget = 0;  // [J] the energy that it has to spend; infinite where errors in positions bring some
  std::function<double(const Snapshot&)> off = {};
};

SceneSettings resting() { return {.gravity = {0, -gravity}, .dt = time_step}; }

SceneSettings weightless(double beta) {
  return {.gravity = {0, 0}, .dt = time_step, .stabilization = {.baumgarte = beta}};
}

Vec2<double> place_of(const Snapshot& now) { return now.bodies.back().pose.position; }

/// How far the top of a tower is from where it was, as a share of the height.
Plan stack(const std::string& name, Scene scene, double height, double mass) {
  Plan plan{.edge = {.name = name, .quantity = "its height"}, .scene = std::move(scene)};
  plan.budget = mass * gravity * height;
  plan.off = [height](const Snapshot& now) { return std::abs(height - 0.5 - place_of(now).y()) / height; };
  plan.edge.view = {{-0.75 * height, -0.35}, {0.75 * height, 1.15 * height}};
  return plan;
}

Plan tower(const WallSettings& settings) {
  Scene scene(resting());
  scene.add_ground();
  for (int i = 0; i < settings.boxes; ++i) {
    scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .mass = 1, .fixed_rotation = true});
  }
  return stack(fmt::format("tower of {}", settings.boxes), std::move(scene), settings.boxes, settings.boxes);
}

/// Whether the ball is marked as fast.
enum class Speed { ignored, watched };

/// The wall could move, but it is heavy. At 45 m/s the ball's last place before it is 0.15 m away from it,
/// and the next one has its middle behind it.
Plan shot(const WallSettings& settings, const std::string& name, Speed kind) {
  Scene scene(weightless(0.2));
  scene.add({.shapes = {box(wall_thickness, 2)}, .mass = 1000, .fixed_rotation = true});
  scene.add({.shapes = {circle(ball_radius)},
             .position = {-5.2, 0},
             .velocity = {settings.speed, 0},
             .mass = 1,
             .fast = kind == Speed::watched});
  Plan plan{.edge = {.name = name, .quantity = "the ball"}, .scene = std::move(scene)};
  plan.budget = 0.5 * settings.speed * settings.speed;
  plan.off = [](const Snapshot& now) {
    const double face = now.bodies[1].pose.position.x() - wall_thickness / 2;
    return std::max(0.0, place_of(now).x() + ball_radius - face) / (2 * ball_radius);
  };
  plan.edge.view = {{-5.9, -2.2}, {2.5, 2.2}};
  return plan;
}

Plan pulled_back(const WallSettings& settings) {
  Scene scene(weightless(settings.beta));
  const BodyId body = scene.add({.shapes = {box(0.4, 0.4)}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = body});
  scene.displace(body, {pin_error, 0});
  Plan plan{.edge = {.name = fmt::format("pin, β = {:g}", settings.beta), .quantity = "the first error"},
            .scene = std::move(scene)};
  plan.budget = std::numeric_limits<double>::infinity();
  plan.off = [](const Snapshot& now) { return place_of(now).norm() / pin_error; };
  plan.edge.view = {{-1, -0.75}, {1, 0.75}};
  return plan;
}

Plan swung(const WallSettings& settings) {
  Scene scene(weightless(0.2));
  const double speed = settings.turn / time_step;
  const BodyId stone =
      scene.add({.shapes = {circle(0.15)}, .position = {1, 0}, .velocity = {0, speed}, .mass = 1});
  scene.join<DistanceJoint>({.a = ground, .b = stone, .anchor_a = {0, 0}, .anchor_b = {1, 0}});
  Plan plan{.edge = {.name = fmt::format("sling, {:g} rad", settings.turn), .quantity = "its rod"},
            .scene = std::move(scene)};
  plan.budget = 0.5 * speed * speed;
  plan.off = [](const Snapshot& now) { return std::abs(place_of(now).norm() - 1); };
  plan.edge.view = {{-1.9, -1.7}, {1.9, 1.7}};
  return plan;
}

Plan quarrelling() {
  Plan plan{.edge = {.name = "two pins", .quantity = "their distance"}, .scene = two_pins_scene()};
  plan.budget = std::numeric_limits<double>::infinity();
  plan.off = [](const Snapshot& now) {
    return std::max(place_of(now).norm(), (place_of(now) - Vec2<double>(pins_apart, 0)).norm()) / pins_apart;
  };
  plan.edge.view = {{-0.7, -0.6}, {1.1, 0.6}};
  return plan;
}

EdgeCase run_plan(const Plan& plan, const WallSettings& settings) {
  EdgeCase edge = plan.edge;
  World world(plan.scene);
  SequentialImpulse<double> solver({.iterations = settings.sweeps});
  edge.frames.push_back(snapshot(world));
  edge.off_by_step.push_back(plan.off(edge.frames[0]));
  const double start = total_energy(edge.frames[0]);
  for (int k = 1; k <= settings.steps; ++k) {
    world.step(solver);
    const Snapshot& now = edge.frames.emplace_back(snapshot(world));
    edge.off_by_step.push_back(plan.off(now));
    edge.off = std::max(edge.off, edge.off_by_step.back());
    edge.energy_gain = std::max(edge.energy_gain, (total_energy(now) - start) / plan.budget);
  }
  edge.stamp = stamp_of(edge);
  return edge;
}

}  // namespace

std::string stamp_text(Stamp stamp) {
  if (stamp == Stamp::ok) return "OK";
  return stamp == Stamp::soft ? "SOFT" : "BROKEN";
}

Stamp stamp_of(const EdgeCase& edge) {
  // A hundred roundings of slack: two pins are off by exactly their distance.
  if (!(edge.energy_gain <= 0.01) || !(edge.off <= 1 + 1e-13)) return Stamp::broken;
  return edge.off <= 0.01 ? Stamp::ok : Stamp::soft;
}

std::vector<EdgeCase> run_wall(const WallSettings& settings) {
  const std::string heavy = fmt::format("{:g} kg", settings.ratio);
  const double mass = 1 + settings.ratio;
  const std::string plain = fmt::format("ball, {:g} m/s", settings.speed);
  const std::vector<Plan> plans = {
      stack(heavy + " on 1 kg", two_boxes_scene(settings.ratio), 2, mass),
      stack("1 kg on " + heavy, two_boxes_scene(1 / settings.ratio), 2, 1 + 1 / settings.ratio),
      tower(settings),
      shot(settings, plain, Speed::ignored),
      shot(settings, "fast ball", Speed::watched),
      pulled_back(settings),
      swung(settings),
      quarrelling()};
  std::vector<EdgeCase> cases;
  for (const Plan& plan : plans) cases.push_back(run_plan(plan, settings));
  return cases;
}

Scene two_pins_scene() {
  Scene scene(weightless(pins_beta));
  const BodyId body = scene.add({.shapes = {box(0.3, 0.3)}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = body});
  scene.displace(body, {pins_apart, 0});
  scene.join<RevoluteJoint>({.a = ground, .b = body, .anchor = {pins_apart, 0}});
  return scene;
}

std::vector<double> quarrel(const EdgeCase& pins) {
  std::vector<double> given;
  for (const Snapshot& now : pins.frames)
    given.push_back(now.joints[0].impulse.x() / (now.dt > 0 ? now.dt : time_step));
  return given;
}

double quarrel_by_formula(const WallSettings& settings, int step) {
  return -step * settings.sweeps * pins_beta * pins_apart / (time_step * time_step);
}

}  // namespace cairn::edges
