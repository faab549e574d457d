// Floor 8. Joints that break, sensors, one-way bodies and events that set a velocity.
#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double held_mass = 3;           // [kg]
const double rod_length = 2;          // [m]
const double whirl_speed = 4;         // [rad/s]
const double event_rounding = 1e-12;  // of a few operations, as a share

/// A disc on a rod that holds so much [N]: it hangs from the ground, or whirls about it without gravity.
Scene on_a_rod(double strength, double speed, double frequency) {
  Scene scene({.gravity = {0, speed == 0 ? -standard_gravity : 0}, .dt = 1 / frequency});
  const Vec2<double> place(0, -rod_length);
  const BodyId disc = scene.add(
      {.shapes = {circle(0.3)}, .position = place, .velocity = {speed * rod_length, 0}, .mass = held_mass});
  scene.change(scene.join<DistanceJoint>({.b = disc, .anchor_b = place}), JointStrength{.force = strength});
  return scene;
}

/// [N] With which the rod broke in a second; 0 where it holds.
double breaking_force(const EngineMaker& make, double strength, double speed, double frequency) {
  const Snapshot end = run_scene(make, on_a_rod(strength, speed, frequency), 10, 1);
  return end.broken.empty() ? 0 : end.broken.front().force;
}

ValidationResult breaking_rod(const EngineMaker& make) {
  const double weight = held_mass * standard_gravity;
  const double pull = held_mass * whirl_speed * whirl_speed * rod_length;
  const std::string reason = "one row, solved to rounding";
  ValidationResult result;
  result.add(measured("force that breaks a rod of a strength just below m g",
                      breaking_force(make, weight * (1 - 1e-9), 0, 60), "N")
                 .by("m g", weight)
                 .within_share(event_rounding, reason));
  result.add(measured("force that breaks a rod of a strength just above m g",
                      breaking_force(make, weight * (1 + 1e-9), 0, 60), "N")
                 .zero_within(0, "it holds"));
  // A step turns the rod by w dt, whose square the force is off by.
  const double share = std::pow(whirl_speed * standard_dt, 2);
  result.add(measured("force that breaks a whirling rod",
                      breaking_force(make, pull * (1 - share), whirl_speed, 60), "N")
                 .by("m w^2 r", pull)
                 .within_share(share, "the rod turns by w dt in a step: (w dt)^2"));
  result.add(measured("force that breaks a whirling rod of a strength above it",
                      breaking_force(make, pull * (1 + share), whirl_speed, 60), "N")
                 .zero_within(0, "it holds"));
  return result;
}

const double set_speed = 4;        // [m/s] v
const double set_friction = 0.25;  // mu
const double set_time = 0.5;       // [s] 30 steps at 60 Hz

/// A block that rests until an event sets its velocity.
Scene block_set_going(double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.material = {.friction = set_friction}});
  const BodyId block =
      scene.add({.shapes = {box(1, 0.5)}, .position = {0, 0.25}, .material = {.friction = set_friction}});
  scene.add({.time = set_time, .action = ChangeBody{.body = block, .velocity = Vec2<double>(set_speed, 0)}});
  return scene;
}

// Every step takes mu g dt from the speed, and goes as far as the speed that is left: v dt/2 less in all.
ValidationResult velocity_of_event(const EngineMaker& make) {
  const double ideal = set_speed * set_speed / (2 * set_friction * standard_gravity);
  ValidationResult result;
  const Snapshot end = run_scene(make, block_set_going(60), 50, 3);
  result.add(measured("way until it stops at 60 Hz", end.bodies.back().pose.position.x(), "m")
                 .by("v^2/(2 mu g) - v dt/2", ideal - set_speed * standard_dt / 2)
                 .within(1e-9, "the sums are exact; 50 sweeps of a contact at two points leave rounding"));
  result.convergence = converges("way until it stops, to v^2/(2 mu g)", [&](double frequency) {
    return run_scene(make, block_set_going(frequency), 50, 3).bodies.back().pose.position.x() - ideal;
  });
  return result;
}

const double sensor_depth = 3;  // [m] from the lowest point of a disc down to the top of a sensor

/// [s] The end of the step in which the disc is first seen in the sensor.
double time_of_entry(const EngineMaker& make) {
  Scene scene({.dt = standard_dt});
  const BodyId disc = scene.add({.shapes = {circle(0.5)}, .position = {0, sensor_depth + 1}});
  const BodyId sensor = scene.add({.type = BodyType::static_body, .shapes = {box(4, 1)}, .sensor = true});
  scene.add({.action = CountTouches{"entered"}, .touch = TouchCondition{.a = {sensor}, .b = {disc}}});
  Motion motion(make, scene, 1);
  while (motion.now().counters.front().count == 0 && motion.time() < 2) motion.step();
  return motion.time();
}

ValidationResult sensor_entry(const EngineMaker& make) {
  ValidationResult result;
  // n steps fall g dt^2 n (n + 1) / 2, which is dt / 2 early, to the next whole step, which begins in it.
  result.add(measured("time at which a fall of h is seen to have entered", time_of_entry(make), "s")
                 .by("sqrt(2 h/g) + dt", std::sqrt(2 * sensor_depth / standard_gravity) + standard_dt)
                 .within(standard_dt / 2, "a step is seen as a whole: dt/2 either way"));
  return result;
}

const double shelf_throw = 9, shelf_ball = 0.3, shelf_top = 2;  // [m/s], [m], [m]

Scene under_a_shelf() {
  Scene scene({.dt = standard_dt});
  scene.add_ground();
  scene.add({.type = BodyType::static_body,
             .shapes = {box(4, 0.3)},
             .position = {0, shelf_top - 0.15},
             .filter = {.one_way = {0, 1}}});
  scene.add({.shapes = {circle(shelf_ball)}, .position = {0, shelf_ball}, .velocity = {0, shelf_throw}});
  return scene;
}

ValidationResult one_way_shelf(const EngineMaker& make) {
  Motion motion(make, under_a_shelf(), 10);
  const BodyId ball{2};
  double top = 0;
  while (motion.time() < 3) {
    motion.step();
    top = std::max(top, motion.position(ball).y());
  }
  const double ideal = shelf_ball + shelf_throw * shelf_throw / (2 * standard_gravity);
  ValidationResult result;
  result.add(measured("highest place of a ball thrown up through it", top, "m")
                 .by("r + v^2/(2 g) - v dt/2", ideal - shelf_throw * standard_dt / 2)
                 .within(standard_gravity * standard_dt * standard_dt / 8,
                         "the top lies between two steps: g dt^2/8"));
  result.add(measured("where it lies in the end", motion.position(ball).y(), "m")
                 .by("top + r", shelf_top + shelf_ball)
                 .within(usual_slop, "it may keep the slop"));
  return result;
}

}  // namespace

void add_event_cases(ValidationCases& cases) {
  cases.push_back({.id = "B70",
                   .title = "A rod breaks above the m g that it hangs, or the m w^2 r that it whirls",
                   .run = breaking_rod});
  cases.push_back({.id = "B71",
                   .title = "A block that an event gives a speed v stops after v^2 / (2 mu g), less v dt / 2",
                   .asks = Asks::any_engine,
                   .run = velocity_of_event});
  cases.push_back({.id = "B72",
                   .title = "A body that falls by h enters a sensor after sqrt(2 h / g), to a step",
                   .run = sensor_entry});
  cases.push_back(
      {.id = "B73",
       .title = "A ball flies up through a one-way shelf as if it were not there, and lands on it",
       .run = one_way_shelf});
}

}  // namespace cairn
