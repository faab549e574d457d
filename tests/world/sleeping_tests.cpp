// Falling asleep: which bodies, after how long, and what a sleeping body costs.
#include <cairn/samples/samples.hpp>
#include "sleeping_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A disc hung by a rod of 1 m from the ground at (x, 0), at rest, `angle` [rad] away from straight down.
BodyId add_pendulum(Scene& scene, double x, double angle) {
  const BodyId bob = scene.add(
      {.shapes = {circle(0.1)}, .position = {x + std::sin(angle), -std::cos(angle)}, .fixed_rotation = true});
  scene.join<DistanceJoint>(
      {.a = ground, .b = bob, .anchor_a = {x, 0}, .anchor_b = {x + std::sin(angle), -std::cos(angle)}});
  return bob;
}

/// The amplitude [rad] of a pendulum of 1 m that is slower than usual_sleeping.speed for `time` [s] around
/// each turning point: its speed is A w sin(w t) with w = sqrt(g / L), t from the turning point.
double amplitude_slow_for(double time) {
  const double w = std::sqrt(sleep_gravity);
  return usual_sleeping.speed / (w * std::sin(w * time / 2));
}

/// Three bars in a row, pinned to each other, that float; the first is pinned to the hub of a wheel.
Scene chain_scene(double spin) {
  Scene scene({.gravity = {0, 0}, .sleeping = usual_sleeping});
  BodyId last = scene.add({.shapes = {circle(0.5)}, .angular_velocity = spin});
  for (int i = 0; i < 3; ++i) {
    const double x = 1.0 * i;
    const BodyId bar = scene.add({.shapes = {box(1, 0.1)}, .position = {x + 0.5, 0}});
    scene.join<RevoluteJoint>({.a = last, .b = bar, .anchor = {x, 0}});
    last = bar;
  }
  return scene;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "a stack of five falls asleep half a second after it has come to its place, and costs no rows then", Real,
    float, double) {
  World<Real> world(stack_scene());
  World<Real> awake(stack_scene({}));
  SequentialImpulse<Real> solver({.iterations = 50});
  PerBody<Pose<Real>> place = awake.bodies().pose;
  const Real size = std::sqrt(Real(0.5));  // [m] of a box, to its corner
  int last_moved = 0;
  int step = 0;
  for (StepReport report{.awake = {.bodies = 5}}; report.awake.bodies > 0 && step < 500; ++step) {
    if (step > 0) REQUIRE(same_state(world, awake));  // it sleeps late, and nothing else is different
    report = world.step(solver);
    awake.step(solver);
    for (const BodyId body : place.indices()) {
      const Pose<Real>& now = awake.bodies().pose[body];
      const Vec3<Real>& v = awake.bodies().velocity[body];
      const Real gone =
          (now.position - place[body].position).norm() + size * std::abs(now.angle - place[body].angle);
      const bool slow = v.template head<2>().norm() < Real(0.05) && std::abs(v.z()) < Real(0.05);
      if (gone <= Real(2e-3) * size && slow) continue;
      place[body] = now;
      last_moved = step + 1;
    }
  }
  CHECK(step == last_moved + usual_sleep_steps);
  CHECK(same_poses(world, awake));

  const World<Real> asleep = world;
  for (int i = 0; i < 100; ++i) {
    const StepReport report = world.step(solver);
    CHECK(report.rows == 0);
    CHECK(report.contacts == 0);
    CHECK(report.awake.bodies == 0);
    CHECK(report.awake.islands == 0);
  }
  CHECK(same_poses(world, asleep));
  for (const Vec3<Real>& v : world.bodies().velocity) CHECK(v == Vec3<Real>::Zero());
}

TEST_CASE(
    "a stack sleeps under every policy, and with every number of substeps its time is counted in seconds") {
  for (const StabilizationPolicy policy : every_policy) {
    for (const int substeps : {1, 4}) {
      CAPTURE(substeps);
      // One disc on the ground, whose only load is its weight: it is slow from the first step on.
      Scene scene({.substeps = substeps, .stabilization = {.policy = policy}, .sleeping = usual_sleeping});
      scene.add_ground();
      scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}});
      World<double> disc(scene);
      CHECK(steps_until_asleep(disc) == usual_sleep_steps);
      World<double> finer(scene);
      finer.set_dt(1.0 / 120);
      CHECK(steps_until_asleep(finer) == 2 * usual_sleep_steps);

      World<double> world(stack_scene(
          {.substeps = substeps, .stabilization = {.policy = policy}, .sleeping = usual_sleeping}));
      steps_until_asleep(world);
      const World<double> asleep = world;
      CHECK(sleep_steps(world, 20).rows == 0);
      CHECK(same_poses(world, asleep));
    }
  }
}

TEST_CASE("two stacks on one ground are two islands, and sleep independently") {
  Scene scene({.sleeping = usual_sleeping});
  scene.add_ground();
  const List<BodyId> still = samples::add_stack(scene, 3, samples::standing_box(-5));
  // This one is dropped from 5 m: it falls for sqrt(2 h / g) = 1 s, twice the time that lets the other sleep.
  const BodyId late = scene.add({.shapes = {box(1, 1)}, .position = {5, 5.5}});
  World<double> world(scene);
  CHECK(sleep_steps(world, 1).awake.islands == 2);
  const StepReport falling = sleep_steps(world, 55);
  CHECK(count_awake(world, still) == 0);
  CHECK(world.is_awake(late));
  CHECK(falling.awake.bodies == 1);
  CHECK(falling.awake.islands == 1);
  CHECK(falling.rows == 0);
  CHECK(steps_until_asleep(world) < 200);
  CHECK_FALSE(world.is_awake(late));
}

TEST_CASE("a body that falls over the top of its flight does not fall asleep there") {
  Scene scene({.sleeping = usual_sleeping});
  scene.add({.shapes = {circle(0.5)}, .velocity = {0, 5}});
  World<double> world(scene);
  CHECK(steps_until_asleep(world, 120) > 120);
}

TEST_CASE("a pendulum that swings never sleeps, however long it is slow around its turning points") {
  for (const double slow_for : {0.1, 0.4, 0.6}) {
    CAPTURE(slow_for);
    Scene scene({.sleeping = usual_sleeping});
    const BodyId bob = add_pendulum(scene, 0, amplitude_slow_for(slow_for));
    World<double> world(scene);
    for (int step = 0; step < 240; ++step) {  // two periods of 2 pi / w = 1.99 s
      sleep_steps(world, 1);
      REQUIRE(world.is_awake(bob));
    }
  }
}

TEST_CASE("what is joined to the ground alone sleeps, whatever else hangs from the ground") {
  Scene scene({.sleeping = usual_sleeping});
  const BodyId still = add_pendulum(scene, -3, 0);
  const BodyId swinging = add_pendulum(scene, 3, 1);
  World<double> world(scene);
  CHECK(sleep_steps(world, usual_sleep_steps - 1).awake.islands == 2);
  CHECK(sleep_steps(world, 1).awake.islands == 1);
  CHECK_FALSE(world.is_awake(still));
  CHECK(world.is_awake(swinging));

  // The sleeping joint keeps its place among the blocks, without a row.
  CHECK(sleep_steps(world, 1).rows == 1);
  const VelocityProblem<double>& problem = world.last_step().problem;
  REQUIRE(problem.blocks.size() == 2);
  CHECK(problem.blocks[0].count == 0);
  CHECK(problem.blocks[1].count == 1);
  const Snapshot seen = snapshot(world);
  CHECK(seen.joints[0].impulse.norm() == 0);
  CHECK(seen.joints[1].impulse.norm() > 0);
  CHECK_FALSE(seen.bodies[still].awake);
  CHECK(seen.bodies[swinging].awake);
  CHECK(seen.bodies[ground].awake);
}

TEST_CASE("a chain joined to an awake body stays awake, though it never moves itself") {
  World<double> spinning(chain_scene(1));
  const StepReport report = sleep_steps(spinning, 120);
  CHECK(report.awake.bodies == 4);
  CHECK(report.awake.islands == 1);
  for (int i = 2; i < 5; ++i) CHECK(spinning.bodies().velocity[{i}].norm() < usual_sleeping.speed);
  World<double> still(chain_scene(0));
  CHECK(steps_until_asleep(still) == usual_sleep_steps);
}

TEST_CASE("nothing sleeps unless the scene asks for it, and asking changes no bit of what is awake") {
  CHECK_FALSE(SceneSettings().sleeping.has_value());
  World<double> plain(stack_scene({}));
  World<double> patient(stack_scene({.sleeping = Sleeping{.time = 1e6}}));
  for (int i = 0; i < 120; ++i) {
    CHECK(sleep_steps(plain, 1).awake.bodies == 5);
    const StepReport report = sleep_steps(patient, 1);
    CHECK(report.awake.bodies == 5);
    CHECK(report.awake.islands == 1);
    REQUIRE(same_state(plain, patient));
  }
}

TEST_CASE("two runs in which bodies sleep give the same bits") {
  World<double> first(stack_scene()), second(stack_scene());
  for (int i = 0; i < 150; ++i) {
    if (i == 100) first.set_velocity({3}, {0.5, 0, 0});
    if (i == 100) second.set_velocity({3}, {0.5, 0, 0});
    sleep_steps(first, 1);
    sleep_steps(second, 1);
    REQUIRE(same_state(first, second));
  }
  CHECK(first.is_awake({1}));
}

TEST_CASE("the plan says whether bodies may sleep") {
  const auto says = [](const Plan& plan, const char* text) {
    return explain(plan).find(text) != std::string::npos;
  };
  const Plan on = make_plan(stack_scene());
  const Plan off = make_plan(stack_scene({}));
  CHECK(on.settings.sleeping.has_value());
  CHECK_FALSE(off.settings.sleeping.has_value());
  CHECK(says(on, "islands at rest take no part until something wakes them"));
  CHECK(says(off, "every body takes part in every step"));
}

TEST_CASE("sleeping refuses thresholds and times that are not positive and finite") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](const Sleeping& sleeping) {
    return message_of([&] { Scene({.sleeping = sleeping}); });
  };
  for (const double bad : {0.0, -1.0, infinity, std::nan("")}) {
    CHECK(refused({.speed = bad}).find("Scene: sleeping.speed must be > 0 m/s and finite") == 0);
    CHECK(refused({.angular_speed = bad}).find("Scene: sleeping.angular_speed must be > 0 rad/s") == 0);
    CHECK(refused({.time = bad}).find("Scene: sleeping.time must be > 0 s and finite") == 0);
  }
  CHECK(refused({}).empty());
}
