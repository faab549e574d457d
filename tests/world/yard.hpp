// A scene with a bit of everything, for tests that change it while it runs.
#pragma once

#include <algorithm>

#include "constraints/revolute_joint.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

namespace cairn::test {

/// A pile of boxes that lean on each other, a chain that swings, and a box that lies by itself.
struct Yard {
  Scene scene;
  List<BodyId> pile = {};
  BodyId lonely = {};
  JointId pin = {};

  explicit Yard(const SceneSettings& settings = {}) : scene(settings) {
    scene.add_ground();
    for (int i = 0; i < 6; ++i) {
      pile.push_back(scene.add({.shapes = {box(1, 0.8)}, .position = {0.1 * (i % 2), 0.4 + 0.8 * i}}));
    }
    BodyId above = ground;
    for (int i = 0; i < 4; ++i) {
      const BodyId link = scene.add({.shapes = {box(1, 0.2)}, .position = {5.5 + i, 4}});
      pin = scene.join<RevoluteJoint>({.a = above, .b = link, .anchor = {5.0 + i, 4}});
      above = link;
    }
    lonely = scene.add({.shapes = {box(1, 1)}, .position = {-20, 0.5}});
  }
};

/// A solver of its own in every call: none keeps anything from step to step.
inline void run_steps(World<double>& world, int steps) {
  SequentialImpulse<double> solver({.iterations = 10});
  for (int i = 0; i < steps; ++i) world.step(solver);
}

/// Of the bodies that both have.
inline bool go_alike(const World<double>& one, const World<double>& other) {
  const int count = std::min(one.bodies().pose.size(), other.bodies().pose.size());
  bool same = one.clock().time == other.clock().time && one.clock().steps == other.clock().steps &&
              one.clock().dt == other.clock().dt;
  for (int i = 0; i < count; ++i) {
    const BodyId body{i};
    if (one.scene().bodies()[body].removed || other.scene().bodies()[body].removed) continue;
    const Pose<double>&left = one.bodies().pose[body], &right = other.bodies().pose[body];
    same = same && left.position == right.position && left.angle == right.angle &&
           one.bodies().velocity[body] == other.bodies().velocity[body] &&
           one.is_awake(body) == other.is_awake(body);
  }
  return same;
}

}  // namespace cairn::test
