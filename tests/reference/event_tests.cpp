// Events of a scene in Box2D: held against Cairn, and against formulas.
#include <cairn/reference/box2d_world.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

constexpr double event_dt = 1.0 / 64;  // [s] exact, so that its multiples are

Snapshot box2d_after(const Scene& scene, int steps) {
  Box2DWorld world(scene);
  for (int step = 0; step < steps; ++step) world.step();
  return world.snapshot();
}

}  // namespace

TEST_CASE("what loses its support falls in Box2D from the same step on") {
  for (const bool removes_joint : {true, false}) {
    Scene scene({.dt = event_dt});
    const BodyId peg =
        scene.add({.type = BodyType::static_body, .shapes = {circle(0.25)}, .position = {0, 3}});
    const BodyId disc = scene.add({.shapes = {circle(1)}});
    const JointId rod = scene.join<DistanceJoint>({.a = peg, .b = disc, .anchor_a = {0, 3}});
    const double time = 0.5 - 0.9 * event_dt;  // within a step: it waits for the next
    if (removes_joint) {
      scene.add({.time = time, .action = RemoveJoint{rod}});
    } else {
      scene.add({.time = time, .action = RemoveBody{peg}});
    }
    const Snapshot held = box2d_after(scene, 32), now = box2d_after(scene, 64);
    CHECK(held.joints.size() == 1);
    CHECK(std::abs(held.bodies[disc].pose.position.y()) <= 1e-5);  // single precision at 3 m, and its slop
    CHECK(now.joints.empty());
    CHECK(now.bodies[peg].removed == !removes_joint);
    CHECK(now.bodies[peg].shapes.empty() == !removes_joint);
    const double fall = 10 * event_dt * event_dt * 32 * 33 / 2;  // semi-implicit Euler
    CHECK(now.bodies[disc].pose.position.y() == doctest::Approx(-fall).epsilon(1e-5));
  }
}

TEST_CASE("an impulse does in Box2D what it does in Cairn") {
  Scene scene({.gravity = {0, 0}, .dt = event_dt});
  const BodyId disc = scene.add({.shapes = {circle(1)}, .angle = pi / 2, .mass = 4, .inertia = 0.25});
  scene.add({.time = 0, .action = PushBody{.body = disc, .impulse = {2, -6}, .point = {0.5, 0}}});
  const Vec3<double> velocity = box2d_after(scene, 1).bodies[disc].velocity;
  const double single = 1e-6;  // a few roundings
  CHECK(velocity.x() == doctest::Approx(2.0 / 4).epsilon(single));
  CHECK(velocity.y() == doctest::Approx(-6.0 / 4).epsilon(single));
  CHECK(velocity.z() == doctest::Approx(-0.5 * 2 / 0.25).epsilon(single));  // the arm is (0, 0.5)
}

TEST_CASE(
    "a box whose neighbour below is removed in Box2D falls to the ground, and its contacts go with it") {
  Scene scene;
  scene.add_ground();
  const BodyId below = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  const BodyId above = scene.add({.shapes = {box(1, 1)}, .position = {0, 1.5}});
  scene.add({.time = 0.5, .action = RemoveBody{below}});
  CHECK(box2d_after(scene, 30).contacts.size() == 4);
  CHECK(box2d_after(scene, 31).contacts.empty());
  const Snapshot end = box2d_after(scene, 120);
  CHECK(end.bodies[above].pose.position.y() == doctest::Approx(0.5).epsilon(0.05));  // and the skins
  CHECK(end.contacts.size() == 2);
  CHECK(end.contacts[0].b == above);
}

TEST_CASE("events set velocity, friction and gravity in Box2D as they do in Cairn") {
  Scene scene({.dt = event_dt});
  scene.add_ground();
  const BodyId lift = scene.add({.type = BodyType::kinematic, .shapes = {box(1, 1)}, .position = {-9, 5}});
  const BodyId sled = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {4, 0}});
  const BodyId free = scene.add({.shapes = {circle(0.5)}, .position = {9, 9}});
  scene.add({.time = 0.5, .action = ChangeBody{.body = lift, .velocity = Vec2<double>(0, 2)}});
  scene.add({.time = 0.25, .action = ChangeBody{.body = sled, .friction = 0}});
  scene.add({.time = 0.5, .action = SetGravity{.gravity = {0, 10}}});
  const Snapshot now = box2d_after(scene, 64);
  const double single = 1e-5;  // a few roundings
  CHECK(now.bodies[lift].pose.position.y() == doctest::Approx(5 + 2 * 0.5).epsilon(single));
  // sqrt(0.6 0.6) g dt a step is lost in the 16 steps before.
  CHECK(now.bodies[sled].velocity.x() == doctest::Approx(4 - 0.6 * 10 * 0.25).epsilon(1e-3));
  CHECK(std::abs(now.bodies[free].velocity.y()) <= single);  // 32 steps down, and 32 up
}

TEST_CASE("Box2D refuses events of touches, surface speeds and sensors, and joints that break, by name") {
  const auto refusal = [](const std::function<void(Scene&, BodyId)>& change) -> std::string {
    Scene scene;
    const BodyId disc = scene.add({.shapes = {circle(1)}, .position = {0, -2}});
    scene.join<DistanceJoint>({.b = disc, .anchor_b = {0, -2}});
    change(scene, disc);
    try {
      Box2DWorld world(scene);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal([](Scene&, BodyId) {}).empty());
  CHECK(refusal([](Scene& scene, BodyId disc) {
          scene.add({.action = SetGravity{}, .touch = TouchCondition{.a = {disc}}});
        }) == "Box2DWorld: event must be one with a time: it waits for no touch, got one of a touch");
  CHECK(refusal([](Scene& scene, BodyId disc) {
          scene.add({.time = 1, .action = ChangeBody{.body = disc, .surface_speed = 1}});
        }) ==
        "Box2DWorld: event must be without surface_speed and sensor, which it takes over for good, "
        "got one of them");
  CHECK(
      refusal([](Scene& scene, BodyId) { scene.change(scene.joints().id(0), JointStrength{.force = 1}); }) ==
      "Box2DWorld: break_force must be left out, as break_torque: its joints do not break, got one of "
      "them");
  CHECK(refusal([](Scene& scene, BodyId) {
          scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}, .filter = {.one_way = {0, 1}}});
        }) == "Box2DWorld: one_way must be [0, 0]: one-way bodies are not taken over, got a direction");
}
