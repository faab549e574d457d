// Floor 5. What happens to a scene while it runs: at times that are known before, or when bodies touch.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include <cairn/constraints/constraint.hpp>
#include <cairn/world/lasting_action.hpp>
#include <cairn/world/scene_joints.hpp>

namespace cairn {

/// Takes a body out, with every joint that holds it.
struct RemoveBody {
  BodyId body = {};  // any but the ground
};

/// Takes a joint out.
struct RemoveJoint {
  JointId joint = {};  // one of the scene
};

/// Gives a body an impulse J at a point: its velocity changes by J / m, its turning by r x J / I, with the
/// arm r from the centre of mass to the point.
struct PushBody {
  BodyId body = {};               // a dynamic one
  Vec2<double> impulse = {0, 0};  // [N s] J, in the directions of the world
  Vec2<double> point = {0, 0};    // [m] in the frame of the centre of mass: it goes and turns with the body
};

/// Gives a joint another motor, or takes it away.
struct SwitchMotor {
  JointId joint = {};                    // a revolute or a prismatic one
  std::optional<JointMotor> motor = {};  // none: off
};

/// Takes a joint out that has broken: SceneJoints::broken() goes on to know it.
struct BreakJoint {
  JointId joint = {};  // one of the scene
  double force = 0;    // [N] that it held when it broke; 0 where an event breaks it
  double torque = 0;   // [N m] likewise
};

/// Gives a body other values of what is not left out.
struct ChangeBody {
  BodyId body = {};                             // any but the ground
  std::optional<Vec2<double>> velocity = {};    // [m/s] of the centre of mass; of none that is static
  std::optional<double> angular_velocity = {};  // [rad/s] likewise
  std::optional<double> friction = {};          // Material::friction
  std::optional<double> restitution = {};       // Material::restitution
  std::optional<double> surface_speed = {};     // [m/s] Material::surface_speed
  std::optional<bool> sensor = {};              // BodySpec::sensor
};

/// Gives the scene another gravity.
struct SetGravity {
  Vec2<double> gravity = {0, 0};  // [m/s^2]
};

/// Counts how often what it waits for comes about.
struct CountTouches {
  std::string counter = {};  // several events may count for one
  int count = 0;             // so far
};

/// One of them.
using SceneAction = std::variant<RemoveBody, RemoveJoint, PushBody, SwitchMotor, BreakJoint, ChangeBody,
                                 SetGravity, CountTouches, ApplyForce, FollowPath>;

/// What an event may wait for: one of some bodies begins to touch one of some others, or no longer does. They
/// touch in a step in which they push each other or overlap; a sensor touches what is in it. Of two bodies
/// one must be dynamic.
struct TouchCondition {
  /// Which of the two.
  enum class Change { begins, ends };

  List<BodyId> a = {};             // one of these
  List<BodyId> b = {};             // with one of these; none: with any body
  Change change = Change::begins;  // from not to touching, or back
};

/// Whether it is done for a while, and not at once.
inline bool is_lasting(const SceneAction& action) {
  return std::holds_alternative<ApplyForce>(action) || std::holds_alternative<FollowPath>(action);
}

/// An action and its time. It is done before the first step that begins at that time or later; one that lasts
/// begins at that very time.
struct SceneEvent {
  double time = 0;          // [s] since the world began; of one that waits for a touch, since the end of the
                            // step that saw it
  SceneAction action = {};  // what is done
  std::optional<TouchCondition> touch = {};  // what it waits for; none: for its time
  std::optional<int> times = {};             // that it does so, > 0; none: for ever
};

}  // namespace cairn
