// Floor 5. Looking ahead: which shapes come together within a step, and what their contact is like then.
//
// What counts is how two bodies move against each other. Where a pair comes less far than its shapes are
// near, the manifold is that of now. Else it is that of the pose in which the two first touch, drawn back
// along their way: a row holds them off along the normal of the touch, and lets pass what would have missed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <cairn/world/contact_finder.hpp>

namespace cairn {

// Of the slop that two shapes may have: by how much a point may move before a manifold is found anew. Of
// bodies of 1 m that is 5 mm, as in Box2D.
constexpr double keep_share = 0.1;

namespace {

/// [m] Of two centres on their way for `time` [s].
template <Scalar Real>
Real least_distance(const Course<Real>& a, const Course<Real>& b, Real time) {
  const Vec2<Real> arm = b.pose.position - a.pose.position;
  const Vec2<Real> path = time * (b.velocity - a.velocity).template head<2>();
  const Real squared = path.squaredNorm();
  const Real share = squared > 0 ? std::clamp(-arm.dot(path) / squared, Real(0), Real(1)) : Real(0);
  return (arm + share * path).norm();
}

/// [m] How far a shape goes in a unit direction at most; negative where it goes back.
template <Scalar Real>
Real most_travel(const LookAhead<Real>& outlook, const Vec2<Real>& direction, const Collider<Real>& it) {
  Real most = -std::numeric_limits<Real>::infinity();
  outlook.for_each_velocity(it.body, [&](const Vec3<Real>& velocity) {
    const Real turning = std::abs(velocity.z()) * (it.form->radius - it.form->core_radius);
    most = std::max(most, direction.dot(velocity.template head<2>()) + turning);
  });
  return outlook.time() * most;
}

/// [m/s] What goes on along a contact with this normal may be turned aside by others: by so much.
template <Scalar Real>
Real leeway_along(const Vec2<Real>& normal, const CachedContact<Real>& cached,
                  const LookAhead<Real>& outlook) {
  const Vec3<Real> past = outlook.stopped(cached.b) - outlook.stopped(cached.a);
  return std::abs(cross<Real>(normal, past.template head<2>()));
}

}  // namespace

/// With which velocities bodies would go on for `time` [s], should nothing be in their way: mean ones, as
/// gravity adds its share in each substep.
template <Scalar Real>
void ContactFinder<Real>::look_ahead(Real time) {
  cache_.going_ = step_.state.velocity;
  step_.add_forces(cache_.going_, (time + step_.dt) / 2);
  cache_.outlook_.begin(time, cache_.going_);
  cache_.rounds_.begin();
}

/// [m] How far two shapes may come beside each other.
template <Scalar Real>
Real ContactFinder<Real>::travel(const CachedContact<Real>& cached) const {
  return cache_.outlook_.travel((*cache_.colliders_)[cached.collider_a],
                                (*cache_.colliders_)[cached.collider_b], step_.state.pose,
                                slow_travel(cached));
}

/// [m] What a manifold may be off by.
template <Scalar Real>
Real ContactFinder<Real>::nearness(const CachedContact<Real>& cached) const {
  return static_cast<Real>(keep_share) * cached.slop_limit;
}

/// [m] Of a pair that comes no farther, all it can touch is near now.
template <Scalar Real>
Real ContactFinder<Real>::slow_travel(const CachedContact<Real>& cached) const {
  return std::min(static_cast<Real>(*step_.plan.settings.speculative_margin) / 2, cached.slop_limit);
}

template <Scalar Real>
bool ContactFinder<Real>::is_slow(const CachedContact<Real>& cached, Real travel) const {
  return travel <= slow_travel(cached);
}

/// [m] Below it points have rows. One end of a body that comes down is thrown down by what stops the other.
template <Scalar Real>
Real ContactFinder<Real>::margin_for(const CachedContact<Real>& cached, Real travel) const {
  const Real margin = static_cast<Real>(*step_.plan.settings.speculative_margin);
  return is_slow(cached, travel) ? margin : margin + 2 * travel;
}

/// Whether a pair has not been seen in this search, or one of its bodies has been stopped since.
template <Scalar Real>
bool ContactFinder<Real>::is_news(const CachedContact<Real>& cached, int number) {
  Sight<Real>& sight = cache_.rounds_.of(cached, number);
  const int since = std::exchange(sight.changes, cache_.outlook_.changes());
  return since < 0 || cache_.outlook_.has_changed(cached.a, since) ||
         cache_.outlook_.has_changed(cached.b, since);
}

/// Takes into the step what a pair will touch with.
template <Scalar Real>
void ContactFinder<Real>::touch_ahead(int number) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  if (is_news(cached, number)) {
    const Real distance = travel(cached);
    cache_.rounds_.of(cached, number).is_slow = is_slow(cached, distance);
    touch(number, manifold_ahead(number, distance));
  }
  stop(number);
}

/// [m] By how much others may turn the two aside.
template <Scalar Real>
Real ContactFinder<Real>::leeway_of(const CachedContact<Real>& cached) const {
  return cache_.outlook_.time() * (cache_.outlook_.leeway(cached.a) + cache_.outlook_.leeway(cached.b));
}

/// Whether two shapes surely stay farther from each other along a direction than anything that they may do
/// needs.
template <Scalar Real>
bool ContactFinder<Real>::stay_apart(const CachedContact<Real>& cached, const Vec2<Real>& direction) const {
  const Collider &a = (*cache_.colliders_)[cached.collider_a], &b = (*cache_.colliders_)[cached.collider_b];
  const Frame<Real>&frame_a = cache_.frames_[cached.a], &frame_b = cache_.frames_[cached.b];
  const Real room = std::max(static_cast<Real>(*step_.plan.settings.speculative_margin), nearness(cached));
  const Real far = (frame_b.position - frame_a.position).cwiseAbs().sum() + a.form->radius + b.form->radius;
  const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * far;
  const Real closing =
      most_travel(cache_.outlook_, direction, a) + most_travel<Real>(cache_.outlook_, -direction, b);
  return gap_along(direction, *a.form->shape, frame_a, *b.form->shape, frame_b) >
         room + leeway_of(cached) + rounding + std::max(closing, Real(0));
}

/// What a pair that travels so far [m] will touch with.
template <Scalar Real>
Manifold<Real> ContactFinder<Real>::manifold_ahead(int number, Real distance) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  Vec2<Real>& apart = cache_.rounds_.of(cached, number).apart;
  const Real margin = margin_for(cached, distance);
  if (is_slow(cached, distance))
    return collide_pair(cached, cache_.frames_[cached.a], cache_.frames_[cached.b], margin);
  if (stay_apart(cached, apart)) return {};
  const Collider &a = (*cache_.colliders_)[cached.collider_a], &b = (*cache_.colliders_)[cached.collider_b];
  const Real room = static_cast<Real>(*step_.plan.settings.speculative_margin);
  Manifold<Real> manifold;
  cache_.outlook_.for_each_course(a, b, places(), [&](const Course<Real>& of_a, const Course<Real>& of_b) {
    if (manifold.count == 0) manifold = manifold_of_touch(cached, of_a, of_b, room, margin, apart);
  });
  const Real leeway = leeway_of(cached);
  if (manifold.count == 0 && leeway > 0) {
    std::pair<Course<Real>, Course<Real>> last;
    cache_.outlook_.for_each_course(a, b, places(),
                                    [&last](const Course<Real>& of_a, const Course<Real>& of_b) {
                                      last = {of_a, of_b};
                                    });
    manifold = manifold_of_touch(cached, last.first, last.second, room + leeway, margin, apart);
  }
  return manifold;
}

/// That of the pose in which two shapes touch on their way, with the arms that what can be moved will have
/// then, and with the separations from which its rows see the two come to that pose. Of two that do not touch
/// that of a pose in which they begin to part, if they are nearer than `room` [m] there.
template <Scalar Real>
Manifold<Real> ContactFinder<Real>::manifold_of_touch(const CachedContact<Real>& cached,
                                                      const Course<Real>& a, const Course<Real>& b, Real room,
                                                      Real margin, Vec2<Real>& apart) const {
  const ColliderForm<Real>& form_a = *(*cache_.colliders_)[cached.collider_a].form;
  const ColliderForm<Real>& form_b = *(*cache_.colliders_)[cached.collider_b].form;
  const Real near = nearness(cached), most = form_a.radius + form_b.radius + std::max(room, near);
  if (least_distance(a, b, cache_.outlook_.time()) > most) return {};
  const Approach<Real> met =
      approach(*form_a.shape, a, *form_b.shape, b, cache_.outlook_.time(), near, std::max(room, near));
  apart = met.normal;
  if (met.separation > near && met.separation >= room) return {};
  const Frame<Real> then_a = a.at(met.time), then_b = b.at(met.time);
  Manifold<Real> manifold = collide_pair(cached, then_a, then_b, margin);
  const Real light_a = step_.state.inverse_mass[cached.a].x(),
             light_b = step_.state.inverse_mass[cached.b].x();
  const Vec2<Real> speed_a = a.velocity.template head<2>(), speed_b = b.velocity.template head<2>();
  const Real share_b = light_b / (light_a + light_b);
  for (int i = 0; i < manifold.count; ++i) {
    ManifoldPoint<Real>& point = manifold.points[i];
    point.position -= met.time * (speed_a + share_b * (speed_b - speed_a));
    const Vec2<Real> parting = speed_b + cross<Real>(b.velocity.z(), point.position - b.pose.position) -
                               speed_a - cross<Real>(a.velocity.z(), point.position - a.pose.position);
    point.separation -= met.time * manifold.normal.dot(parting);
  }
  return manifold;
}

/// What a contact does to the two bodies, should they come so far into each other that others may be met.
/// Each is stopped once in a step: from then on it is in the way of others as if nothing moved it. So two
/// that can both be moved wait until others have stopped whom they can, whatever the order of pairs.
template <Scalar Real>
void ContactFinder<Real>::stop(int number) {
  const CachedContact<Real>& cached = cache_.graph_[number];
  Sight<Real>& sight = cache_.rounds_.of(cached, number);
  sight.waits = false;
  if (sight.is_slow || sight.contact < 0) return;
  const Manifold<Real>& manifold = record_.problem.contacts[sight.contact].manifold;
  const Vec3<Real> still = Vec3<Real>::Zero();
  const Vec3<Real> light_a =
      cache_.outlook_.is_stopped(cached.a) ? still : step_.state.inverse_mass[cached.a];
  const Vec3<Real> light_b =
      cache_.outlook_.is_stopped(cached.b) ? still : step_.state.inverse_mass[cached.b];
  if (light_a.isZero(0) && light_b.isZero(0)) return;
  const bool waits = stops_.of_movable_wait && !light_a.isZero(0) && !light_b.isZero(0);
  bool is_new = false;
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    const Vec2<Real>& normal = manifold.normal;
    const Real turn_a = cross<Real>(point.position - step_.state.pose[cached.a].position, normal);
    const Real turn_b = cross<Real>(point.position - step_.state.pose[cached.b].position, normal);
    const Vec3<Real> push_a(-normal.x(), -normal.y(), -turn_a), push_b(normal.x(), normal.y(), turn_b);
    const Real parting =
        dot(push_a, cache_.outlook_.stopped(cached.a)) + dot(push_b, cache_.outlook_.stopped(cached.b));
    const Real missing = -point.separation / cache_.outlook_.time() - parting;
    if (is_slow(cached, cache_.outlook_.time() * missing)) continue;
    sight.waits = waits;
    stops_.are_waiting |= waits;
    if (waits) return;
    const Vec3<Real> pull_a = light_a.cwiseProduct(push_a), pull_b = light_b.cwiseProduct(push_b);
    const Real rebound = cached.restitution > 0 ? -(1 + cached.restitution) * parting : Real(0);
    const Real impulse = std::max(missing, rebound) / (dot(push_a, pull_a) + dot(push_b, pull_b));
    if (!light_a.isZero(0)) cache_.outlook_.stop(cached.a, impulse * pull_a);
    if (!light_b.isZero(0)) cache_.outlook_.stop(cached.b, impulse * pull_b);
    is_new = true;
  }
  if (!is_new) return;
  stops_.are_new = true;
  const Real leeway = leeway_along(manifold.normal, cached, cache_.outlook_);
  if (!light_a.isZero(0)) cache_.outlook_.set_leeway(cached.a, leeway);
  if (!light_b.isZero(0)) cache_.outlook_.set_leeway(cached.b, leeway);
}

template class ContactFinder<float>;
template class ContactFinder<double>;

}  // namespace cairn
