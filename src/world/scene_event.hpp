// Floor 5. What happens to a scene while it runs, at times that are known before.
#pragma once

#include <optional>
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

/// One of them.
using SceneAction = std::variant<RemoveBody, RemoveJoint, PushBody, SwitchMotor, ApplyForce, FollowPath>;

/// Whether it is done for a while, and not at once.
inline bool is_lasting(const SceneAction& action) {
  return std::holds_alternative<ApplyForce>(action) || std::holds_alternative<FollowPath>(action);
}

/// An action and its time. It is done before the first step that begins at that time or later; one that lasts
/// begins at that very time.
struct SceneEvent {
  double time = 0;          // [s] since the world began
  SceneAction action = {};  // what is done
};

}  // namespace cairn
