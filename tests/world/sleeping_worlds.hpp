// What the tests of sleeping share: scenes that come to rest, and what is compared between worlds.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "math/list.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

namespace cairn::testing {

inline constexpr double sleep_gravity = 10;  // [m/s^2], the default of a scene
inline constexpr Sleeping usual_sleeping = {.speed = 0.05, .angular_speed = 0.05, .time = 0.5};
inline constexpr int usual_sleep_steps = 30;  // 0.5 s in steps of 1/60 s

/// n boxes of 1 kg and 1 m, one on the other, at `x` [m]; the lowest first.
inline List<BodyId> add_stack(Scene& scene, int n, double x) {
  List<BodyId> boxes;
  for (int i = 0; i < n; ++i) boxes.push_back(scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5 + i}}));
  return boxes;
}

/// Something to throw, 0.5 m in radius, that floats: nothing moves it before it is given a velocity.
inline BodyId add_missile(Scene& scene, const Vec2<double>& position, double mass) {
  return scene.add({.shapes = {circle(0.5)}, .position = position, .mass = mass, .gravity_scale = 0});
}

/// A stack of five.
inline Scene stack_scene(const SceneSettings& settings = {.sleeping = usual_sleeping}) {
  Scene scene(settings);
  scene.add_ground();
  add_stack(scene, 5, 0);
  return scene;
}

template <Scalar Real>
bool same_poses(const World<Real>& first, const World<Real>& second) {
  bool same = true;
  for (const BodyId body : first.bodies().pose.indices()) {
    same = same && first.bodies().pose[body].position == second.bodies().pose[body].position &&
           first.bodies().pose[body].angle == second.bodies().pose[body].angle;
  }
  return same;
}

template <Scalar Real>
bool same_state(const World<Real>& first, const World<Real>& second) {
  bool same = same_poses(first, second) && first.bodies().velocity == second.bodies().velocity;
  for (const BodyId body : first.bodies().pose.indices()) {
    same = same && first.is_awake(body) == second.is_awake(body);
  }
  return same && first.last_step().problem.impulse == second.last_step().problem.impulse;
}

/// A body with all of its island: as it moves already.
template <Scalar Real>
void wake(World<Real>& world, BodyId body) {
  world.set_velocity(body, world.bodies().velocity[body].template cast<double>());
}

template <Scalar Real>
StepReport sleep_steps(World<Real>& world, int steps, int iterations = 50) {
  SequentialImpulse<Real> solver({.iterations = iterations});
  StepReport report;
  for (int i = 0; i < steps; ++i) report = world.step(solver);
  return report;
}

/// Steps the world until nothing is awake, at most `most` times: the number of steps.
template <Scalar Real>
int steps_until_asleep(World<Real>& world, int most = 2000) {
  SequentialImpulse<Real> solver({.iterations = 50});
  for (int step = 1; step <= most; ++step) {
    if (world.step(solver).awake.bodies == 0) return step;
  }
  return most + 1;
}

template <Scalar Real>
int count_awake(const World<Real>& world, const List<BodyId>& bodies) {
  return static_cast<int>(
      std::count_if(bodies.begin(), bodies.end(), [&](BodyId body) { return world.is_awake(body); }));
}

template <Scalar Real>
double largest_speed(const World<Real>& world, const List<BodyId>& bodies) {
  double largest = 0;
  for (const BodyId body : bodies) {
    const Vec3<Real>& v = world.bodies().velocity[body];
    largest = std::max(largest, static_cast<double>(v.template head<2>().norm()));
  }
  return largest;
}

}  // namespace cairn::testing
