// Floor 5. What touches what: from poses to manifolds.
#include <algorithm>
#include <cmath>

#include "collision/collide.hpp"
#include "world/world.hpp"
#include "math/deadline.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

// In which hits that follow from one another within a step are looked for. Each comes after the way to it, so
// few of them fit into a step; where sweeps leave a heap far from solved, there is no end of them.
constexpr int most_rounds = 6;

/// Whether a point of it is no farther than `near` [m].
template <Scalar Real>
bool is_touching(const Manifold<Real>& manifold, Real near) {
  return std::any_of(manifold.points.begin(), manifold.points.begin() + manifold.count,
                     [near](const ManifoldPoint<Real>& point) { return point.separation <= near; });
}

}  // namespace

template <Scalar Real>
void World<Real>::find_contacts(ContactSolver<Real>* solver) {
  const Real time = plan_->moves_manifolds ? static_cast<Real>(dt_) : substep_length();
  outlook_.follow_crowd(*colliders_, state_.velocity, time);
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
  candidates_.swap(candidates_before_);
  candidates_.clear();
  record_.sensed.clear();
  follows_ = found_anew_ = false;
  if (!plan_->collision) return;
  locate_bodies();
  look_ahead(plan_->moves_manifolds ? static_cast<Real>(dt_) : substep_length());
  if (sleep_) sleep_->mark_movable(state_.velocity, movable_);
  find_with_others([this] { meet_all(); });
  std::sort(record_.sensed.begin(), record_.sensed.end());
  record_.sensed.erase(std::unique(record_.sensed.begin(), record_.sensed.end()), record_.sensed.end());
  if (!plan_->moves_manifolds || follow_last_step(solver)) return;
  look_ahead(substep_length());
  put_manifolds();
}

/// What is stopped, or set moving, may be in the way of others or meet them: they are looked for again.
template <Scalar Real>
template <typename Find>
void World<Real>::find_with_others(const Find& find) {
  stops_ = {};
  for (int round = 0; round < most_rounds; ++round) {
    stops_.are_new = stops_.are_waiting = false;
    find();
    if (!stops_.are_new && !stops_.are_waiting) return;
    stops_.of_movable_wait = stops_.are_new;
  }
}

/// All pairs that are near, or come near.
template <Scalar Real>
void World<Real>::meet_all() {
  outlook_.find_boxes(*colliders_, frames_, static_cast<Real>(*plan_->settings.speculative_margin) / 2);
  found_anew_ =
      graph_.update(outlook_.swept_boxes(), [this](int i, int j) { return may_meet(i, j); }) || found_anew_;
  record_.sensed.clear();
  candidates_.clear();
  if (!plan_->moves_manifolds) {
    record_.manifolds.clear();
    touching_.clear();
  }
  for (NearSlot& near : graph_.order()) {
    Deadline::go_on();
    meet(near);
  }
}

/// The manifolds that were found, where the bodies are now.
template <Scalar Real>
void World<Real>::move_manifolds() {
  if (!candidates_.empty()) {
    locate_bodies();
    look_ahead(substep_length());
  }
  put_manifolds();
}

/// The same once it is known where the bodies are.
template <Scalar Real>
void World<Real>::put_manifolds() {
  find_with_others([this] {
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
  });
}

/// The manifold of a slot where its bodies are now.
template <Scalar Real>
Manifold<Real> World<Real>::moved_manifold(int number) {
  const ContactSlot<Real>& slot = graph_[number];
  const LastingManifold<Real>& lasting = graph_.lasting(number);
  if (!lasting.is_found) return manifold_ahead(slot);
  Manifold<Real> manifold =
      lasting.manifold.at(frames_[slot.a], frames_[slot.b], margin_for(slot, travel(slot)));
  manifold.collider_a = slot.collider_a;
  manifold.collider_b = slot.collider_b;
  return manifold;
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
Manifold<Real> World<Real>::collide_slot(const ContactSlot<Real>& slot, const Frame<Real>& frame_a,
                                         const Frame<Real>& frame_b, Real margin) const {
  const ColliderForm<Real>& a = *(*colliders_)[slot.collider_a].form;
  const ColliderForm<Real>& b = *(*colliders_)[slot.collider_b].form;
  Manifold<Real> manifold =
      collide(*a.shape, frame_a, *b.shape, frame_b, margin, {a.around.get(), b.around.get()});
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

/// Whether the manifold of before does for this step.
template <Scalar Real>
bool World<Real>::has_lasting_manifold(int number) const {
  const LastingManifold<Real>& found = graph_.lasting(number);
  if (!plan_->keeps_manifolds || !found.is_found) return false;
  const Real margin = static_cast<Real>(*plan_->settings.speculative_margin);
  const ContactSlot<Real>& slot = graph_[number];
  const Pose<Real> now = relative_pose(slot, found.a_moves);
  const Real way = (now.position - found.position).norm();
  // What was beyond the margin has not come in by more than a quarter of it.
  const Real most = std::min(margin / 4, nearness(slot));
  if (!(way + found.radius * std::abs(now.angle - found.angle) <= most)) return false;
  return is_slow(slot, travel(slot)) ||
         is_touching(found.manifold.at(frames_[slot.a], frames_[slot.b], margin), nearness(slot));
}

/// Of a pair that goes far in this step, only if it touches now: else none is found, and each substep looks
/// ahead.
template <Scalar Real>
void World<Real>::find_lasting_manifold(int number) {
  const ContactSlot<Real>& slot = graph_[number];
  const ColliderForm<Real>& a = *(*colliders_)[slot.collider_a].form;
  const ColliderForm<Real>& b = *(*colliders_)[slot.collider_b].form;
  LastingManifold<Real>& found = graph_.lasting(number);
  const Real way = travel(slot);
  const Manifold<Real> manifold = collide_slot(slot, frames_[slot.a], frames_[slot.b], margin_for(slot, way));
  found = {.a_moves = a.radius < b.radius,
           .is_found = is_slow(slot, way) || is_touching(manifold, nearness(slot))};
  if (!found.is_found) return;
  found.manifold = keep(manifold, frames_[slot.a], a.core_radius, frames_[slot.b], b.core_radius);
  found.radius = std::min(a.radius, b.radius);
  const Pose<Real> now = relative_pose(slot, found.a_moves);
  found.position = now.position;
  found.angle = now.angle;
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
  if (!outlook_.meet(shape_a, shape_b)) return graph_.remove_slot(near);
  if (near.slot == NearSlot::none) graph_.add_slot(near, make_slot(shape_a, shape_b));
  const int number = near.slot;
  ContactSlot<Real>& slot = graph_[number];
  if (slot.sensed) {
    const bool touches = collide_slot(slot, frames_[slot.a], frames_[slot.b], 0).count > 0;
    if (touches) record_.sensed.push_back(std::minmax(slot.a, slot.b));
    return;
  }
  if (!plan_->moves_manifolds) {
    touch(number, manifold_ahead(slot));
    return;
  }
  const LastingManifold<Real>& lasting = graph_.lasting(number);
  if (!has_lasting_manifold(number)) {
    find_lasting_manifold(number);
    found_anew_ = found_anew_ || !lasting.is_found || lasting.manifold.count > 0;
  }
  if (!lasting.is_found) manifold_ahead(slot);  // which tells of whom it stops
  if (!lasting.is_found || lasting.manifold.count > 0) {
    candidates_.push_back(number);
  } else {
    slot.impulses.count = 0;
  }
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
