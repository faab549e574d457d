// Floor 5. The hand that drags a body, and all that it has done.
#pragma once

#include <memory>

#include <cairn/constraints/drag_joint.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// What a hand does before a step: takes hold of a body, goes on to another target, or lets go.
struct HandInput {
  /// The three things that it does.
  enum class Kind { grab, drag_to, let_go };

  int step = 0;                  // before which it was done: World::steps(). Whoever does it need not say
  Kind kind = Kind::let_go;      // what was done
  DragJoint::Spec grip = {};     // of grab
  Vec2<double> target = {0, 0};  // [m] of drag_to

  /// Takes hold of a body, in place of what was held before, and pulls it to grip.target.
  static HandInput grab(const DragJoint::Spec& grip) { return {.kind = Kind::grab, .grip = grip}; }
  /// Pulls what is held to another point [m].
  static HandInput drag_to(const Vec2<double>& target) { return {.kind = Kind::drag_to, .target = target}; }
  /// Lets go of what is held, if anything is.
  static HandInput let_go() { return {}; }
};

/// What drags a body through a world, by a spring.
class Hand {
 public:
  /// The spring to what it holds; null: it holds nothing.
  const DragJoint* joint() const { return joint_.get(); }
  /// All that it has done. A world that begins as its world did, and for which each is repeated before the
  /// step of its number, takes the same steps to the last bit.
  const List<HandInput>& inputs() const { return inputs_; }

  /// Does it before a step, to bodies of the scene that stand so; of poses those for grab are enough.
  /// @throws std::invalid_argument as DragJoint, for a body that is not dynamic, and for a target while
  /// nothing is held: then nothing has changed.
  void move(const HandInput& input, int step, const Scene& scene, PerBodySpan<const Pose<double>> poses);
  /// The hand in a scene that has changed: it has let go of what is not dynamic any more.
  Hand in(const Scene& scene) const;

 private:
  std::shared_ptr<const DragJoint> joint_;
  List<HandInput> inputs_;
};

}  // namespace cairn
