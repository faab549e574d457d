// Floor 9. Places, and ways from them.
#include <cairn/study/standing.hpp>

#include <algorithm>

#include <cairn/geometry/aabb.hpp>
#include <cairn/study/limit.hpp>

namespace cairn {

namespace {

double wide_distance(const SnapshotBody& body, double distance) {
  double radius = 0;  // [m] about the centre of mass
  for (const Shape<double>& shape : body.shapes) radius = std::max(radius, bounding_radius(shape));
  return std::max(distance, radius / 2);
}

}  // namespace

Standing::Standing(const Snapshot& start, double distance, double settle_seconds)
    : distance_(distance), settle_seconds_(settle_seconds), settled_(settle_seconds <= 0) {
  for (const SnapshotBody& body : start.bodies) {
    places_.push_back(body.pose.position);
    wide_distances_.push_back(wide_distance(body, distance));
  }
}

double Standing::share(const SnapshotBody& body, const Vec2<double>& gravity, BodyId id) const {
  const Vec2<double> way = body.pose.position - places_[id];
  const double length = way.norm();
  if (!settled_) return share_of(length, wide_distances_[id]);
  const Vec2<double> force = body.gravity_scale * gravity;
  const bool is_lifted = way.dot(force) < 0;
  if (!is_lifted) return share_of(length, distance_);
  const Vec2<double> up = -force.normalized();
  const Vec2<double> aside = way - way.dot(up) * up;
  return std::max(share_of(aside.norm(), distance_), share_of(length, wide_distances_[id]));
}

double Standing::share(const Snapshot& now, double time) {
  double most = 0;
  for (const BodyId body : now.bodies.indices()) {
    if (now.bodies[body].type != BodyType::dynamic) continue;
    most = std::max(most, share(now.bodies[body], now.gravity, body));
  }
  const double rounding = 1e-9 * settle_seconds_;  // of sums of time steps
  if (!settled_ && time >= settle_seconds_ - rounding) {
    settled_ = true;
    for (const BodyId body : now.bodies.indices()) places_[body] = now.bodies[body].pose.position;
  }
  return most;
}

}  // namespace cairn
