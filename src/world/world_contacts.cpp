// Floor 5. What touches what: from poses to manifolds.
#include <algorithm>

#include "collision/collide.hpp"
#include "world/world.hpp"
#include "math/list.hpp"

namespace cairn {

template <Scalar Real>
void World<Real>::find_contacts() {
  find_manifolds();
  if (!sleep_) return;
  // What wakes may touch, or hold, what else sleeps.
  while (sleep_->wake_touched(record_.manifolds, state_.velocity)) find_manifolds();
  sleep_->give_back(impulses_, previous_dt_);
}

template <Scalar Real>
void World<Real>::find_manifolds() {
  record_.manifolds.clear();
  record_.sensed.clear();
  if (!plan_->collision) return;
  const Real margin = static_cast<Real>(scene_->settings().speculative_margin);
  const List<Collider>& colliders = *colliders_;
  for (int i = 0; i < colliders.size(); ++i) {
    const BodyId body = colliders[i].body;
    const Pose<Real>& pose = state_.pose[body];
    boxes_[i] = bounding_box(colliders[i].shape, pose, margin / 2 + reach(body));
  }
  if (sleep_) sleep_->mark_movable(state_.velocity, movable_);
  for (const auto& [i, j] : broadphase_.pairs(boxes_, movable_)) meet(i, j);
  std::sort(record_.sensed.begin(), record_.sensed.end());
  record_.sensed.erase(std::unique(record_.sensed.begin(), record_.sensed.end()), record_.sensed.end());
}

/// One pair that is near: its manifold, if the two may touch.
template <Scalar Real>
void World<Real>::meet(int collider_a, int collider_b) {
  const Collider& a = (*colliders_)[collider_a];
  const Collider& b = (*colliders_)[collider_b];
  if (a.body == b.body) return;
  const BodySpec& spec_a = scene_->bodies()[a.body].spec;
  const BodySpec& spec_b = scene_->bodies()[b.body].spec;
  if (spec_a.type != BodyType::dynamic && spec_b.type != BodyType::dynamic) return;
  const std::pair<BodyId, BodyId> bodies = std::minmax(a.body, b.body);
  const auto& apart = scene_->apart();
  if (!may_touch(spec_a, spec_b) || std::binary_search(apart.begin(), apart.end(), bodies)) return;

  const bool is_sensed = spec_a.sensor || spec_b.sensor;
  const Real wide = static_cast<Real>(scene_->settings().speculative_margin) + reach(a.body) + reach(b.body);
  Manifold<Real> manifold =
      collide(a.shape, state_.pose[a.body], b.shape, state_.pose[b.body], is_sensed ? Real(0) : wide);
  if (manifold.count == 0) return;
  if (is_sensed) {
    record_.sensed.push_back(bodies);
    return;
  }
  manifold.collider_a = collider_a;
  manifold.collider_b = collider_b;
  record_.manifolds.push_back(manifold);
}

/// How far a fast body can come within a substep [m]; 0 for every other body, unless it comes farther than
/// its largest shape is long: then it could pass through another of its size.
template <Scalar Real>
Real World<Real>::reach(BodyId body) const {
  const BodySpec& spec = scene_->bodies()[body].spec;
  if (spec.type == BodyType::static_body) return 0;
  const Real dt = substep_length();
  const Real gravity = static_cast<Real>(spec.gravity_scale * scene_->settings().gravity.norm());
  const Real way = dt * (state_.velocity[body].template head<2>().norm() + dt * std::abs(gravity));
  return spec.fast || way > length_[body] ? way : Real(0);
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
