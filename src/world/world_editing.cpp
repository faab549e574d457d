// Floor 5. Changing a world while it runs: the scene that it steps, and the hand that drags a body.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "math/check.hpp"
#include "world/world.hpp"

namespace cairn {

namespace {

bool same_motion(const SceneBody& one, const SceneBody& other) {
  return one.spec.velocity == other.spec.velocity && one.spec.angular_velocity == other.spec.angular_velocity;
}

bool same_place(const SceneBody& one, const SceneBody& other) {
  return one.pose.position == other.pose.position && one.pose.angle == other.pose.angle;
}

/// For each collider of the scene before, its number now; -1 where its shape is gone or another one. Never
/// descending.
List<int> numbers_now(const Scene& before, const Scene& now) {
  List<int> numbers;
  int next = 0;
  for (const BodyId id : before.bodies().indices()) {
    const List<Shape<double>>&old = before.bodies()[id].spec.shapes, &shapes = now.bodies()[id].spec.shapes;
    for (int i = 0; i < old.size(); ++i) {
      const bool is_same = i < shapes.size() && shapes[i] == old[i];
      for (int piece = 0; piece < piece_count(old[i]); ++piece) numbers.push_back(is_same ? next++ : -1);
      if (!is_same && i < shapes.size()) next += piece_count(shapes[i]);
    }
    for (int i = old.size(); i < shapes.size(); ++i) next += piece_count(shapes[i]);
  }
  return numbers;
}

/// In the order of the joints, which ascends.
List<JointId> joint_ids(const Scene& scene) {
  List<JointId> ids;
  for (int i = 0; i < scene.joints().size(); ++i) ids.push_back(scene.joint_id(i));
  return ids;
}

/// Whether two shapes lie among the same others as before.
template <Scalar Real>
bool has_same_surroundings(const Collider<Real>& one, const Collider<Real>& other) {
  const auto &around = one.form->around, &around_other = other.form->around;
  if (!around || !around_other) return around == around_other;
  return *around == *around_other;
}

}  // namespace

/// This world as it would go on after a change of its scene.
template <Scalar Real>
World<Real> World<Real>::after(const std::function<void(Scene&)>& change) {
  Scene then = *scene_;
  for (const BodyId body : state_.pose.indices()) {
    const SceneBody& known = then.bodies()[body];
    if (known.spec.type == BodyType::static_body) continue;
    const Pose<Real>& pose = state_.pose[body];
    then.place(body, {pose.position.template cast<double>(), static_cast<double>(pose.angle)},
               state_.velocity[body].template cast<double>());
  }
  Scene edited = then;
  {
    const Occupation::Scope scope(occupation_, "World::edit");
    change(edited);
  }
  if (!scene_) throw std::logic_error("World::edit: its world must not be moved away from within");
  World next(std::move(edited));
  next.carry_over(*this, then);
  return next;
}

template <Scalar Real>
void World<Real>::edit(const std::function<void(Scene&)>& change) {
  occupation_.refuse("World::edit");
  *this = after(change);
}

/// This world as it would go on after the events that are due; none where none is.
template <Scalar Real>
std::optional<World<Real>> World<Real>::after_events() {
  // A sum of n steps is off by fewer than n roundings of itself.
  const double until = time_ * (1 + steps_ * std::numeric_limits<double>::epsilon());
  const List<SceneEvent>& events = scene_->events();
  if (events.empty() || events.front().time > until) return {};
  return after([until](Scene& scene) { scene.do_events(until); });
}

template <Scalar Real>
bool World<Real>::do_events() {
  occupation_.refuse("World::do_events");
  std::optional<World> next = after_events();
  if (next) *this = std::move(*next);
  return next.has_value();
}

/// Takes over what `before`, whose scene was `then`, has that the scene of this world left alone.
template <Scalar Real>
void World<Real>::carry_over(const World& before, const Scene& then) {
  if (scene_->settings().dt == then.settings().dt) dt_ = before.dt_;
  time_ = before.time_;
  steps_ = before.steps_;
  hand_inputs_ = before.hand_inputs_;
  for (const BodyId body : then.bodies().indices()) {
    const SceneBody &was = then.bodies()[body], &is = scene_->bodies()[body];
    if (is.removed) continue;
    if (same_place(was, is)) state_.pose[body] = before.state_.pose[body];
    if (same_motion(was, is)) state_.velocity[body] = before.state_.velocity[body];
  }
  int joint = 0;  // of those before; ids ascend
  for (int i = 0; i < scene_->joints().size(); ++i) {
    while (joint < then.joints().size() && then.joint_id(joint) < scene_->joint_id(i)) ++joint;
    const bool is_old = joint < then.joints().size() && then.joint_id(joint) == scene_->joint_id(i);
    if (is_old) joint_impulses_[i] = before.joint_impulses_[joint];
  }
  if (before.hand_ && scene_->bodies()[before.hand_->body()].spec.type == BodyType::dynamic) {
    hand_ = before.hand_;
    joint_impulses_.back() = before.joint_impulses_.back();
  }
  carry_contacts(before);
  if (sleep_ && before.sleep_) carry_sleep(before, then);
}

template <Scalar Real>
void World<Real>::carry_contacts(const World& before) {
  const List<int> numbers = numbers_now(*before.scene_, *scene_);
  List<ContactSlot<Real>> slots;
  List<LastingManifold<Real>> lasting;
  for (const NearSlot& near : before.graph_.order()) {
    if (near.slot == NearSlot::none) continue;
    const ContactSlot<Real>& old = before.graph_[near.slot];
    const int a = numbers[old.collider_a], b = numbers[old.collider_b];
    if (a < 0 || b < 0 || !may_meet(a, b)) continue;
    ContactSlot<Real> slot = make_slot(a, b);
    slot.impulses = old.impulses;
    slots.push_back(slot);
    if (!before.graph_.lasts()) continue;
    lasting.push_back(before.graph_.lasting(near.slot));
    lasting.back().is_found = lasting.back().is_found &&
                              has_same_surroundings((*before.colliders_)[old.collider_a], (*colliders_)[a]) &&
                              has_same_surroundings((*before.colliders_)[old.collider_b], (*colliders_)[b]);
  }
  graph_.begin_with(std::move(slots), std::move(lasting));
}

/// Everything sleeps on but for what has changed, and what touched it or was held by it.
template <Scalar Real>
void World<Real>::carry_sleep(const World& before, const Scene& then) {
  sleep_->carry_over(*before.sleep_);
  if (!(scene_->settings() == then.settings())) {
    for (const BodyId body : then.bodies().indices()) sleep_->wake(body);
    return;
  }
  const auto has_changed = [&](BodyId body) {
    const SceneBody &was = then.bodies()[body], &is = scene_->bodies()[body];
    return !(was.spec == is.spec && same_place(was, is));
  };
  for (const BodyId body : then.bodies().indices()) {
    if (has_changed(body)) sleep_->wake(body);
  }
  for (const NearSlot& near : before.graph_.order()) {
    if (near.slot == NearSlot::none) continue;
    const ContactSlot<Real>& slot = before.graph_[near.slot];
    if (slot.impulses.count == 0) continue;
    if (has_changed(slot.a)) sleep_->wake(slot.b);
    if (has_changed(slot.b)) sleep_->wake(slot.a);
  }
  const auto wake_ends = [&](const Scene& scene, const Scene& other) {
    const List<JointId> others = joint_ids(other);
    for (int i = 0; i < scene.joints().size(); ++i) {
      const auto found = std::lower_bound(others.begin(), others.end(), scene.joint_id(i));
      const bool is_there = found != others.end() && *found == scene.joint_id(i);
      const int k = static_cast<int>(found - others.begin());
      const bool is_same = is_there && other.joints()[k] == scene.joints()[i];
      if (is_same && other.joint_soft(k) == scene.joint_soft(i)) continue;
      for (const Attachment& end : scene.joints()[i]->attachments()) sleep_->wake(end.body);
    }
  };
  wake_ends(then, *scene_);
  wake_ends(*scene_, then);
}

template <Scalar Real>
void World<Real>::grab(const DragJoint::Spec& grip) {
  occupation_.refuse("World::grab");
  PerBody<Pose<double>> poses;
  for (const Pose<Real>& pose : state_.pose) {
    poses.push_back({pose.position.template cast<double>(), static_cast<double>(pose.angle)});
  }
  auto hand = std::make_shared<const DragJoint>(grip, poses);
  require(scene_->bodies()[grip.body].spec.type == BodyType::dynamic, "World::grab", "body",
          "one that is dynamic", grip.body.index);
  keep_rows();  // which are without the hand's
  hand_ = std::move(hand);
  joint_impulses_.back() = {};
  hand_inputs_.push_back({.step = steps_, .kind = HandInput::Kind::grab, .grip = grip});
}

template <Scalar Real>
void World<Real>::drag_to(const Vec2<double>& target) {
  occupation_.refuse("World::drag_to");
  require(hand_ != nullptr, "World::drag_to", "target", "given while the hand holds a body", "nothing held");
  hand_ = std::make_shared<const DragJoint>(hand_->moved_to(target));
  hand_inputs_.push_back({.step = steps_, .kind = HandInput::Kind::drag_to, .target = target});
}

template <Scalar Real>
void World<Real>::let_go() {
  occupation_.refuse("World::let_go");
  if (!hand_) return;
  hand_.reset();
  hand_inputs_.push_back({.step = steps_, .kind = HandInput::Kind::let_go});
}

template <Scalar Real>
void World<Real>::repeat(const HandInput& input) {
  switch (input.kind) {
    case HandInput::Kind::grab:
      return grab(input.grip);
    case HandInput::Kind::drag_to:
      return drag_to(input.target);
    case HandInput::Kind::let_go:
      return let_go();
  }
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
