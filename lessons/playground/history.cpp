// A step's numbers, and one body's or pair's of all steps.
#include "lessons/playground/history.hpp"

#include <algorithm>
#include <limits>

namespace cairn::playground {

void History::keep(const Snapshot& snapshot) {
  while (!moments_.empty() && moments_.back().step >= snapshot.step) moments_.pop_back();
  Moment now{.step = snapshot.step, .time = snapshot.time};
  for (const SnapshotBody& body : snapshot.bodies)
    now.bodies.push_back(
        {body.pose.position.y(), body.velocity.head<2>().norm(), body.velocity.z(), !body.removed});
  const double dt = snapshot.dt;
  if (dt > 0) {
    for (const SnapshotContact& contact : snapshot.contacts) {
      const Vec2<double> along(contact.normal.y(), -contact.normal.x());
      const Vec2<double> push = contact.normal_impulse * contact.normal + contact.friction_impulse * along;
      now.pushes.push_back({{contact.a, contact.b}, push / dt});
    }
    for (const SnapshotJoint& joint : snapshot.joints) {
      if (joint.id.index >= 0) now.pushes.push_back({{joint.a, joint.b}, joint.impulse / dt});
    }
  }
  moments_.push_back(std::move(now));
  if (static_cast<int>(moments_.size()) > most_steps_ + 1) moments_.pop_front();
  shown_ = static_cast<int>(moments_.size());
}

void History::show(int last_step) {
  shown_ = static_cast<int>(std::count_if(moments_.begin(), moments_.end(),
                                          [&](const Moment& moment) { return moment.step <= last_step; }));
}

List<double> History::of_body(BodyId body) const {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  List<double> numbers;
  for (int i = 0; i < shown_; ++i) {
    const Moment& moment = moments_[static_cast<std::size_t>(i)];
    const bool is_known = body.index >= 0 && body.index < moment.bodies.size();
    const BodyMoment now = is_known ? moment.bodies[body] : BodyMoment{};
    const double missing = now.is_there ? 0 : nothing;
    for (const double number : {moment.time, now.y + missing, now.speed + missing, now.omega + missing})
      numbers.push_back(number);
  }
  return numbers;
}

List<double> History::of_pair(BodyId a, BodyId b) const {
  List<double> numbers;
  for (int i = 0; i < shown_; ++i) {
    const Moment& moment = moments_[static_cast<std::size_t>(i)];
    Vec2<double> force(0, 0);
    for (const Push& push : moment.pushes) {
      if (push.pair == std::pair(a, b)) force += push.force;
      if (push.pair == std::pair(b, a)) force -= push.force;
    }
    numbers.push_back(moment.time);
    numbers.push_back(force.norm());
  }
  return numbers;
}

}  // namespace cairn::playground
