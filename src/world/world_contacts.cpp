// Floor 5. What touches what: from poses to manifolds.
#include <algorithm>
#include <cmath>

#include "collision/collide.hpp"
#include "world/world.hpp"
#include "math/deadline.hpp"
#include "math/list.hpp"

namespace cairn {

// Of the slop that two shapes may have: by how much a point may move before a manifold is found anew. Of
// bodies of 1 m that is 5 mm, as in Box2D.
constexpr double keep_share = 0.1;

template <Scalar Real>
void World<Real>::find_contacts(ContactSolver<Real>* solver) {
  find_manifolds(solver);
  if (!sleep_) return;
  // What wakes may touch, or hold, what else sleeps.
  while (sleep_->wake_touched(record_.manifolds, state_.velocity)) find_manifolds(solver);
}

/// Where every body is.
template <Scalar Real>
void World<Real>::locate_bodies() {
  for (const BodyId body : state_.pose.indices()) frames_[body] = state_.pose[body];
}

/// Those of the solver's last contacts, if it can go on with them, stay as they are.
template <Scalar Real>
void World<Real>::find_manifolds(ContactSolver<Real>* solver) {
  record_.sensed.clear();
  candidates_.swap(candidates_before_);
  candidates_.clear();
  follows_ = false;
  if (!plan_->collision) return;
  if (!plan_->moves_manifolds) {
    record_.manifolds.clear();
    touching_.clear();
  }
  locate_bodies();
  measure_reach();
  if (plan_->moves_manifolds && plan_->substeps > 1) look_ahead();
  const Real margin = static_cast<Real>(scene_->settings().speculative_margin);
  const List<Collider>& colliders = *colliders_;
  for (int i = 0; i < colliders.size(); ++i) {
    const BodyId body = colliders[i].body;
    boxes_[i] = bounding_box(*colliders[i].form->shape, frames_[body], margin / 2 + reach_[body]);
  }
  if (sleep_) sleep_->mark_movable(state_.velocity, movable_);
  found_anew_ = graph_.update(boxes_, [this](int i, int j) { return may_meet(i, j); });
  for (NearSlot& near : graph_.order()) {
    Deadline::go_on();
    meet(near);
  }
  std::sort(record_.sensed.begin(), record_.sensed.end());
  record_.sensed.erase(std::unique(record_.sensed.begin(), record_.sensed.end()), record_.sensed.end());
  if (!plan_->moves_manifolds || follow_last_step(solver)) return;
  if (plan_->substeps > 1) measure_reach();
  put_manifolds();
}

/// Contacts are sought for all substeps: a body, and what is at its rim, may come as far as in a step.
template <Scalar Real>
void World<Real>::look_ahead() {
  const Real dt = static_cast<Real>(dt_);
  for (const BodyId body : reach_.indices()) {
    const Real turning = std::abs(state_.velocity[body].z()) * traits(body).radius;
    reach_[body] = std::max(reach_[body], way(body, dt) + dt * turning);
  }
}

/// The manifolds that were found, where the bodies are now.
template <Scalar Real>
void World<Real>::move_manifolds() {
  if (!candidates_.empty()) {
    locate_bodies();
    measure_reach();
  }
  put_manifolds();
}

/// The same once it is known where the bodies are.
template <Scalar Real>
void World<Real>::put_manifolds() {
  record_.manifolds.clear();
  touching_.clear();
  odd_.clear();
  for (const int number : candidates_) {
    const Manifold<Real> manifold = moved_manifold(number);
    if (!graph_.lasting(number).manifold.is_whole(manifold)) {
      odd_.push_back({.slot = number, .contact = manifold.count > 0 ? touching_.size() : OddContact::none});
    }
    touch(number, manifold);
  }
}

/// The manifold of a slot where its bodies are now.
template <Scalar Real>
Manifold<Real> World<Real>::moved_manifold(int number) const {
  const ContactSlot<Real>& slot = graph_[number];
  const Real margin =
      static_cast<Real>(scene_->settings().speculative_margin) + reach_[slot.a] + reach_[slot.b];
  Manifold<Real> manifold = graph_.lasting(number).manifold.at(frames_[slot.a], frames_[slot.b], margin);
  manifold.collider_a = slot.collider_a;
  manifold.collider_b = slot.collider_b;
  return manifold;
}

/// How far every body may come.
template <Scalar Real>
void World<Real>::measure_reach() {
  for (const BodyId body : reach_.indices()) reach_[body] = reach(body);
}

/// Whether two shapes that are near, so that one can move, ever touch.
template <Scalar Real>
bool World<Real>::may_meet(int collider_a, int collider_b) const {
  const BodyId a = (*colliders_)[collider_a].body, b = (*colliders_)[collider_b].body;
  const BodySpec &spec_a = scene_->bodies()[a].spec, &spec_b = scene_->bodies()[b].spec;
  if (a == b || !may_touch(spec_a, spec_b)) return false;
  const List<std::pair<BodyId, BodyId>>& apart = scene_->apart();
  return !std::binary_search(apart.begin(), apart.end(), std::pair<BodyId, BodyId>(std::minmax(a, b)));
}

/// The slot of two shapes that may meet.
template <Scalar Real>
ContactSlot<Real> World<Real>::make_slot(int collider_a, int collider_b) const {
  const Collider& a = (*colliders_)[collider_a];
  const Collider& b = (*colliders_)[collider_b];
  const BodySpec &spec_a = scene_->bodies()[a.body].spec, &spec_b = scene_->bodies()[b.body].spec;
  ContactSlot<Real> slot{.collider_a = collider_a, .collider_b = collider_b, .a = a.body, .b = b.body};
  slot.sensed = spec_a.sensor || spec_b.sensor;
  slot.friction = static_cast<Real>(traits(a.body).friction_root * traits(b.body).friction_root);
  slot.restitution = static_cast<Real>(std::max(spec_a.restitution, spec_b.restitution));
  slot.slop_limit = std::min(traits(a.body).slop_limit, traits(b.body).slop_limit);
  return slot;
}

template <Scalar Real>
Manifold<Real> World<Real>::collide_slot(const ContactSlot<Real>& slot, Real margin) const {
  const ColliderForm<Real>& a = *(*colliders_)[slot.collider_a].form;
  const ColliderForm<Real>& b = *(*colliders_)[slot.collider_b].form;
  Manifold<Real> manifold =
      collide(*a.shape, frames_[slot.a], *b.shape, frames_[slot.b], margin, {a.around.get(), b.around.get()});
  manifold.collider_a = slot.collider_a;
  manifold.collider_b = slot.collider_b;
  return manifold;
}

/// Of the smaller of the two bodies, beside the other.
template <Scalar Real>
Pose<Real> World<Real>::relative_pose(const ContactSlot<Real>& slot, bool a_moves) const {
  const BodyId still = a_moves ? slot.b : slot.a, moving = a_moves ? slot.a : slot.b;
  const Vec2<Real> arm = frames_[moving].position - frames_[still].position;
  return {frames_[still].rotation.transposed_times(arm),
          state_.pose[moving].angle - state_.pose[still].angle};
}

/// Whether the manifold of before does for this step, in which the bodies come no farther than `reach` [m].
template <Scalar Real>
bool World<Real>::has_lasting_manifold(int number, Real reach) const {
  const LastingManifold<Real>& found = graph_.lasting(number);
  if (!plan_->keeps_manifolds || !found.is_found) return false;
  const Real margin = static_cast<Real>(scene_->settings().speculative_margin);
  if (reach > margin / 2) return false;
  const ContactSlot<Real>& slot = graph_[number];
  const Pose<Real> now = relative_pose(slot, found.a_moves);
  const Real way = (now.position - found.position).norm();
  // What was beyond the margin has not come in by more than a quarter of it.
  const Real most = std::min(margin / 4, static_cast<Real>(keep_share) * slot.slop_limit);
  return way + found.radius * std::abs(now.angle - found.angle) <= most;
}

template <Scalar Real>
void World<Real>::find_lasting_manifold(int number, Real margin) {
  const ContactSlot<Real>& slot = graph_[number];
  const ColliderForm<Real>& a = *(*colliders_)[slot.collider_a].form;
  const ColliderForm<Real>& b = *(*colliders_)[slot.collider_b].form;
  LastingManifold<Real>& found = graph_.lasting(number);
  found.manifold =
      keep(collide_slot(slot, margin), frames_[slot.a], a.core_radius, frames_[slot.b], b.core_radius);
  found.a_moves = a.radius < b.radius;
  found.radius = std::min(a.radius, b.radius);
  const Pose<Real> now = relative_pose(slot, found.a_moves);
  found.position = now.position;
  found.angle = now.angle;
  found.is_found = true;
}

/// Takes a manifold into the step, if it has any point.
template <Scalar Real>
void World<Real>::touch(int number, const Manifold<Real>& manifold) {
  ContactSlot<Real>& slot = graph_[number];
  if (manifold.count == 0) {
    slot.impulses.count = 0;
    return;
  }
  make_room(record_.manifolds, record_.manifolds.size() + 1);
  record_.manifolds.push_back(manifold);
  touching_.push_back(number);
}

/// One pair that is near: its manifold, if the two touch.
template <Scalar Real>
void World<Real>::meet(NearSlot& near) {
  const auto [shape_a, shape_b] = near.shapes;
  if (sleep_ && !movable_[shape_a] && !movable_[shape_b]) return;  // as they fell asleep
  if (!boxes_[shape_a].overlaps(boxes_[shape_b])) return graph_.remove_slot(near);
  if (near.slot == NearSlot::none) graph_.add_slot(near, make_slot(shape_a, shape_b));
  const int number = near.slot;
  ContactSlot<Real>& slot = graph_[number];
  if (slot.sensed) {
    if (collide_slot(slot, 0).count > 0) record_.sensed.push_back(std::minmax(slot.a, slot.b));
    return;
  }
  const Real reach = reach_[slot.a] + reach_[slot.b];
  const Real margin = static_cast<Real>(scene_->settings().speculative_margin);
  if (!plan_->moves_manifolds) {
    touch(number, collide_slot(slot, margin + reach));
    return;
  }
  const LastingManifold<Real>& lasting = graph_.lasting(number);
  if (!has_lasting_manifold(number, reach)) {
    find_lasting_manifold(number, margin + reach);
    found_anew_ = found_anew_ || lasting.manifold.count > 0;
  }
  if (lasting.manifold.count > 0) {
    candidates_.push_back(number);
  } else {
    slot.impulses.count = 0;
  }
}

/// [m] How far a body can come within `time` [s].
template <Scalar Real>
Real World<Real>::way(BodyId body, Real time) const {
  return time * (state_.velocity[body].template head<2>().norm() + time * traits(body).gravity);
}

/// [m] How far a fast body can come within a substep; 0 for every other body, unless it comes farther than
/// its largest shape is long: then it could pass through another of its size.
template <Scalar Real>
Real World<Real>::reach(BodyId body) const {
  const Real far = way(body, substep_length());
  return far > traits(body).length ? far : Real(0);
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
