// Eight scenes, and what is measured of each.
#include "lesson.hpp"

#include <cairn/samples/samples.hpp>

namespace cairn::edges {

namespace {

const double plate_thickness = 0.1;  // [m]

SceneSettings resting() {
  return {
      .gravity = {0, -gravity}, .dt = time_step, .stabilization = {.policy = StabilizationPolicy::baumgarte}};
}

SceneSettings weightless(double beta) {
  return {.gravity = {0, 0},
          .dt = time_step,
          .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta}};
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

/// The plate could move, but it is heavy. At 45 m/s the ball's last place before it is 0.15 m away from it,
/// and the next one would have its middle behind it.
SmallWorld shot(double speed) {
  Scene scene(weightless(0.2));
  scene.add({.shapes = {box(plate_thickness, 2)}, .mass = 1000, .fixed_rotation = true});
  scene.add({.shapes = {circle(ball_radius)}, .position = {-5.2, 0}, .velocity = {speed, 0}, .mass = 1});
  SmallWorld world{
      .edge = {.name = fmt::format("ball on a plate, {:g} m/s", speed), .quantity = "the ball (front)"},
      .scene = std::move(scene)};
  world.budget = 0.5 * speed * speed;
  world.off = [](const Snapshot& now) {
    const double face = now.bodies[{1}].pose.position.x() - plate_thickness / 2;
    return std::max(0.0, place_of(now).x() + ball_radius - face) / (2 * ball_radius);
  };
  world.edge.view = {{-2.6, -1.5}, {2.6, 1.5}};  // the plate in the middle
  return world;
}

SmallWorld pulled_back(const WallSettings& settings) {
  Scene scene(weightless(settings.beta));
  const BodyId body = scene.add({.shapes = {box(0.4, 0.4)}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = body});
  displace(scene, body, {pin_error, 0});
  SmallWorld world{.edge = {.name = fmt::format("pin, β = {:g}", settings.beta),
                            .quantity = fmt::format("the first {:g} cm", 100 * pin_error)},
                   .scene = std::move(scene)};
  world.budget = std::numeric_limits<double>::infinity();
  world.off = [](const Snapshot& now) { return place_of(now).norm() / pin_error; };
  world.edge.view = {{-0.4, -0.4}, {0.8, 0.4}};
  return world;
}

SmallWorld swung(const WallSettings& settings) {
  Scene scene(weightless(0.2));
  const double speed = settings.turn / time_step;
  const BodyId stone =
      scene.add({.shapes = {circle(0.15)}, .position = {1, 0}, .velocity = {0, speed}, .mass = 1});
  scene.join<DistanceJoint>({.a = ground, .b = stone, .anchor_a = {0, 0}, .anchor_b = {1, 0}});
  SmallWorld world{.edge = {.name = fmt::format("sling, {:g} rad", settings.turn), .quantity = "its rod"},
                   .scene = std::move(scene)};
  world.budget = 0.5 * speed * speed;
  world.off = [](const Snapshot& now) { return std::abs(place_of(now).norm() - 1); };
  world.edge.view = {{-1.5, -1.45}, {1.5, 1.45}};
  return world;
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
          stack("1 kg on " + heavy, two_boxes_scene(1 / settings.ratio), 2, mass),
          tower(settings),
          shot(settings.speed),
          shot(10 * settings.speed),
          pulled_back(settings),
          swung(settings),
          quarrelling()};
}

Scene two_pins_scene() {
  Scene scene(weightless(pins_beta));
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
