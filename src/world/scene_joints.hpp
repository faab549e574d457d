// Floor 5. The joints of a scene, and what the scene knows of each.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <cairn/constraints/constraint.hpp>
#include <cairn/constraints/softness.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/joint_id.hpp>

namespace cairn {

/// In the order in which they were added. The number of a joint is its place here, from 0, which comes one
/// forward when a joint before it is removed; its id stays.
class SceneJoints {
 public:
  /// How many there are.
  int size() const { return joints_.size(); }
  /// Whether there are none.
  bool empty() const { return joints_.empty(); }
  /// All numbers, in order.
  Indices<int> indices() const { return joints_.indices(); }
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
  /// The spring that a joint has of its own under the policy soft; none: Stabilization::joint_soft.
  const std::optional<SwingSoftness>& soft(int number) const { return fastenings_[number].soft; }
  /// Pairs of bodies that a joint keeps from colliding, sorted, the lower id first.
  const List<std::pair<BodyId, BodyId>>& apart() const { return apart_; }

  /// Puts a joint behind the others. `collide`: its bodies may touch.
  JointId add(std::shared_ptr<const Constraint> joint, bool collide);
  /// Puts a joint in the place of one between the same bodies.
  void change(int number, std::shared_ptr<const Constraint> joint) { joints_[number] = std::move(joint); }
  /// Gives a joint a spring of its own.
  void change(int number, const SwingSoftness& spring) { fastenings_[number].soft = spring; }
  /// Takes joints out, whose numbers ascend.
  void remove(const List<int>& numbers);

 private:
  struct Fastening {
    JointId id = {};
    bool collide = true;  // its bodies may touch
    std::optional<SwingSoftness> soft = {};
  };

  void keep_apart(const Constraint& joint);

  List<std::shared_ptr<const Constraint>> joints_ = {};
  List<Fastening> fastenings_ = {};  // of joints_
  int made_ = 0;
  List<std::pair<BodyId, BodyId>> apart_ = {};
};

}  // namespace cairn
