// Floor 9. Ways that bodies go without getting anywhere.
#include <cairn/study/shaking.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/geometry/aabb.hpp>

namespace cairn {

namespace {

constexpr double rest_share = 0.02;  // of the bounding radius

double rim_way(const Pose<double>& from, const Pose<double>& to, double radius) {
  return (to.position - from.position).norm() + radius * std::abs(to.angle - from.angle);
}

}  // namespace

double thickness_of(const SnapshotBody& body) {
  double side = std::numeric_limits<double>::infinity();
  for (const Shape<double>& shape : body.shapes) {
    const Aabb<double> box = bounding_box(shape, Pose<double>{});
    side = std::min(side, (box.upper - box.lower).minCoeff());
  }
  return side > 0 ? side : std::numeric_limits<double>::infinity();
}

double thinnest_body(const Snapshot& snapshot) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const SnapshotBody& body : snapshot.bodies) {
    if (body.type == BodyType::dynamic && !body.removed) thinnest = std::min(thinnest, thickness_of(body));
  }
  return thinnest;
}

void Shaking::see(const Snapshot& now, double time) {
  if (time < begin_) return;
  if (ways_.empty()) {
    first_ = time;
    for (const SnapshotBody& body : now.bodies) {
      ways_.push_back({.first = body.pose, .last = body.pose});
      for (const Shape<double>& shape : body.shapes)
        ways_.back().radius = std::max(ways_.back().radius, bounding_radius(shape));
    }
  }
  last_ = time;
  for (const BodyId body : now.bodies.indices()) {
    Way& way = ways_[body];
    if (now.bodies[body].type != BodyType::dynamic || now.bodies[body].removed) continue;
    way.length += rim_way(way.last, now.bodies[body].pose, way.radius);
    way.last = now.bodies[body].pose;
    way.farthest = std::max(way.farthest, rim_way(way.first, way.last, way.radius));
  }
}

double Shaking::speed() const {
  if (!(last_ > first_)) return 0;
  double longest = 0;
  for (const Way& way : ways_) {
    const double got_on = rim_way(way.first, way.last, way.radius);
    if (way.farthest <= rest_share * way.radius) longest = std::max(longest, way.length - got_on);
  }
  return longest / (last_ - first_);
}

}  // namespace cairn
