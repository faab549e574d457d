// What becomes of an overlap and of a joint's drift under each stabilization policy.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/cairn.hpp>
#include <cairn/math/list.hpp>
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

struct PolicyLine {
  std::string name = {};
  Stabilization stabilization = {};
  int substeps = 1;
};

List<PolicyLine> policy_lines() {
  using Policy = StabilizationPolicy;
  return {{"none", {.policy = Policy::none, .slop = 0}},
          {"Baumgarte, beta = 0.2",
           {.policy = Policy::baumgarte, .slop = 0, .max_speed = std::numeric_limits<double>::infinity()}},
          {"Baumgarte, at most 0.5 m/s", {.policy = Policy::baumgarte, .slop = 0, .max_speed = 0.5}},
          {"relaxed", {.policy = Policy::relaxed, .slop = 0}},
          {"relaxed, 4 substeps", {.policy = Policy::relaxed, .slop = 0}, 4},
          {"soft, 30 Hz, with relaxing", {.policy = Policy::soft, .slop = 0}},
          {"soft, 4 substeps", {.policy = Policy::soft, .slop = 0}, 4},
          {"split impulse", {.policy = Policy::split_impulse, .slop = 0}}};
}

struct PolicyPop {
  double speed = 0;  // [m/s] the fastest that it leaves with
  double apex = 0;   // [m] above rest
  int steps = -1;    // until a tenth of the overlap is left; -1: never
};

/// A ball of 1 m that begins 0.1 m deep in the ground, at rest, for ten seconds.
PolicyPop policy_pop(const PolicyLine& line) {
  const double depth = 0.1;
  Scene scene({.dt = 1.0 / 240, .substeps = line.substeps, .stabilization = line.stabilization});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5 - depth}});
  World<double> world(scene);
  SequentialImpulse<double> solver;
  PolicyPop pop{.apex = -depth};
  for (int step = 1; step <= 2400; ++step) {
    world.step(solver);
    const double room = world.bodies().pose[{1}].position.y() - 0.5;
    pop.speed = std::max(pop.speed, world.bodies().velocity[{1}].y());
    pop.apex = std::max(pop.apex, room);
    if (pop.steps < 0 && room >= -0.1 * depth) pop.steps = step;
  }
  return pop;
}

struct PolicySwing {
  double drift = 0;   // [m] the worst of ten seconds
  double energy = 0;  // [J] at their end, less that of the start
};

/// A rod of 1 kg and 2 m falls from the level on a pin at its end.
PolicySwing policy_swing(const PolicyLine& line) {
  Scene scene({.substeps = line.substeps, .stabilization = line.stabilization});
  const BodyId rod = scene.add({.shapes = {box(2, 0.1)}, .position = {1, 0}, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 20});
  const double start = total_energy(snapshot(world));
  PolicySwing swing;
  for (int step = 0; step < 600; ++step) {
    world.step(solver);
    swing.drift = std::max(swing.drift, worst_joint_drift(snapshot(world)));
  }
  swing.energy = total_energy(snapshot(world)) - start;
  return swing;
}

}  // namespace

void print_policy_table() {
  print_heading("8. Stabilization: what becomes of errors in positions");
  fmt::print(
      "A ball that begins 0.1 m deep in the ground: how fast it leaves, how far above rest it comes, and\n"
      "after how many steps of 1/240 s a tenth of the overlap is left. A rod that swings on a pin for ten\n"
      "seconds, at 1/60 s: its worst drift, and what becomes of its energy. Slop is 0.\n\n");
  TextTable table({{"policy", ""},
                   {"leaves at", "m/s"},
                   {"apex", "m"},
                   {"nine tenths", "steps"},
                   {"worst drift", "m"},
                   {"energy", "J"}});
  for (const PolicyLine& line : policy_lines()) {
    const PolicyPop pop = policy_pop(line);
    const PolicySwing swing = policy_swing(line);
    table.add({line.name, fmt::format("{:.3f}", pop.speed), fmt::format("{:+.4f}", pop.apex),
               pop.steps < 0 ? "never" : std::to_string(pop.steps), fmt::format("{:.4f}", swing.drift),
               fmt::format("{:+.3f}", swing.energy)});
  }
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
