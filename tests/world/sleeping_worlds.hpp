// What the tests of sleeping share: scenes that come to rest, and what is compared between worlds.
#pragma once

#include <cairn/samples/samples.hpp>
#include "testing.hpp"

namespace cairn::testing {

inline constexpr double sleep_gravity = 10;  // [m/s^2], the default of a scene
inline constexpr Sleeping usual_sleeping = {.speed = 0.05, .angular_speed = 0.05, .time = 0.5};
inline constexpr int usual_sleep_steps = 30;  // 0.5 s in steps of 1/60 s

/// Something to throw, 0.5 m in radius, that floats: nothing moves it before it is given a velocity.
inline BodyId add_missile(Scene& scene, const Vec2<double>& position, double mass) {
  return scene.add({.shapes = {circle(0.5)}, .position = position, .mass = mass, .gravity_scale = 0});
}

/// A stack of five.
inline Scene stack_scene(const SceneSettings& settings = {.sleeping = usual_sleeping}) {
  return samples::stack(5, settings);
}

/// A body with all of its island: as it moves already.
template <Scalar Real>
void wake(World<Real>& world, BodyId body) {
  world.set_velocity(body, world.bodies().velocity[body].template cast<double>());
}

template <Scalar Real>
StepReport sleep_steps(World<Real>& world, int steps, int iterations = 50) {
  return take_steps(world, steps, iterations);
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
