// What happens to a scene while it runs, held against closed forms.
#include "testing.hpp"
#include "world/edited_scenes.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double event_dt = 1.0 / 64;     // [s] exact, so that sums of it are
const double event_rounding = 1e-13;  // of some hundred operations with numbers of about 10

/// A disc of 2 kg and 1 m that is welded to the ground.
struct HeldDisc {
  Scene scene{{.dt = event_dt}};
  BodyId disc = scene.add({.shapes = {circle(1)}, .mass = 2});
  JointId weld = scene.join<WeldJoint>({.b = disc});
};

/// A wheel of 1 m on an axle, without gravity, and its motor.
struct MotorWheel {
  Scene scene{{.gravity = {0, 0}, .dt = event_dt}};
  BodyId wheel = scene.add({.shapes = {circle(1)}, .mass = 2});  // I = m r^2 / 2 = 1 kg m^2
  JointId axle =
      scene.join<RevoluteJoint>({.b = wheel, .motor = RevoluteJoint::Motor{.speed = 0, .max_torque = 3}});
};

}  // namespace

TEST_CASE("what loses its support falls from the first step that begins at the time of the event") {
  for (const bool removes_joint : {true, false}) {
    for (const double time : {0.5, 0.5 - 0.9 * event_dt}) {  // one in the middle of a step waits for the next
      Scene scene({.dt = event_dt});
      const BodyId peg = scene.add({.type = BodyType::static_body});
      const BodyId disc = scene.add({.shapes = {circle(1)}});
      const JointId rod = scene.join<DistanceJoint>({.a = peg, .b = disc, .anchor_a = {0, 1}});
      if (removes_joint) {
        scene.add({.time = time, .action = RemoveJoint{rod}});
      } else {
        scene.add({.time = time, .action = RemoveBody{peg}});  // and its rod
      }
      World<double> world = world_after(scene, 32);
      CHECK(std::abs(world.bodies().pose[disc].position.y()) <= event_rounding);
      CHECK(world.scene().joints().size() == 1);
      take_steps(world, 32);
      // Semi-implicit Euler over n steps: g dt^2 n (n + 1) / 2.
      const double fall = 10 * event_dt * event_dt * 32 * 33 / 2;
      CHECK(world.bodies().pose[disc].position.y() == doctest::Approx(-fall).epsilon(event_rounding));
      CHECK(world.scene().joints().empty());
      CHECK(world.scene().events().empty());
    }
  }
}

TEST_CASE("an impulse changes a velocity by J / m and its turning by r x J / I, whatever the scalar") {
  const auto check = []<Scalar Real>(Real) {
    Scene scene({.gravity = {0, 0}, .dt = event_dt});
    const double angle = pi / 2;
    const BodyId box_id = scene.add({.shapes = {box(1, 1)},
                                     .angle = angle,
                                     .velocity = {1, 2},
                                     .angular_velocity = 0.5,
                                     .mass = 4,
                                     .inertia = 0.25});
    scene.add({.time = 0, .action = PushBody{.body = box_id, .impulse = {2, -6}, .point = {0.5, 0}}});
    World<Real> world = world_after<Real>(scene, 1);
    const Vec3<Real>& velocity = world.bodies().velocity[box_id];
    // The arm of (0.5, 0) in the body has turned to (0, 0.5): r x J = -0.5 * 2.
    const double rounding = 8 * static_cast<double>(std::numeric_limits<Real>::epsilon());
    CHECK(std::abs(static_cast<double>(velocity.x()) - (1 + 2.0 / 4)) <= rounding);
    CHECK(std::abs(static_cast<double>(velocity.y()) - (2 - 6.0 / 4)) <= rounding);
    CHECK(std::abs(static_cast<double>(velocity.z()) - (0.5 - 1 / 0.25)) <= rounding);
  };
  check(float{});
  check(double{});
}

TEST_CASE("an impulse at the centre of what never turns does not turn it") {
  Scene scene({.gravity = {0, 0}, .dt = event_dt});
  const BodyId disc = scene.add({.shapes = {circle(1)}, .mass = 2, .fixed_rotation = true});
  scene.add({.time = 0, .action = PushBody{.body = disc, .impulse = {2, 0}, .point = {0, 1}}});
  World<double> world = world_after(scene, 1);
  CHECK(world.bodies().velocity[disc] == Vec3<double>(1, 0, 0));
}

TEST_CASE("a motor that is switched reaches its speed with its torque, and one that is off turns freely") {
  MotorWheel of;
  of.scene.add({.time = 0.25, .action = SwitchMotor{of.axle, JointMotor{.speed = 2, .max_force = 4}}});
  of.scene.add({.time = 1, .action = SwitchMotor{of.axle, {}}});
  of.scene.add({.time = 1, .action = PushBody{.body = of.wheel, .impulse = {0, 1}, .point = {1, 0}}});
  World<double> world(of.scene);
  const auto turning = [&] { return world.bodies().velocity[of.wheel].z(); };
  take_steps(world, 16);
  CHECK(turning() == 0);
  take_steps(world, 16);
  CHECK(turning() == doctest::Approx(4 * 0.25).epsilon(event_rounding));  // torque / I * t
  take_steps(world, 32);
  CHECK(turning() == doctest::Approx(2).epsilon(event_rounding));
  // 1 N s upwards at a point of the rim, which has turned with the wheel; the axle takes back what would move
  // its centre.
  const double arm = std::cos(world.bodies().pose[of.wheel].angle);
  take_steps(world, 64);
  CHECK(turning() == doctest::Approx(2 + arm).epsilon(event_rounding));
  CHECK_FALSE(world.scene().joints()[0]->motor());
}

TEST_CASE("the motor of a slide is switched likewise") {
  Scene scene({.gravity = {0, 0}, .dt = event_dt});
  const BodyId slider = scene.add({.shapes = {box(1, 1)}, .mass = 2});
  const JointId slide = scene.join<PrismaticJoint>({.b = slider, .axis = {1, 0}});
  scene.add({.time = 0, .action = SwitchMotor{slide, JointMotor{.speed = 0.75, .max_force = 4}}});
  World<double> world = world_after(scene, 16);
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(4.0 / 2 * 0.25).epsilon(event_rounding));
  take_steps(world, 16);
  CHECK(world.bodies().velocity[slider].x() == doctest::Approx(0.75).epsilon(event_rounding));
}

TEST_CASE("what an event touches wakes up, and nothing else") {
  for (const int kind : {0, 1, 2}) {
    CAPTURE(kind);
    Scene scene({.gravity = {0, 0}, .dt = event_dt, .sleeping = Sleeping{.time = 0.25}});
    const BodyId disc = scene.add({.shapes = {circle(1)}});
    const BodyId other = scene.add({.shapes = {circle(1)}, .position = {5, 0}});
    const JointId axle = scene.join<RevoluteJoint>({.b = disc});
    const SceneAction actions[] = {PushBody{.body = disc, .impulse = {0, 1}, .point = {1, 0}},
                                   SwitchMotor{axle, JointMotor{.speed = 1, .max_force = 10}},
                                   RemoveJoint{axle}};
    scene.add({.time = 1, .action = actions[kind]});
    World<double> world = world_after(scene, 64);
    REQUIRE_FALSE(world.is_awake(disc));
    take_steps(world, 1);
    CHECK(world.is_awake(disc));
    CHECK_FALSE(world.is_awake(other));
  }
}

TEST_CASE("a world that is copied before an event goes on as the other, and the problem ahead has it in it") {
  HeldDisc of;
  of.scene.add({.time = 0.125, .action = RemoveJoint{of.weld}});
  World<double> world = world_after(of.scene, 8);
  const World<double> before = world;
  CHECK(before.velocity_problem().row_count() == 0);
  CHECK(before.scene().joints().size() == 1);  // it was only looked at
  take_steps(world, 8);
  World<double> again = before;
  take_steps(again, 8);
  CHECK(again.bodies().pose[of.disc].position == world.bodies().pose[of.disc].position);
  CHECK(again.clock().steps == 16);
}

TEST_CASE("steps of 1/60 s, whose sums are rounded, bring an event neither early nor late") {
  for (const int step : {1, 6, 30, 57, 60, 90, 119}) {
    CAPTURE(step);
    Scene scene({.gravity = {0, 0}});
    const BodyId disc = scene.add({.shapes = {circle(1)}});
    scene.add({.time = step / 60.0, .action = PushBody{.body = disc, .impulse = {1, 0}}});
    World<double> world = world_after(scene, step);
    CHECK(world.bodies().velocity[disc].x() == 0);
    take_steps(world, 1);
    CHECK(world.bodies().velocity[disc].x() > 0);
  }
}

TEST_CASE("an event is forgotten with its body or its joint") {
  HangingChain chain;
  chain.scene.add({.time = 1, .action = PushBody{.body = {3}, .impulse = {1, 0}}});
  chain.scene.add({.time = 2, .action = RemoveJoint{chain.joints[0]}});
  chain.scene.add({.time = 0.5, .action = RemoveJoint{chain.joints[3]}});
  REQUIRE(chain.scene.events().size() == 3);
  CHECK(chain.scene.events()[0].time == 0.5);
  chain.scene.remove(BodyId{3});  // with joint 3
  REQUIRE(chain.scene.events().size() == 1);
  CHECK(chain.scene.events()[0].time == 2);
  chain.scene.remove(chain.joints[0]);
  CHECK(chain.scene.events().empty());
}

TEST_CASE("events that cannot be are refused") {
  HeldDisc of;
  const auto refusal = [&](double time, const SceneAction& action) {
    return message_of([&] { of.scene.add({.time = time, .action = action}); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(-1, RemoveBody{of.disc}) == "Scene::add: time must be finite and >= 0 s, got -1");
  CHECK(refusal(nan, RemoveBody{of.disc}) == "Scene::add: time must be finite and >= 0 s, got nan");
  CHECK(refusal(1, RemoveBody{ground}) ==
        "Scene::add: body must be the id of a body other than the ground, got 0");
  CHECK(refusal(1, RemoveJoint{{7}}) == "Scene::add: joint must be the id of a joint of this scene, got 7");
  CHECK(refusal(1, PushBody{.body = of.disc, .impulse = {nan, 0}}).find("impulse") != std::string::npos);
  CHECK(refusal(1, SwitchMotor{of.weld, {}}) ==
        "Scene::add: joint must be one that can have a motor, got weld");
  const BodyId wall = of.scene.add({.type = BodyType::static_body});
  CHECK(refusal(1, PushBody{.body = wall}) == "Scene::add: body must be a dynamic one, got 2");
  CHECK(of.scene.events().empty());
}
