// Floor 5. Which islands fall asleep, and which wake.
#include "world/sleeping.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace cairn {

template <Scalar Real>
SleepState<Real>::SleepState(const Scene& scene) : settings_(scene.settings().sleeping.value()) {
  for (const SceneBody& body : scene.bodies()) {
    const BodyId id{type_.size()};
    type_.push_back(body.spec.type);
    sensor_.push_back(body.spec.sensor ? 1 : 0);
    for (const Shape<double>& shape : body.spec.shapes) owner_.resize(owner_.size() + piece_count(shape), id);
  }
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) {
    List<BodyId> tied;
    for (const Attachment& place : joint->attachments()) tied.push_back(place.body);
    joints_.push_back(tied);
  }
  island_.assign(type_.size(), awake);
  still_for_.assign(type_.size(), 0);
  parent_.resize(type_.size());
  restless_.resize(type_.size());
}

/// Calls visit(bodies) for every manifold and every joint.
template <Scalar Real>
template <typename Visit>
void SleepState<Real>::for_each_tie(const List<Manifold<Real>>& manifolds, const Visit& visit) const {
  for (const Manifold<Real>& manifold : manifolds) {
    const FixedList<BodyId, 2> tied = {owner_[manifold.collider_a], owner_[manifold.collider_b]};
    visit(Span<const BodyId>(tied));
  }
  for (const List<BodyId>& tied : joints_) visit(Span<const BodyId>(tied));
}

template <Scalar Real>
bool SleepState<Real>::joint_asleep(int joint) const {
  const List<BodyId>& tied = joints_[joint];
  return std::any_of(tied.begin(), tied.end(), [this](BodyId body) { return asleep(body); });
}

/// Whether it can disturb what it touches: an awake dynamic body, or a kinematic one on its way.
template <Scalar Real>
bool SleepState<Real>::disturbs(BodyId body, const PerBody<Vec3<Real>>& velocity) const {
  if (is_dynamic(body)) return !asleep(body);
  return type_[body] == BodyType::kinematic && !velocity[body].isZero(0);
}

template <Scalar Real>
void SleepState<Real>::mark_movable(const PerBody<Vec3<Real>>& velocity, List<char>& movable) const {
  for (int i = 0; i < owner_.size(); ++i) {
    movable[i] = sensor_[owner_[i]] || disturbs(owner_[i], velocity) ? 1 : 0;
  }
}

template <Scalar Real>
bool SleepState<Real>::wake_touched(const List<Manifold<Real>>& manifolds,
                                    const PerBody<Vec3<Real>>& velocity) {
  bool found = false;
  for_each_tie(manifolds, [&](Span<const BodyId> tied) {
    const bool disturbed =
        std::any_of(tied.begin(), tied.end(), [&](BodyId body) { return disturbs(body, velocity); });
    if (!disturbed) return;
    for (const BodyId body : tied) {
      if (!asleep(body)) continue;
      wake(body);
      found = true;
    }
  });
  return found;
}

template <Scalar Real>
void SleepState<Real>::wake(BodyId body) {
  still_for_[body] = 0;
  if (!asleep(body)) return;
  const BodyId woken = island_[body];
  for (const BodyId other : island_.indices()) {
    if (island_[other] != woken) continue;
    island_[other] = awake;
    still_for_[other] = 0;
  }
}

template <Scalar Real>
void SleepState<Real>::carry_over(const SleepState& before) {
  for (const BodyId body : before.island_.indices()) {
    if (!is_dynamic(body)) continue;
    island_[body] = before.island_[body];
    still_for_[body] = before.still_for_[body];
  }
}

template <Scalar Real>
void SleepState<Real>::hold(PerBody<Vec3<Real>>& velocity) const {
  for (const BodyId body : island_.indices()) {
    if (island_[body] != awake) velocity[body].setZero();
  }
}

template <Scalar Real>
void SleepState<Real>::let_sleep(const List<Manifold<Real>>& manifolds, double dt,
                                 PerBody<Vec3<Real>>& velocity) {
  count_still_time(dt, velocity);
  for (const BodyId body : parent_.indices()) parent_[body] = body;
  for_each_tie(manifolds, [&](Span<const BodyId> tied) { connect(tied, velocity); });
  put_to_sleep(dt, velocity);
}

template <Scalar Real>
void SleepState<Real>::count_still_time(double dt, const PerBody<Vec3<Real>>& velocity) {
  for (const BodyId body : velocity.indices()) {
    // Written so that a speed that is not a number is not slow.
    const bool slow = static_cast<double>(velocity[body].template head<2>().norm()) < settings_.speed &&
                      std::abs(static_cast<double>(velocity[body].z())) < settings_.angular_speed;
    still_for_[body] = slow ? still_for_[body] + dt : 0;
  }
}

/// Makes one island of the dynamic bodies among those tied; keeps them awake if one moves by a given
/// velocity.
template <Scalar Real>
void SleepState<Real>::connect(Span<const BodyId> tied, const PerBody<Vec3<Real>>& velocity) {
  const bool carried = std::any_of(
      tied.begin(), tied.end(), [&](BodyId body) { return !is_dynamic(body) && disturbs(body, velocity); });
  BodyId first = awake;
  for (const BodyId body : tied) {
    if (!is_dynamic(body)) continue;
    if (carried) still_for_[body] = 0;
    const BodyId root = root_of(body);
    if (first == awake) first = root;
    const BodyId low = std::min(first, root);
    parent_[std::max(first, root)] = low;
    first = low;
  }
}

/// The lowest id of a body's island. Halves the path on the way.
template <Scalar Real>
BodyId SleepState<Real>::root_of(BodyId body) {
  while (parent_[body] != body) {
    parent_[body] = parent_[parent_[body]];
    body = parent_[body];
  }
  return body;
}

/// Islands of which every body has been slow for long enough, to the nearest step.
template <Scalar Real>
void SleepState<Real>::put_to_sleep(double dt, PerBody<Vec3<Real>>& velocity) {
  std::fill(restless_.begin(), restless_.end(), char{0});
  for (const BodyId body : still_for_.indices()) {
    const bool still = still_for_[body] > 0 && still_for_[body] > settings_.time - dt / 2;
    if (!still) restless_[root_of(body)] = 1;
  }
  count_ = {};
  for (const BodyId body : island_.indices()) {
    if (type_[body] != BodyType::dynamic || island_[body] != awake) continue;
    const BodyId root = root_of(body);
    if (restless_[root]) {
      count_.bodies += 1;
      count_.islands += root == body;
      continue;
    }
    island_[body] = root;
    velocity[body].setZero();
  }
}

template class SleepState<float>;
template class SleepState<double>;
template class SleepState<long double>;

}  // namespace cairn
