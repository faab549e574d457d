// Boxes that fall, rest, swing from a pin, turn by a motor and lie in the limit of a joint: where each
// engine has them after a second.
#include <fmt/format.h>

#include <cmath>

#include "../table.hpp"
#include <cairn/constraints/revolute_joint.hpp>
#include "peer_list.hpp"
#include "peer_tables.hpp"

namespace cairn::bench {

namespace {

const int steps = 60;
const double height = 50;  // [m] that one box falls from
const double speed = 2;    // [rad/s] of the motor
const double tilt = 0.5;   // [rad] of the box in its limit

struct Check {
  Scene scene;
  BodyId falling = {}, resting = {}, swinging = {}, driven = {}, limited = {};
};

Check check_scene() {
  Check check;
  check.scene.add_ground();
  check.falling = check.scene.add({.shapes = {box(1, 1)}, .position = {-10, height}});
  check.resting = check.scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  check.swinging = check.scene.add({.shapes = {box(1, 1)}, .position = {12, 20}});
  check.scene.join<RevoluteJoint>({.a = ground, .b = check.swinging, .anchor = {10, 20}});
  check.driven = check.scene.add({.shapes = {box(1, 1)}, .position = {20, 20}});
  check.scene.join<RevoluteJoint>({.a = ground,
                                   .b = check.driven,
                                   .anchor = {20, 20},
                                   .motor = RevoluteJoint::Motor{.speed = speed, .max_torque = 1000}});
  check.limited = check.scene.add({.shapes = {box(1, 1)}, .position = {31, 20}, .angle = tilt});
  check.scene.join<RevoluteJoint>(
      {.a = ground, .b = check.limited, .anchor = {30, 20}, .lower = 0, .upper = 0.25});
  return check;
}

PerBody<Pose<double>> end_of(const Contestant& contestant, const Scene& scene) {
  const std::unique_ptr<Engine> engine = contestant.make(scene);
  for (int step = 0; step < steps; ++step) engine->step();
  return engine->poses();
}

/// Where the swinging box is by the pendulum's equation, angle'' = g r cos(angle) / (r^2 + I / m), in steps
/// so short that what they leave out is nothing beside what an engine's steps do.
Vec2<double> swung(const Check& check, double g, double time) {
  const SceneBody& body = check.scene.bodies()[check.swinging];
  const double r = 2;  // [m] from the pin to the centre
  const int count = 100'000;
  double angle = 0, rate = 0;  // below the level
  for (int i = 0; i < count; ++i) {
    rate += time / count * g * r * std::cos(angle) / (r * r + body.inertia / body.mass);
    angle += time / count * rate;
  }
  return {10 + r * std::cos(angle), 20 - r * std::sin(angle)};
}

/// The worst of the boxes in parts of what it may be off.
double worst_share(const Check& check, const PerBody<Pose<double>>& end) {
  const SceneSettings& settings = check.scene.settings();
  const double g = settings.gravity.norm(), time = steps * settings.dt;
  // Steps of order one: the exact way is g t^2 / 2, and theirs differs from it by g dt t / 2, at either side.
  // Single precision adds a millimetre: an ulp of 50 m is 4e-6 m in each step.
  const double allowed_of_way = g * settings.dt * time / 2 + 1e-3;
  // Two skins of 0.01 m (Box2D 2.4.1), or a slop of 0.005 m.
  const double allowed_at_rest = 0.02;
  const Vec2<double> fallen(-10, height - g * time * time / 2);
  const double falls = (end[check.falling].position - fallen).norm() / allowed_of_way;
  const double rests = (end[check.resting].position - Vec2<double>(0, 0.5)).norm() / allowed_at_rest;
  // The pendulum's end is steered by a force as large as gravity: twice the error of what falls freely.
  const double swings = (end[check.swinging].position - swung(check, g, time)).norm() / (2 * allowed_of_way);
  const double turns = std::abs(end[check.driven].angle - speed * time) / (speed * settings.dt + 1e-3);
  // A slop of two degrees, or of 0.005 m at the pin's distance of 1 m.
  const double lies = std::abs(end[check.limited].angle - tilt) / (2 * pi / 180);
  return std::max({falls, rests, swings, turns, lies});
}

}  // namespace

bool adapters_agree() {
  const Check check = check_scene();
  bool all_agree = true;
  TextTable table({{"engine", ""},
                   {"falls to", "m"},
                   {"rests at", "m"},
                   {"swings to", "m"},
                   {"turns to", "rad"},
                   {"lies at", "rad"},
                   {"off", "of allowed"}});
  for (const Contestant& one : usual_contestants()) {
    const PerBody<Pose<double>> end = end_of(one, check.scene);
    const double share = worst_share(check, end);
    all_agree = all_agree && share <= 1;
    const Vec2<double>& swinging = end[check.swinging].position;
    table.add({one.name, fmt::format("{:.4f}", end[check.falling].position.y()),
               fmt::format("{:.4f}", end[check.resting].position.y()),
               fmt::format("{:.3f}, {:.3f}", swinging.x(), swinging.y()),
               fmt::format("{:.4f}", end[check.driven].angle),
               fmt::format("{:.4f}", end[check.limited].angle), fmt::format("{:.2f}", share)});
  }
  print_heading("Do the adapters agree?");
  fmt::print(
      "A box falls from {} m for a second, one rests on the ground, one swings from a pin, one is turned by "
      "a\n"
      "motor of {} rad/s, and one lies in the limit of its joint, at {} rad.\n\n{}\n{}\n",
      height, speed, tilt, table.text(),
      all_agree ? "They agree." : "They do not agree: the tables would mean nothing.");
  return all_agree;
}

}  // namespace cairn::bench
