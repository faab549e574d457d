// Floor 5. Which islands fall asleep, and which wake.
#include "world/sleeping.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace cairn {

template <Scalar Real>
SleepState<Real>::SleepState(const Scene& scene) : settings_(scene.settings().sleeping.value()) {
  for (const SceneBody& body : scene.bodies()) {
    const BodyId id{static_cast<int>(type_.size())};
    type_.push_back(body.spec.type);
    sensor_.push_back(body.spec.sensor ? 1 : 0);
    owner_.insert(owner_.end(), body.spec.shapes.size(), id);
  }
  for (const std::shared_ptr<const Constraint>& joint : scene.joints()) {
    std::vector<BodyId> tied;
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
void SleepState<Real>::for_each_tie(const std::vector<Manifold<Real>>& manifolds, const Visit& visit) const {
  for (const Manifold<Real>& manifold : manifolds) {
    const std::array<BodyId, 2> tied = {owner_[static_cast<std::size_t>(manifold.collider_a)],
                                        owner_[static_cast<std::size_t>(manifold.collider_b)]};
    visit(std::span<const BodyId>(tied));
  }
  for (const std::vector<BodyId>& tied : joints_) visit(std::span<const BodyId>(tied));
}

template <Scalar Real>
bool SleepState<Real>::joint_asleep(std::size_t joint) const {
  const std::vector<BodyId>& tied = joints_[joint];
  return std::any_of(tied.begin(), tied.end(), [this](BodyId body) { return asleep(body); });
}

/// Whether it can disturb what it touches: an awake dynamic body, or a kinematic one on its way.
template <Scalar Real>
bool SleepState<Real>::disturbs(BodyId body, const std::vector<Vec3<Real>>& velocity) const {
  if (is_dynamic(body)) return !asleep(body);
  return type_[index_of(body)] == BodyType::kinematic && !velocity[index_of(body)].isZero(0);
}

template <Scalar Real>
void SleepState<Real>::mark_movable(const std::vector<Vec3<Real>>& velocity,
                                    std::vector<char>& movable) const {
  for (std::size_t i = 0; i < owner_.size(); ++i) {
    movable[i] = sensor_[index_of(owner_[i])] || disturbs(owner_[i], velocity) ? 1 : 0;
  }
}

template <Scalar Real>
bool SleepState<Real>::wake_touched(const std::vector<Manifold<Real>>& manifolds,
                                    const std::vector<Vec3<Real>>& velocity) {
  bool found = false;
  for_each_tie(manifolds, [&](std::span<const BodyId> tied) {
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
  still_for_[index_of(body)] = 0;
  if (!asleep(body)) return;
  const int woken = island_[index_of(body)];
  for (std::size_t i = 0; i < island_.size(); ++i) {
    if (island_[i] != woken) continue;
    island_[i] = awake;
    still_for_[i] = 0;
  }
  has_woken_ = true;
}

template <Scalar Real>
void SleepState<Real>::give_back(std::vector<std::pair<RowKey, Real>>& impulses, double dt) {
  if (!has_woken_) return;
  has_woken_ = false;
  // The island of an impulse sleeps as long as the body does that it is named after.
  const auto woken = std::stable_partition(kept_.begin(), kept_.end(), [this](const KeptImpulse& kept) {
    return island_[static_cast<std::size_t>(kept.island)] == kept.island;
  });
  for (auto kept = woken; kept != kept_.end(); ++kept) {
    impulses.emplace_back(kept->key, kept->impulse * static_cast<Real>(dt / kept->dt));
  }
  kept_.erase(woken, kept_.end());
  std::sort(impulses.begin(), impulses.end(),
            [](const auto& left, const auto& right) { return left.first < right.first; });
}

template <Scalar Real>
void SleepState<Real>::hold(std::vector<Vec3<Real>>& velocity) const {
  for (std::size_t i = 0; i < island_.size(); ++i) {
    if (island_[i] != awake) velocity[i].setZero();
  }
}

template <Scalar Real>
void SleepState<Real>::let_sleep(const std::vector<Manifold<Real>>& manifolds,
                                 const VelocityProblem<Real>& problem, double dt,
                                 std::vector<Vec3<Real>>& velocity) {
  count_still_time(dt, velocity);
  for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<int>(i);
  for_each_tie(manifolds, [&](std::span<const BodyId> tied) { connect(tied, velocity); });
  if (put_to_sleep(dt, velocity)) keep_impulses(problem);
}

template <Scalar Real>
void SleepState<Real>::count_still_time(double dt, const std::vector<Vec3<Real>>& velocity) {
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    // Written so that a speed that is not a number is not slow.
    const bool slow = static_cast<double>(velocity[i].template head<2>().norm()) < settings_.speed &&
                      std::abs(static_cast<double>(velocity[i].z())) < settings_.angular_speed;
    still_for_[i] = slow ? still_for_[i] + dt : 0;
  }
}

/// Makes one island of the dynamic bodies among those tied; keeps them awake if one moves by a given
/// velocity.
template <Scalar Real>
void SleepState<Real>::connect(std::span<const BodyId> tied, const std::vector<Vec3<Real>>& velocity) {
  const bool carried = std::any_of(
      tied.begin(), tied.end(), [&](BodyId body) { return !is_dynamic(body) && disturbs(body, velocity); });
  int first = awake;
  for (const BodyId body : tied) {
    if (!is_dynamic(body)) continue;
    if (carried) still_for_[index_of(body)] = 0;
    const int root = root_of(body.index);
    if (first == awake) first = root;
    const int low = std::min(first, root);
    parent_[static_cast<std::size_t>(std::max(first, root))] = low;
    first = low;
  }
}

/// The lowest id of a body's island. Halves the path on the way.
template <Scalar Real>
int SleepState<Real>::root_of(int body) {
  auto i = static_cast<std::size_t>(body);
  while (parent_[i] != static_cast<int>(i)) {
    parent_[i] = parent_[static_cast<std::size_t>(parent_[i])];
    i = static_cast<std::size_t>(parent_[i]);
  }
  return static_cast<int>(i);
}

/// Islands of which every body has been slow for long enough, to the nearest step: whether there were any.
template <Scalar Real>
bool SleepState<Real>::put_to_sleep(double dt, std::vector<Vec3<Real>>& velocity) {
  std::fill(restless_.begin(), restless_.end(), char{0});
  for (std::size_t i = 0; i < island_.size(); ++i) {
    const bool still = still_for_[i] > 0 && still_for_[i] > settings_.time - dt / 2;
    if (!still) restless_[static_cast<std::size_t>(root_of(static_cast<int>(i)))] = 1;
  }
  bool found = false;
  count_ = {};
  for (std::size_t i = 0; i < island_.size(); ++i) {
    if (type_[i] != BodyType::dynamic || island_[i] != awake) continue;
    const int root = root_of(static_cast<int>(i));
    if (restless_[static_cast<std::size_t>(root)]) {
      count_.bodies += 1;
      count_.islands += root == static_cast<int>(i);
      continue;
    }
    island_[i] = root;
    velocity[i].setZero();
    found = true;
  }
  return found;
}

template <Scalar Real>
void SleepState<Real>::keep_impulses(const VelocityProblem<Real>& problem) {
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    int island = awake;
    for_each_term(problem, problem.rows[i], [&](BodyId body, const Vec3<Real>&) {
      island = std::max(island, island_[index_of(body)]);
    });
    if (island == awake) continue;
    kept_.push_back({.key = problem.rows[i].key,
                     .impulse = problem.impulse[i],
                     .dt = static_cast<double>(problem.dt),
                     .island = island});
  }
}

template class SleepState<float>;
template class SleepState<double>;
template class SleepState<long double>;

}  // namespace cairn
