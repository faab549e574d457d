// Joints that break above a force or a torque, held against closed forms.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double g = 10;  // [m/s^2]

/// A disc on a rod of 2 m that hangs from the ground.
Scene hanging(double mass, double strength, SceneSettings settings = {}) {
  Scene scene(settings);
  const BodyId disc = scene.add({.shapes = {circle(0.5)}, .position = {0, -2}, .mass = mass});
  scene.change(scene.join<DistanceJoint>({.b = disc, .anchor_b = scene.bodies()[disc].pose.position}),
               JointStrength{.force = strength});
  return scene;
}

/// How many joints are left of a scene after so many steps.
int left_after(const Scene& scene, int steps, int iterations = 20) {
  return world_after(scene, steps, iterations).scene().joints().size();
}

}  // namespace

TEST_CASE("a rod that hangs a mass breaks below m g, and holds above, whatever mass, policy and substeps") {
  for (const double mass : {1e-9, 1.0, 1e9}) {
    for (const StabilizationPolicy policy :
         {StabilizationPolicy::relaxed, StabilizationPolicy::baumgarte, StabilizationPolicy::split_impulse}) {
      for (const int substeps : {1, 4}) {
        const SceneSettings settings{.substeps = substeps, .stabilization = {.policy = policy}};
        CHECK(left_after(hanging(mass, mass * g * (1 + 1e-9), settings), 120) == 1);
        CHECK(left_after(hanging(mass, mass * g * (1 - 1e-9), settings), 1) == 1);  // it held in this step
        CHECK(left_after(hanging(mass, mass * g * (1 - 1e-9), settings), 2) == 0);
      }
    }
  }
}

TEST_CASE("a springy rod breaks by the force that it has, under the policy soft") {
  const SceneSettings soft{.stabilization = {.policy = StabilizationPolicy::soft}};
  CHECK(left_after(hanging(1, 1.05 * g, soft), 120) == 1);
  CHECK(left_after(hanging(1, 0.95 * g, soft), 120) == 0);
}

TEST_CASE("what takes an error back breaks nothing, where its speed is not the body's") {
  for (const StabilizationPolicy policy :
       {StabilizationPolicy::relaxed, StabilizationPolicy::split_impulse}) {
    Scene scene = hanging(1, g * (1 + 1e-6), {.stabilization = {.policy = policy}});
    displace(scene, {1}, {0, -0.1});
    const World<double> world = world_after(scene, 120);
    CHECK(world.scene().joints().size() == 1);
    CHECK(pose_of(world, {1}).position.y() == doctest::Approx(-2).epsilon(1e-3));
  }
}

TEST_CASE("a rod breaks once what it whirls needs more than m w^2 r") {
  const double mass = 3, radius = 2, speed = 4;  // [kg], [m], [rad/s]
  const auto left = [&](double share) {
    Scene scene({.gravity = {0, 0}, .dt = 1.0 / 600});
    const BodyId disc = scene.add(
        {.shapes = {circle(0.1)}, .position = {radius, 0}, .velocity = {0, speed * radius}, .mass = mass});
    scene.change(scene.join<DistanceJoint>({.b = disc, .anchor_b = scene.bodies()[disc].pose.position}),
                 JointStrength{.force = share * mass * speed * speed * radius});
    return left_after(scene, 600);
  };
  // A step turns the rod by w dt = 1/150: what the joint gives is off by the square of it, 4e-5.
  CHECK(left(1 + 1e-4) == 1);
  CHECK(left(1 - 1e-4) == 0);
}

TEST_CASE("a weld breaks by the moment of what it carries aside, m g l about the weld") {
  for (const double share : {1 - 1e-6, 1 + 1e-6}) {
    Scene scene;
    const BodyId beam = scene.add({.shapes = {box(2, 0.2)}, .position = {1, 0}, .mass = 5});
    const JointId weld = scene.join<WeldJoint>({.b = beam, .anchor = {0, 0}});
    for (const JointStrength& strength :
         {JointStrength{.torque = share * 5 * g * 1}, JointStrength{.force = share * 5 * g}}) {
      scene.change(weld, strength);
      World<double> world(scene);
      NewtonSolver<double> solver({.iterations = 50, .tolerance = 1e-12});
      take_steps(world, solver, 120);
      CHECK(world.scene().joints().size() == (share > 1 ? 1 : 0));
    }
  }
}

/// Beads of 0.1 kg and a last one of 100 kg on rods of so much strength [N].
World<double> beads_after(double strength, int steps) {
  Scene scene;
  BodyId above = ground;
  for (int i = 0; i < 6; ++i) {
    const BodyId bead =
        scene.add({.shapes = {circle(0.2)}, .position = {0, -1.0 - i}, .mass = i == 5 ? 100.0 : 0.1});
    const JointId rod = scene.join<DistanceJoint>(
        {.a = above, .b = bead, .anchor_a = {0, -1.0 * i}, .anchor_b = {0, -1.0 - i}});
    scene.change(rod, JointStrength{.force = strength});
    above = bead;
  }
  World<double> world(scene);
  NewtonSolver<double> solver({.iterations = 50, .tolerance = 1e-12});
  take_steps(world, solver, steps);
  return world;
}

TEST_CASE("of a string with a heavy end the rod breaks that carries the most, and none that holds its load") {
  const World<double> world = beads_after((100 + 0.1 * 4.5) * g, 2);
  REQUIRE(world.scene().joints().broken().size() == 1);
  const BrokenJoint& broken = world.scene().joints().broken()[0];
  CHECK(broken.id == JointId{0});  // 100.5 kg; the next one carries 100.4
  CHECK(broken.time == doctest::Approx(1.0 / 60).epsilon(1e-14));
  CHECK(broken.force == doctest::Approx(100.5 * g).epsilon(1e-9));
  // Solved to its answer, a string that begins at rest has no jerk.
  CHECK(beads_after(100.5 * g * (1 + 1e-8), 120).scene().joints().broken().empty());
}

TEST_CASE("what broke is in snapshots and in copies, and stays through edits; what it held falls") {
  World<double> world = world_after(hanging(1, 5), 30);
  world.edit([](Scene& scene) { scene.add({.shapes = {circle(1)}, .position = {9, 9}}); });
  const Snapshot now = snapshot(world);
  REQUIRE(now.broken.size() == 1);
  CHECK(now.joints.empty());
  CHECK(now.broken[0].joint.name == "rod");
  CHECK(now.broken[0].force == doctest::Approx(g).epsilon(1e-12));
  CHECK(now.broken[0].torque == doctest::Approx(0));
  // It falls in all steps but the first: g dt^2 n (n + 1) / 2.
  const double dt = 1.0 / 60;
  CHECK(now.bodies[{1}].pose.position.y() == doctest::Approx(-2 - g * dt * dt * 29 * 30 / 2).epsilon(1e-12));
  CHECK((now.broken[0].joint.anchor_b - now.bodies[{1}].pose.position).norm() <= 1e-12);
}

TEST_CASE("a joint that an event breaks is told from one that it removes") {
  Scene scene = hanging(1, 100);
  scene.add({.time = 0.1, .action = BreakJoint{scene.joints().id(0)}});
  const Snapshot now = snapshot(world_after(scene, 30));
  REQUIRE(now.broken.size() == 1);
  CHECK(now.broken[0].time == 0.1);
  CHECK(now.broken[0].force == 0);
}

TEST_CASE("strengths that no joint can have are refused, and none is asked for where none is given") {
  Scene scene = hanging(1, std::numeric_limits<double>::infinity());
  CHECK_FALSE(make_plan(scene).extras.breaks);
  const JointId rod = scene.joints().id(0);
  CHECK_THROWS_AS(scene.change(rod, JointStrength{.force = 0}), std::invalid_argument);
  CHECK_THROWS_AS(scene.change(rod, JointStrength{.torque = -1}), std::invalid_argument);
  CHECK_THROWS_AS(scene.change(JointId{9}, JointStrength{.force = 1}), std::invalid_argument);
  const BodyId two = scene.add({.shapes = {circle(1)}, .position = {5, 0}});
  const JointId rope = scene.join<PulleyJoint>({.ends = {{.body = {1}, .anchor = {0, -2}, .roller = {0, 3}},
                                                         {.body = two, .anchor = {5, 0}, .roller = {5, 3}}}});
  CHECK_NOTHROW(scene.change(rope, JointStrength{.force = 1}));
}
