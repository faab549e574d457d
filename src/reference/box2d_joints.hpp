// Floor 7. Joints as Box2D takes them, and refusing what it does not have.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <cairn/constraints/constraint.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>

class b2Body;
class b2Joint;
class b2World;

namespace cairn {

/// Creates the joints of a scene, in its order; gears last, as they are made of other joints. Bodies that the
/// scene keeps apart do not collide.
/// @throws std::invalid_argument for what Box2D 2.4.1 does not have.
List<b2Joint*> create_joints(b2World& world, const Scene& scene, const PerBody<b2Body*>& bodies);

/// Gives the motor of a joint that can have one another speed and strength, or stops it.
void set_motor(b2Joint& joint, const std::optional<JointMotor>& motor);

/// [rad/s or m/s] How fast the servo of a joint goes in a step of dt from here; none: it has no servo.
std::optional<double> servo_speed(const Constraint& joint, const BodyState<double>& state, double dt);

/// What Box2D does in another way with the joints of a scene, a line each.
List<std::string> box2d_differences(const Scene& scene);

}  // namespace cairn
