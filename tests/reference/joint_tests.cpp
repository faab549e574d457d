// Joints in Box2D: what it has is handed on, and does there what it does in Cairn.
#include "engines.hpp"
#include "testing.hpp"

namespace cairn::reference_tests {

namespace {

/// A body of 2 kg at (1, 0), which begins turning.
struct OneBody {
  Scene scene = Scene({.dt = 1.0 / 240});
  BodyId body = scene.add({.position = {1, 0}, .angular_velocity = 1, .mass = 2, .inertia = 0.4});
};

template <typename Joint>
Scene scene_with_joint(typename Joint::Spec spec) {
  OneBody one;
  spec.b = one.body;
  one.scene.join<Joint>(spec);
  return one.scene;
}

struct JointInBoth {
  std::string name = {};
  Scene scene = Scene();
};

List<JointInBoth> distances_and_pins() {
  using Kind = DistanceJoint::Kind;
  const SpringSoftness spring{.stiffness = 200, .damping = 4};
  const RevoluteJoint::Motor motor{.speed = 1, .max_torque = 50};
  const RevoluteJoint::Motor servo{.speed = 1, .max_torque = 50, .target = 0.3};
  return {
      {"rod", scene_with_joint<DistanceJoint>({.anchor_b = {1, 0}})},
      {"rope", scene_with_joint<DistanceJoint>({.anchor_b = {1, 0}, .length = 1.2, .kind = Kind::rope})},
      {"least",
       scene_with_joint<DistanceJoint>(
           {.anchor_a = {1, -1}, .anchor_b = {1, 0}, .length = 2, .kind = Kind::rope, .least = 0.8})},
      {"spring",
       scene_with_joint<DistanceJoint>({.anchor_b = {1, 0}, .kind = Kind::spring, .softness = spring})},
      {"hinge", scene_with_joint<RevoluteJoint>({.lower = -0.5})},
      {"motor", scene_with_joint<RevoluteJoint>({.motor = motor})},
      {"servo", scene_with_joint<RevoluteJoint>({.motor = servo})},
      {"weld", scene_with_joint<WeldJoint>({})},
      {"soft weld",
       scene_with_joint<WeldJoint>({.bending = SpringSoftness{.stiffness = 100, .damping = 10}})},
  };
}

List<JointInBoth> slides() {
  using Kind = PrismaticJoint::Kind;
  const JointSpring spring{.softness = SwingSoftness{.frequency = 2, .damping_ratio = 0.7}, .rest = 0.1};
  const PrismaticJoint::Motor lift{.speed = 0.3, .max_force = 50}, driver{.speed = 3, .max_force = 1};
  const PrismaticJoint::Motor place{.speed = 0.6, .max_force = 50, .target = 0.2};
  return {
      {"slide", scene_with_joint<PrismaticJoint>({.anchor = {1, 0}, .axis = {1, -1}, .upper = 0.7})},
      {"lift", scene_with_joint<PrismaticJoint>({.anchor = {1, 0}, .axis = {0, 1}, .motor = lift})},
      {"linear servo", scene_with_joint<PrismaticJoint>({.anchor = {1, 0}, .axis = {0, 1}, .motor = place})},
      {"slot", scene_with_joint<PrismaticJoint>(
                   {.anchor = {0.8, 0}, .axis = {1, -1}, .kind = Kind::slot, .upper = 0.7})},
      {"wheel",
       scene_with_joint<PrismaticJoint>(
           {.anchor = {1, 0}, .axis = {0, 1}, .kind = Kind::wheel, .motor = driver, .spring = spring})},
  };
}

/// Joints of one body with the world, or of two.
List<JointInBoth> others() {
  OneBody dragged, rubbed, hung, geared, racked;
  dragged.scene.join<DragJoint>({.body = dragged.body, .anchor = {1, 0}, .target = {1, 0.2}});
  rubbed.scene.join<FrictionJoint>({.b = rubbed.body, .max_force = 5, .max_torque = 0.1});
  const BodyId load = hung.scene.add({.position = {-1, 0}, .mass = 3, .inertia = 0.4});
  hung.scene.join<PulleyJoint>({.ends = {{.body = hung.body, .anchor = {1, 0}, .roller = {1, 3}},
                                         {.body = load, .anchor = {-1, 0}, .roller = {-1, 3}}}});
  for (OneBody* const train : {&geared, &racked}) {
    const bool is_rack = train == &racked;
    const BodyId other = train->scene.add({.position = {0, 0}, .mass = 1, .inertia = 0.2});
    train->scene.join<GearJoint>({.a = train->body,
                                  .b = other,
                                  .radius_a = 0.5,
                                  .radius_b = 0.25,
                                  .mesh = is_rack ? GearJoint::Mesh::rack : GearJoint::Mesh::external});
    train->scene.join<RevoluteJoint>({.b = train->body, .anchor = {0.9, 0}});
    if (is_rack) train->scene.join<PrismaticJoint>({.b = other});
    if (!is_rack) train->scene.join<RevoluteJoint>({.b = other});
  }
  return {{"drag", dragged.scene},
          {"friction", rubbed.scene},
          {"pulley", hung.scene},
          {"gear", geared.scene},
          {"rack", racked.scene}};
}

void check_both(const JointInBoth& joint) {
  CAPTURE(joint.name);
  Engines engines(joint.scene, {.velocity_iterations = 100});
  for (int step = 0; step < 120; ++step) {
    engines.step();
    const Snapshot cairn = snapshot(engines.cairn), box2d = engines.box2d.snapshot();
    for (const BodyId id : cairn.bodies.indices()) {
      // Half a second at up to 5 m/s, in steps of which each engine loses its own order of dt.
      CHECK((cairn.bodies[id].pose.position - box2d.bodies[id].pose.position).norm() < 0.02);
      if (joint.name == "drag") continue;  // b2MouseJoint takes 2 % of the turning in every step
      CHECK(std::abs(cairn.bodies[id].pose.angle - box2d.bodies[id].pose.angle) < 0.02);
    }
  }
}

TEST_CASE("bodies on joints go the same way in Box2D, for half a second") {
  for (const JointInBoth& joint : distances_and_pins()) check_both(joint);
  for (const JointInBoth& joint : slides()) check_both(joint);
  for (const JointInBoth& joint : others()) check_both(joint);
}

TEST_CASE("a motor that is switched is switched in Box2D too, and so is the target of a servo") {
  Scene scene = scene_with_joint<RevoluteJoint>({.anchor = {1, 0}});
  const JointId axle = scene.joints().id(0);
  scene.add({.time = 0.5, .action = SwitchMotor{axle, JointMotor{.speed = 3, .max_force = 50}}});
  scene.add({.time = 1, .action = SwitchMotor{axle, JointMotor{.speed = 3, .max_force = 50, .target = 1}}});
  Box2DWorld world(scene);
  for (int step = 0; step < 200; ++step) world.step();
  CHECK(world.snapshot().bodies[{1}].velocity.z() == doctest::Approx(3).epsilon(1e-5));
  for (int step = 0; step < 400; ++step) world.step();
  CHECK(world.snapshot().bodies[{1}].pose.angle == doctest::Approx(1).epsilon(1e-4));
}

}  // namespace

}  // namespace cairn::reference_tests
