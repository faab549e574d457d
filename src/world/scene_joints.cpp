// Floor 5. Joints come and go, and with them who is kept apart.
#include <cairn/world/scene_joints.hpp>

#include <algorithm>

#include <cairn/math/check.hpp>

namespace cairn {

JointId SceneJoints::id(int number) const {
  require(number >= 0 && number < size(), "SceneJoints::id", "number", "that of a joint of the scene",
          number);
  return fastenings_[number].id;
}

std::optional<int> SceneJoints::number_of(JointId id) const {
  const auto comes_before = [](const Fastening& one, JointId other) { return one.id < other; };
  const auto found = std::lower_bound(fastenings_.begin(), fastenings_.end(), id, comes_before);
  if (found == fastenings_.end() || found->id != id) return {};
  return static_cast<int>(found - fastenings_.begin());
}

JointId SceneJoints::add(std::shared_ptr<const Constraint> joint, bool collide) {
  if (!collide) keep_apart(*joint);
  const JointId id{made_++};
  fastenings_.push_back({.id = id, .collide = collide});
  joints_.push_back(std::move(joint));
  return id;
}

/// A pair stays apart while one of its joints says so.
void SceneJoints::remove(const List<int>& numbers) {
  for (int k = numbers.size() - 1; k >= 0; --k) {
    joints_.erase(joints_.begin() + numbers[k]);
    fastenings_.erase(fastenings_.begin() + numbers[k]);
  }
  apart_.clear();
  for (int i = 0; i < joints_.size(); ++i) {
    if (!fastenings_[i].collide) keep_apart(*joints_[i]);
  }
}

void SceneJoints::remove(int number, BrokenJoint how) {
  how.id = fastenings_[number].id;
  how.joint = joints_[number];
  broken_.push_back(std::move(how));
  remove({number});
}

void SceneJoints::keep_apart(const Constraint& joint) {
  const List<Attachment> places = joint.attachments();
  for (int i = 0; i < places.size(); ++i) {
    for (int k = 0; k < i; ++k) {
      const std::pair<BodyId, BodyId> pair = std::minmax(places[i].body, places[k].body);
      const auto where = std::lower_bound(apart_.begin(), apart_.end(), pair);
      if (where == apart_.end() || *where != pair) apart_.insert(where, pair);
    }
  }
}

}  // namespace cairn
