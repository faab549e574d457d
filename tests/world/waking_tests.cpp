// Waking: by what, which bodies, and that they go on as if they had only been held still.
#include <cairn/samples/samples.hpp>
#include "sleeping_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Two bars that hang from the ground, one below the other, by pins.
Scene hanging_scene(const SceneSettings& settings) {
  Scene scene(settings);
  samples::add_chain(scene, 2, {.shapes = {box(0.1, 1)}, .position = {0, -0.5}}, {0, -1});
  return scene;
}

/// Two boxes on one platform, 3 m from each other, and a lamp that hangs from the platform by a rod.
struct Carried {
  Scene scene = Scene({.sleeping = usual_sleeping});
  BodyId platform = scene.add({.type = BodyType::kinematic, .shapes = {box(8, 1)}, .position = {0, -0.5}});
  List<BodyId> load = {scene.add({.shapes = {box(1, 1)}, .position = {-1.5, 0.5}}),
                       scene.add({.shapes = {box(1, 1)}, .position = {1.5, 0.5}}),
                       scene.add({.shapes = {circle(0.2)}, .position = {0, -3}, .fixed_rotation = true})};
  Carried() {
    scene.join<DistanceJoint>({.a = platform, .b = load[2], .anchor_a = {0, -0.5}, .anchor_b = {0, -3}});
  }
};

/// The largest speed [m/s] of the boxes of a stack in the second after a missile of 10 g, that came from the
/// side at 0.1 m/s, has woken it. The stack fell asleep once slower than `threshold` [m/s, rad/s].
double speed_after_touch(SceneSettings settings, double threshold) {
  settings.sleeping = Sleeping{.speed = threshold, .angular_speed = threshold, .time = 0.5};
  Scene scene(settings);
  scene.add_ground();
  const List<BodyId> boxes = samples::add_stack(scene, 5);
  const BodyId missile = add_missile(scene, {1.1, 2.5}, 0.01);
  World<double> world(scene);
  REQUIRE(steps_until_asleep(world) < 2000);
  world.set_velocity(missile, {-0.1, 0, 0});
  for (int i = 0; count_awake(world, boxes) == 0 && i < 100; ++i) sleep_steps(world, 1, 10);
  REQUIRE(count_awake(world, boxes) == 5);
  double largest = 0;
  for (int i = 0; i < 60; ++i) {
    largest = std::max(largest, largest_speed(world, boxes));
    sleep_steps(world, 1, 10);
  }
  return largest;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "an island that is woken goes on as one that was only stopped: the same bits, impulses too", Real, float,
    double) {
  for (const StabilizationPolicy policy : {StabilizationPolicy::baumgarte, StabilizationPolicy::relaxed,
                                           StabilizationPolicy::soft, StabilizationPolicy::split_impulse}) {
    const SceneSettings on{.substeps = 2, .stabilization = {.policy = policy}, .sleeping = usual_sleeping};
    SceneSettings off = on;
    off.sleeping = {};
    for (const bool hangs : {false, true}) {
      World<Real> slept(hangs ? hanging_scene(on) : stack_scene(on));
      World<Real> stopped(hangs ? hanging_scene(off) : stack_scene(off));
      sleep_steps(stopped, steps_until_asleep(slept));
      for (int i = 1; i < stopped.bodies().pose.size(); ++i) stopped.set_velocity({i}, {0, 0, 0});
      sleep_steps(slept, 77);
      CHECK(slept.velocity_problem().rows.empty());
      wake(slept, {1});
      CHECK(slept.velocity_problem().impulse == stopped.velocity_problem().impulse);
      for (int i = 0; i < usual_sleep_steps - 1; ++i) {
        CHECK(sleep_steps(slept, 1).rows == sleep_steps(stopped, 1).rows);
        REQUIRE(same_motion(slept, stopped));
        REQUIRE(slept.last_step().problem.impulse == stopped.last_step().problem.impulse);
      }
    }
  }
}

TEST_CASE(
    "a ball thrown at one of two sleeping stacks wakes that one, whole, in the step in which it touches") {
  Scene scene({.sleeping = usual_sleeping});
  scene.add_ground();
  const List<BodyId> hit = samples::add_stack(scene, 5, samples::standing_box(-5));
  const List<BodyId> spared = samples::add_stack(scene, 5, samples::standing_box(5));
  const BodyId ball = add_missile(scene, {-8, 3}, 1);
  World<double> world(scene);
  steps_until_asleep(world);
  const World<double> asleep = world;
  world.set_velocity(ball, {5, 0, 0});
  CHECK(world.is_awake(ball));
  SequentialImpulse<double> solver;
  StepReport report = world.step(solver);
  while (report.rows == 0 && world.clock().steps < 2000) {
    CHECK(report.awake.bodies == 1);
    CHECK(count_awake(world, hit) == 0);
    const VelocityProblem<double> next = world.velocity_problem();
    report = world.step(solver);
    CHECK(next.rows.size() == report.rows);
  }
  // From -8 m to where the gap of -5.5 - (x + 0.5) is 0: 2 m at 5 m/s take 24 steps.
  CHECK(world.clock().steps - asleep.clock().steps == 2 * 60 / 5);
  CHECK(count_awake(world, hit) == 5);
  CHECK(report.awake.bodies == 6);
  CHECK(report.awake.islands == 1);
  for (const Contact<double>& contact : world.last_step().problem.contacts) {
    CHECK((contact.b < spared.front() || contact.b > spared.back()));
  }
  for (int i = 0; i < 120; ++i) world.step(solver);
  CHECK(count_awake(world, spared) == 0);
  for (const BodyId box : spared) {
    CHECK(world.bodies().pose[box].position == asleep.bodies().pose[box].position);
    CHECK(world.bodies().pose[box].angle == asleep.bodies().pose[box].angle);
  }
}

TEST_CASE("a stack that is woken by a touch from the side does not pop, because it wakes warm") {
  // The missile, of mass m and speed v, brings the energy m v^2 / 2: no more than v sqrt(m / M) for one box.
  // Impulses kept are those of the last step, which ended below the threshold s. They now meet boxes at rest
  // instead of boxes slower than s, so that v_1 differs by at most sqrt(5 (M + I) s^2) in the norm of kinetic
  // energy, with I = M / 6; to solve is to project in that norm, which makes no difference larger.
  const double threshold = 1e-3;
  const double bound = 0.1 * std::sqrt(0.01) + (1 + std::sqrt(5 * 7.0 / 6)) * threshold;
  CHECK(speed_after_touch({}, threshold) <= bound);
  CHECK(speed_after_touch({.stabilization = {.policy = StabilizationPolicy::split_impulse}}, threshold) <=
        bound);
}

TEST_CASE("impulses kept are scaled when dt changes while the island sleeps") {
  World<double> world(stack_scene());
  steps_until_asleep(world);
  World<double> finer = world;
  finer.set_dt(world.clock().dt / 2);
  for (World<double>* each : {&world, &finer}) {
    sleep_steps(*each, 3);
    wake(*each, {5});
  }
  const PerRow<double> whole = world.velocity_problem().impulse;
  const PerRow<double> half = finer.velocity_problem().impulse;
  REQUIRE(whole.size() == half.size());
  REQUIRE(whole.size() == 20);
  for (int i = 0; i < whole.size(); ++i) CHECK(half[i] == whole[i] / 2);                // exact in binary
  CHECK(whole[0] + whole[2] == doctest::Approx(5 * sleep_gravity / 60).epsilon(0.01));  // five boxes of 1 kg
}

TEST_CASE("a copy of a sleeping world sleeps, wakes like the first, and wakes alone") {
  World<double> world(stack_scene());
  steps_until_asleep(world);
  World<double> twin = world;
  CHECK(same_state(world, twin));
  twin.set_velocity({5}, {0, 0, 0});
  CHECK(twin.is_awake({1}));
  CHECK_FALSE(world.is_awake({1}));
  CHECK(sleep_steps(world, 1).rows == 0);
  CHECK(sleep_steps(twin, 1).rows > 0);
  World<double> third = world;
  wake(world, {2});
  wake(third, {2});
  sleep_steps(world, 20);
  sleep_steps(third, 20);
  CHECK(same_state(world, third));
}

TEST_CASE("what stands on or hangs from a kinematic body is not one island, but wakes with it as it moves") {
  const Carried carried;
  World<double> world(carried.scene);
  CHECK(sleep_steps(world, 1).awake.islands == 3);
  REQUIRE(steps_until_asleep(world) < 200);
  CHECK(sleep_steps(world, 1).rows == 0);

  wake(world, carried.load[0]);
  CHECK(count_awake(world, carried.load) == 1);
  CHECK(sleep_steps(world, 1).awake.islands == 1);

  world.set_velocity(carried.platform, {0, 0.01, 0});  // slower than the threshold, but it moves
  CHECK(sleep_steps(world, 1).awake.islands == 3);
  for (int i = 0; i < 120; ++i) CHECK(sleep_steps(world, 1).awake.bodies == 3);
  // Once it stands still it keeps nothing awake any more.
  world.set_velocity(carried.platform, {0, 0, 0});
  CHECK(steps_until_asleep(world) < 200);
}

TEST_CASE("a sensor sees what sleeps, and wakes nothing, even as it moves") {
  Scene scene({.sleeping = usual_sleeping});
  scene.add_ground();
  const BodyId disc = scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}});
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}, .position = {0, 1}, .sensor = true});
  const BodyId scanner =
      scene.add({.type = BodyType::kinematic, .shapes = {box(1, 1)}, .position = {-2, 1}, .sensor = true});
  World<double> world(scene);
  CHECK(steps_until_asleep(world) == usual_sleep_steps);
  CHECK(sleep_steps(world, 1).rows == 0);
  CHECK(world.last_step().sensed.size() == 1);
  world.set_velocity(scanner, {2, 0, 0});
  CHECK(sleep_steps(world, 61).rows == 0);  // at x = 0 after 1 s: what is sensed is where the step began
  CHECK(world.last_step().sensed.size() == 2);
  CHECK_FALSE(world.is_awake(disc));
}

TEST_CASE("a world that lets nothing sleep has nothing to wake") {
  World<double> sleepless(stack_scene({}));
  wake(sleepless, {1});
  CHECK(sleepless.is_awake({1}));
}
