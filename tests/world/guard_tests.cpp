// What a step does when it would leave the numbers, or begin worse than from nothing.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double guard_huge = std::numeric_limits<double>::max();

/// A disc in flight, and a body that the next step would throw out of the numbers.
Scene scene_with_runaway(int substeps, StabilizationPolicy policy) {
  Scene scene({.dt = 1, .substeps = substeps, .stabilization = {.policy = policy}});
  scene.add({.shapes = {circle(1)}, .position = {5, 0}, .velocity = {1, 0}});
  scene.add({.position = {0, 0.75 * guard_huge},
             .velocity = {0, 0.75 * guard_huge},
             .mass = 1,
             .fixed_rotation = true});
  return scene;
}

/// Two boxes on the ground, a rod that swings on a pin, and body 4, which floats far above them.
Scene scene_with_floating_body(const SceneSettings& settings) {
  Scene scene(settings);
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 1.5}});
  const BodyId rod = scene.add({.shapes = {box(2, 0.2)}, .position = {600, 3}});
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {599, 3}});
  scene.add({.position = {0, 1000}, .mass = 1, .gravity_scale = 0, .fixed_rotation = true});
  return scene;
}

template <Scalar Real>
void guard_take_steps(World<Real>& world, int count) {
  SequentialImpulse<Real> solver;
  for (int step = 0; step < count; ++step) CHECK_FALSE(world.step(solver).not_finite.has_value());
}

/// A world that is asked for a step that leaves the numbers goes on as its twin that never was.
template <Scalar Real>
void check_as_if_never_asked(const SceneSettings& settings, int steps_before) {
  World<Real> world(scene_with_floating_body(settings));
  guard_take_steps(world, steps_before);
  World<Real> twin = world;
  const BodyId floating{4};
  SequentialImpulse<Real> solver;
  // A substep is longer than 2 s then, and half of the largest number more than doubles.
  world.set_dt(4.0 * settings.substeps);
  world.set_velocity(floating, {0, static_cast<double>(std::numeric_limits<Real>::max() / 2), 0});
  CHECK(world.step(solver).not_finite == floating);
  for (const BodyId body : {BodyId{1}, BodyId{2}, BodyId{3}}) {
    CHECK(pose_of(world, body).position == pose_of(twin, body).position);
    CHECK(velocity_of(world, body) == velocity_of(twin, body));
    CHECK(world.is_awake(body) == twin.is_awake(body));
  }
  world.set_dt(settings.dt);
  for (World<Real>* each : {&world, &twin}) {
    each->set_velocity(floating, {0, 0, 0});
    guard_take_steps(*each, 40);
  }
  CHECK(same_motion(world, twin));
}

/// SequentialImpulse, but what it does last in its solve number `bad` is to lose the spin of body 2.
class LosingSolver final : public Solver<double> {
 public:
  explicit LosingSolver(int bad) : bad_(bad) {}
  std::string name() const override { return "losing"; }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* observer = nullptr) override {
    const SolveReport report = solver_.solve(problem, observer);
    if (++solves_ == bad_) problem.velocity[{2}].z() = std::numeric_limits<double>::quiet_NaN();
    return report;
  }

 private:
  SequentialImpulse<double> solver_{};
  int bad_ = 0;
  int solves_ = 0;
};

}  // namespace

TEST_CASE("a step that would leave the numbers moves nothing, names the body, and lets time go on") {
  for (const StabilizationPolicy policy : every_policy) {
    World<double> world(scene_with_runaway(1, policy));
    SequentialImpulse<double> solver;
    for (int step = 1; step <= 3; ++step) {
      const StepReport report = world.step(solver);
      CHECK(report.not_finite == BodyId{2});
      CHECK(world.bodies().pose[{1}].position == Vec2<double>(5, 0));
      CHECK(world.bodies().velocity[{1}] == Vec3<double>(1, 0, 0));
      CHECK(world.bodies().pose[{2}].position.y() == 0.75 * guard_huge);
      CHECK(world.clock().time == step);
      CHECK(world.clock().steps == step);
    }
    world.set_velocity({2}, {0, 0, 0});
    CHECK_FALSE(world.step(solver).not_finite.has_value());
    CHECK(world.bodies().pose[{1}].position.x() == 6);
  }
}

TEST_CASE("of a step with substeps those before the bad one are done") {
  World<double> world(scene_with_runaway(4, StabilizationPolicy::none));
  SequentialImpulse<double> solver;
  // 0.75 + 0.25 * 0.75 = 0.9375 of the largest number after one substep, 1.125 after two.
  CHECK(world.step(solver).not_finite == BodyId{2});
  CHECK(world.bodies().pose[{1}].position.x() == 5.25);
  CHECK(world.bodies().pose[{2}].position.y() == 0.9375 * guard_huge);
}

TEST_CASE("after a step that was not done, a world goes on as if it had never been asked for it") {
  for (const StabilizationPolicy policy : every_policy) {
    for (const int substeps : {1, 4}) {
      const SceneSettings settings{.substeps = substeps, .stabilization = {.policy = policy}};
      CAPTURE(static_cast<int>(policy));
      CAPTURE(substeps);
      check_as_if_never_asked<float>(settings, 25);
      check_as_if_never_asked<double>(settings, 25);
    }
  }
}

TEST_CASE("a step that was not done wakes nobody, and puts nobody to sleep") {
  const SceneSettings settings{.sleeping = Sleeping{.time = 0.2}};
  World<double> world(scene_with_floating_body(settings));
  guard_take_steps(world, 60);
  CHECK_FALSE(world.is_awake({1}));
  CHECK(world.is_awake({3}));
  check_as_if_never_asked<double>(settings, 5);   // nobody sleeps yet
  check_as_if_never_asked<double>(settings, 60);  // the boxes do
}

TEST_CASE("what a solver loses is found in the solve it happens in, whatever the solve is for") {
  struct Lost {
    StabilizationPolicy policy;
    int solves;  // of a step
  };
  for (const Lost& lost : {Lost{StabilizationPolicy::none, 1}, Lost{StabilizationPolicy::baumgarte, 1},
                           Lost{StabilizationPolicy::soft, 2}, Lost{StabilizationPolicy::split_impulse, 2}}) {
    for (int bad = 1; bad <= lost.solves; ++bad) {
      World<double> world(scene_with_floating_body({.stabilization = {.policy = lost.policy}}));
      guard_take_steps(world, 25);
      World<double> twin = world;
      LosingSolver solver(bad);
      CAPTURE(static_cast<int>(lost.policy));
      CAPTURE(bad);
      const std::optional<BodyId> found = world.step(solver).not_finite;
      CHECK(found.has_value());
      if (bad == lost.solves) CHECK(found == BodyId{2});  // a solve after it would hand it on to others
      CHECK(same_motion(world, twin));
      guard_take_steps(world, 10);
      guard_take_steps(twin, 10);
      CHECK(same_motion(world, twin));
    }
  }
}

TEST_CASE("an angle that would leave the numbers stops the step as a position does") {
  Scene scene({.dt = 1});
  scene.add({.shapes = {circle(1)}, .angle = 0.75 * guard_huge, .angular_velocity = 0.75 * guard_huge});
  World<double> world(scene);
  CHECK(take_steps(world, 1).not_finite == BodyId{1});
  CHECK(world.bodies().pose[{1}].angle == 0.75 * guard_huge);
}

TEST_CASE("a body beyond the numbers of a scalar type, or no longer than their spacing there, is refused") {
  const auto make = [](double place, double speed) {
    Scene scene;
    scene.add({.shapes = {box(1, 1)}, .position = {place, 0}, .velocity = {0, speed}});
    return scene;
  };
  // A float has 24 bits: neighbours are 2^-23 of a power of two apart, and so 1 m from 2^23 m on.
  const double far = 8388608;
  CHECK_NOTHROW(World<float>(make(far - 1, 0)));
  CHECK_THROWS_AS(World<float>(make(far, 0)), std::invalid_argument);
  CHECK_NOTHROW(World<double>(make(far, 0)));
  CHECK_THROWS_AS(World<double>(make(far * 536870912, 0)), std::invalid_argument);  // 2^52
  CHECK_NOTHROW(World<float>(make(0, 1e38)));
  CHECK_THROWS_AS(World<float>(make(0, 1e39)), std::invalid_argument);
}

TEST_CASE("a body of a tenth of a millimetre may sink in by a share of itself, not by the slop") {
  const double size = 1e-4;  // [m]; the slop of 5 mm is 50 times as much
  Scene scene;
  scene.add_ground();
  const BodyId small = scene.add({.shapes = {box(size, size)}, .density = 1000});  // half in the ground
  World<double> world(scene);
  SequentialImpulse<double> solver;
  for (int step = 0; step < 120; ++step) {
    world.step(solver);
    world.set_velocity(small, {0, 0, 0});  // what Baumgarte leaves would throw it up
  }
  // A twentieth of it is left alone: every step takes a fifth of what is above that.
  const double depth = size / 2 - world.bodies().pose[{1}].position.y();
  CHECK(depth < 0.06 * size);
  CHECK(depth > -0.05 * size);
}

TEST_CASE("a step tells how many joints are apart by more than a body, and how many bodies are halfway in") {
  for (const double share : {0.95, 1.05}) {
    Scene scene({.gravity = {0, 0}});
    const BodyId pinned = scene.add({.shapes = {circle(0.2)}, .position = {5, 0}});
    scene.join<RevoluteJoint>({.a = ground, .b = pinned, .anchor = {5, 0}});
    displace(scene, pinned, {0.2 * share, 0});
    scene.add({.shapes = {box(1, 1)}});
    scene.add({.shapes = {box(1, 2)}, .position = {1 - 0.5 * share, 0}});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    const StepReport report = world.step(solver);
    CHECK(report.joints_apart == (share > 1 ? 1 : 0));
    CHECK(report.too_deep == (share > 1 ? 1 : 0));
    for (int step = 0; step < 60; ++step) world.step(solver);
    CHECK(world.step(solver).joints_apart == 0);
  }
}
