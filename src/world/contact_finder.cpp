// Floor 5. What touches what: from poses to contacts.
#include <algorithm>
#include <cmath>

#include <cairn/collision/collide.hpp>
#include <cairn/world/contact_finder.hpp>
#include <cairn/math/deadline.hpp>
#include <cairn/math/list.hpp>

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
void ContactFinder<Real>::find() {
  const Real time = step_.plan.moves_manifolds ? step_.step_dt : step_.dt;
  cache_.boxes_.follow_crowd(*cache_.colliders_, step_.state.velocity, time);
  find_manifolds();
  if (!step_.sleep) return;
  // What wakes may touch, or hold, what else sleeps.
  while (step_.sleep->wake_touched(record_.problem.contacts, step_.state.velocity)) find_manifolds();
}

/// Where every body is.
template <Scalar Real>
void ContactFinder<Real>::locate_bodies() {
  for (const BodyId body : step_.state.pose.indices()) cache_.frames_[body] = step_.state.pose[body];
}

template <Scalar Real>
void ContactFinder<Real>::find_manifolds() {
  cache_.candidates_.clear();
  record_.sensed.clear();
  if (!step_.plan.collision) return;
  cache_.graph_.sort_contacts();
  locate_bodies();
  look_ahead(step_.plan.moves_manifolds ? step_.step_dt : step_.dt);
  if (step_.sleep) step_.sleep->mark_movable(step_.state.velocity, cache_.movable_);
  find_with_others([this](int since) { meet_all(since); });
  std::sort(record_.sensed.begin(), record_.sensed.end());
  record_.sensed.erase(std::unique(record_.sensed.begin(), record_.sensed.end()), record_.sensed.end());
  if (!step_.plan.moves_manifolds) return;
  choose_candidates();
  look_ahead(step_.dt);
  put_manifolds();
}

/// What is stopped, or set moving, may be in the way of others or meet them: they are looked for again.
/// Calls find(since) for each round: it looks again at what has changed since so many changes, and at what
/// waits.
template <Scalar Real>
template <typename Find>
void ContactFinder<Real>::find_with_others(const Find& find) {
  record_.problem.contacts.clear();
  cache_.touching_.clear();
  int since = -1;
  int round = 0;
  do {
    stops_.of_movable_wait = round == 0 || stops_.are_new;
    stops_.are_new = stops_.are_waiting = false;
    const int changes = cache_.outlook_.changes();
    find(since);
    since = changes;
  } while (++round < most_rounds && (stops_.are_new || stops_.are_waiting));
  if (round > 1) sort_contacts();
}

/// All pairs that are near, or come near.
template <Scalar Real>
void ContactFinder<Real>::meet_all(int since) {
  cache_.boxes_.find(*cache_.colliders_, cache_.frames_,
                     static_cast<Real>(*step_.plan.settings.speculative_margin) / 2, cache_.outlook_, since);
  cache_.graph_.update(cache_.boxes_.boxes(),
                       [this](int i, int j) { return cache_.may_meet(step_.scene, i, j); });
  if (step_.plan.extras.one_way && since < 0) find_sides();
  for (NearPair& near : cache_.graph_.order()) {
    Deadline::go_on();
    const BodyId a = (*cache_.colliders_)[near.shapes.first].body;
    const BodyId b = (*cache_.colliders_)[near.shapes.second].body;
    if (looks_again(a, b, near.contact, since)) meet(near);
  }
}

/// Whether one of two bodies goes on in another way, or their pair waits.
template <Scalar Real>
bool ContactFinder<Real>::looks_again(BodyId a, BodyId b, int number, int since) const {
  if (cache_.outlook_.has_changed(a, since) || cache_.outlook_.has_changed(b, since)) return true;
  const Sight<Real>* const sight = cache_.rounds_.seen(number);
  return sight != nullptr && sight->waits;
}

/// Those of which a manifold moves with the bodies.
template <Scalar Real>
void ContactFinder<Real>::choose_candidates() {
  for (const NearPair& near : cache_.graph_.order()) {
    if (cache_.rounds_.seen(near.contact) == nullptr) continue;
    const CachedManifold<Real>& cached = cache_.graph_.manifold(near.contact);
    if (!cached.is_found || cached.manifold.count > 0) {
      cache_.candidates_.push_back(near.contact);
    } else {
      cache_.graph_[near.contact].impulses.count = 0;
    }
  }
}

/// The manifolds that were found, where the bodies are now.
template <Scalar Real>
void ContactFinder<Real>::move() {
  if (!cache_.candidates_.empty()) {
    locate_bodies();
    look_ahead(step_.dt);
  }
  put_manifolds();
}

/// The same once it is known where the bodies are.
template <Scalar Real>
void ContactFinder<Real>::put_manifolds() {
  find_with_others([this](int since) {
    for (const int number : cache_.candidates_) {
      const CachedContact<Real>& cached = cache_.graph_[number];
      if (!looks_again(cached.a, cached.b, number, since)) continue;
      if (cache_.graph_.manifold(number).is_found) {
        touch(number, moved_manifold(number));
      } else {
        touch_ahead(number);
      }
    }
  });
}

/// Rounds have put some behind others.
template <Scalar Real>
void ContactFinder<Real>::sort_contacts() {
  List<Contact<Real>>&contacts = record_.problem.contacts, &sorted = cache_.sorted_;
  sorted.clear();
  make_room(sorted, contacts.size());
  cache_.touching_.clear();
  for (const NearPair& near : cache_.graph_.order()) {
    const Sight<Real>* const sight = cache_.rounds_.seen(near.contact);
    if (sight == nullptr || sight->contact < 0) continue;
    sorted.push_back(contacts[sight->contact]);
    cache_.touching_.push_back(near.contact);
  }
  contacts.swap(sorted);
}

/// The manifold of a contact where its bodies are now.
template <Scalar Real>
Manifold<Real> ContactFinder<Real>::moved_manifold(int number) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  Manifold<Real> manifold = cache_.graph_.manifold(number).manifold.at(
      cache_.frames_[cached.a], cache_.frames_[cached.b], margin_for(cached, travel(cached)));
  manifold.collider_a = cached.collider_a;
  manifold.collider_b = cached.collider_b;
  return manifold;
}

template <Scalar Real>
Manifold<Real> ContactFinder<Real>::collide_pair(const CachedContact<Real>& cached,
                                                 const Frame<Real>& frame_a, const Frame<Real>& frame_b,
                                                 Real margin) const {
  const ColliderForm<Real>& a = *(*cache_.colliders_)[cached.collider_a].form;
  const ColliderForm<Real>& b = *(*cache_.colliders_)[cached.collider_b].form;
  Manifold<Real> manifold =
      collide(*a.shape, frame_a, *b.shape, frame_b, margin, {a.around.get(), b.around.get()});
  manifold.collider_a = cached.collider_a;
  manifold.collider_b = cached.collider_b;
  return manifold;
}

/// Of the smaller of the two bodies, beside the other.
template <Scalar Real>
Pose<Real> ContactFinder<Real>::relative_pose(const CachedContact<Real>& cached, bool a_moves) const {
  const BodyId still = a_moves ? cached.b : cached.a, moving = a_moves ? cached.a : cached.b;
  const Vec2<Real> arm = cache_.frames_[moving].position - cache_.frames_[still].position;
  return {cache_.frames_[still].rotation.transposed_times(arm),
          step_.state.pose[moving].angle - step_.state.pose[still].angle};
}

/// Whether the manifold of before does for this step.
template <Scalar Real>
bool ContactFinder<Real>::has_cached_manifold(int number) const {
  const CachedManifold<Real>& found = cache_.graph_.manifold(number);
  if (!step_.plan.keeps_manifolds || !found.is_found) return false;
  const Real margin = static_cast<Real>(*step_.plan.settings.speculative_margin);
  const CachedContact<Real>& cached = cache_.graph_[number];
  const Pose<Real> now = relative_pose(cached, found.a_moves);
  const Real distance = (now.position - found.position).norm();
  // What was beyond the margin has not come in by more than a quarter of it.
  const Real most = std::min(margin / 4, nearness(cached));
  if (!(distance + found.radius * std::abs(now.angle - found.angle) <= most)) return false;
  return is_slow(cached, travel(cached)) ||
         is_touching(found.manifold.at(cache_.frames_[cached.a], cache_.frames_[cached.b], margin),
                     nearness(cached));
}

/// Of a pair that goes far in this step, only if it touches now: else none is found, and each substep looks
/// ahead.
template <Scalar Real>
void ContactFinder<Real>::find_cached_manifold(int number) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  const ColliderForm<Real>& a = *(*cache_.colliders_)[cached.collider_a].form;
  const ColliderForm<Real>& b = *(*cache_.colliders_)[cached.collider_b].form;
  CachedManifold<Real>& found = cache_.graph_.manifold(number);
  const Real distance = travel(cached);
  const Manifold<Real> manifold =
      collide_pair(cached, cache_.frames_[cached.a], cache_.frames_[cached.b], margin_for(cached, distance));
  found = {.a_moves = a.radius < b.radius,
           .is_found = is_slow(cached, distance) || is_touching(manifold, nearness(cached))};
  if (!found.is_found) return;
  found.manifold =
      keep(manifold, cache_.frames_[cached.a], a.core_radius, cache_.frames_[cached.b], b.core_radius);
  found.radius = std::min(a.radius, b.radius);
  const Pose<Real> now = relative_pose(cached, found.a_moves);
  found.position = now.position;
  found.angle = now.angle;
}

/// Takes a manifold into the step, if it has any point.
template <Scalar Real>
void ContactFinder<Real>::touch(int number, const Manifold<Real>& manifold) {
  if (manifold.count == 0) cache_.graph_[number].impulses.count = 0;
  keep_sight(number, manifold);
}

/// Puts what is seen of a contact in the place of what was seen before.
template <Scalar Real>
void ContactFinder<Real>::keep_sight(int number, const Manifold<Real>& manifold) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  Sight<Real>& sight = cache_.rounds_.of(cached, number);
  List<Contact<Real>>& contacts = record_.problem.contacts;
  if (manifold.count == 0) {
    sight.contact = -1;
  } else if (sight.contact >= 0) {
    contacts[sight.contact].manifold = manifold;
  } else {
    sight.contact = contacts.size();
    make_room(contacts, contacts.size() + 1);
    contacts.push_back({.a = cached.a,
                        .b = cached.b,
                        .manifold = manifold,
                        .center_a = step_.state.pose[cached.a].position,
                        .center_b = step_.state.pose[cached.b].position,
                        .friction = cached.friction,
                        .restitution = cached.restitution,
                        .slop_limit = cached.slop_limit});
    cache_.touching_.push_back(number);
  }
}

/// One pair that is near: its manifold, if the two touch.
template <Scalar Real>
void ContactFinder<Real>::meet(NearPair& near) {
  const auto [shape_a, shape_b] = near.shapes;
  if (step_.sleep && !cache_.movable_[shape_a] && !cache_.movable_[shape_b]) return;  // as they fell asleep
  if (!cache_.boxes_.meet(shape_a, shape_b) || (step_.plan.extras.one_way && pass(shape_a, shape_b)))
    return cache_.graph_.remove_contact(near);
  if (near.contact == NearPair::none)
    cache_.graph_.add_contact(near, cache_.make_contact(step_, shape_a, shape_b));
  const CachedContact<Real>& cached = cache_.graph_[near.contact];
  if (cached.sensed) {
    const bool touches =
        collide_pair(cached, cache_.frames_[cached.a], cache_.frames_[cached.b], 0).count > 0;
    if (touches) record_.sensed.push_back(std::minmax(cached.a, cached.b));
  } else if (step_.plan.moves_manifolds) {
    meet_for_step(near.contact);
  } else {
    touch_ahead(near.contact);
  }
}

/// A manifold that moves with the bodies, or what stops them.
template <Scalar Real>
void ContactFinder<Real>::meet_for_step(int number) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  if (is_news(cached, number)) {
    if (!has_cached_manifold(number)) find_cached_manifold(number);
    if (!cache_.graph_.manifold(number).is_found) keep_sight(number, manifold_ahead(number, travel(cached)));
  }
  if (!cache_.graph_.manifold(number).is_found) stop(number);
}

template class ContactFinder<float>;
template class ContactFinder<double>;

}  // namespace cairn
