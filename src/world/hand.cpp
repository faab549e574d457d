// Floor 5. Holding on and letting go.
#include <cairn/world/hand.hpp>

#include <cairn/math/check.hpp>

namespace cairn {

void Hand::move(const HandInput& input, int step, const Scene& scene, PerBodySpan<const Pose<double>> poses) {
  std::shared_ptr<const DragJoint> next;
  if (input.kind == HandInput::Kind::grab) {
    next = std::make_shared<const DragJoint>(input.grip, poses);
    require(scene.bodies()[next->body()].spec.type == BodyType::dynamic, "Hand::move", "body",
            "one that is dynamic", next->body().index);
  } else if (input.kind == HandInput::Kind::drag_to) {
    require(joint_ != nullptr, "Hand::move", "target", "given while the hand holds a body", "nothing held");
    next = std::make_shared<const DragJoint>(joint_->moved_to(input.target));
  } else if (!joint_) {
    return;
  }
  inputs_.push_back(input);
  inputs_.back().step = step;
  joint_ = std::move(next);
}

Hand Hand::in(const Scene& scene) const {
  Hand hand = *this;
  if (joint_ && scene.bodies()[joint_->body()].spec.type != BodyType::dynamic) hand.joint_ = nullptr;
  return hand;
}

}  // namespace cairn
