// Floor 5. The joints of a scene, and what the scene knows of each.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <cairn/constraints/constraint.hpp>
#include <cairn/constraints/softness.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/joint_id.hpp>

namespace cairn {

/// What a joint holds at most: the force and the torque that it gives its last body, as means over a step. A
/// joint that had to hold more breaks, and is gone before the next step.
struct JointStrength {
  double force = std::numeric_limits<double>::infinity();   // [N]
  double torque = std::numeric_limits<double>::infinity();  // [N m] about where it is fastened to that body

  /// Member by member.
  bool operator==(const JointStrength&) const = default;
  /// Whether there is anything that breaks it.
  bool is_finite() const { return std::isfinite(force) || std::isfinite(torque); }
};

/// What the scene says of a joint beside what it is.
struct JointHold {
  std::optional<SwingSoftness> soft = {};  // under the policy soft; none: Stabilization::joint_soft
  JointStrength strength = {};             // above which it breaks

  /// Member by member.
  bool operator==(const JointHold&) const = default;
};

/// A joint that has broken.
struct BrokenJoint {
  JointId id = {};                               // that it had
  std::shared_ptr<const Constraint> joint = {};  // what it was
  double time = 0;                               // [s] when it broke
  double force = 0;                              // [N] that it held then
  double torque = 0;                             // [N m] likewise
};

/// In the order in which they were added. The number of a joint is its place here, from 0, which comes one
/// forward when a joint before it is removed; its id stays.
class SceneJoints {
 public:
  /// How many there are.
  int size() const { return joints_.size(); }
  /// Whether there are none.
  bool empty() const { return joints_.empty(); }
  /// One of them.
  const std::shared_ptr<const Constraint>& operator[](int number) const { return joints_[number]; }
  /// The first of them.
  auto begin() const { return joints_.begin(); }
  /// Behind the last.
  auto end() const { return joints_.end(); }

  /// Ids ascend with numbers. @throws std::invalid_argument for a number that no joint has.
  JointId id(int number) const;
  /// Which number a joint has; none where it is not there.
  std::optional<int> number_of(JointId id) const;
  /// What the scene says of one.
  const JointHold& hold(int number) const { return fastenings_[number].hold; }
  /// Those that have broken, in their order.
  const List<BrokenJoint>& broken() const { return broken_; }
  /// Pairs of bodies that a joint keeps from colliding, sorted, the lower id first.
  const List<std::pair<BodyId, BodyId>>& apart() const { return apart_; }

  /// Puts a joint behind the others. `collide`: its bodies may touch.
  JointId add(std::shared_ptr<const Constraint> joint, bool collide);
  /// Puts a joint in the place of one between the same bodies.
  void change(int number, std::shared_ptr<const Constraint> joint) { joints_[number] = std::move(joint); }
  /// Gives a joint a spring of its own.
  void change(int number, const SwingSoftness& spring) { fastenings_[number].hold.soft = spring; }
  /// Gives a joint a strength.
  void change(int number, const JointStrength& strength) { fastenings_[number].hold.strength = strength; }
  /// Takes joints out, whose numbers ascend.
  void remove(const List<int>& numbers);
  /// Takes out one that has broken: `how` says when, and what it held then.
  void remove(int number, BrokenJoint how);

 private:
  struct Fastening {
    JointId id = {};
    bool collide = true;  // its bodies may touch
    JointHold hold = {};
  };

  void keep_apart(const Constraint& joint);

  List<std::shared_ptr<const Constraint>> joints_ = {};
  List<Fastening> fastenings_ = {};  // of joints_
  int made_ = 0;
  List<std::pair<BodyId, BodyId>> apart_ = {};
  List<BrokenJoint> broken_ = {};
};

}  // namespace cairn
