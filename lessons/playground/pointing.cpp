// Distances from a point to shapes.
#include "lessons/playground/pointing.hpp"

#include <algorithm>
#include <limits>

#include <cairn/math/list.hpp>

namespace cairn::playground {

namespace {

double distance_to_line(const Vec2<double>& point, const Vec2<double>& from, const Vec2<double>& to) {
  const Vec2<double> way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp(way.dot(point - from) / length, 0.0, 1.0) : 0;
  return (point - from - share * way).norm();
}

/// From a point to a shape, below 0 within it [m].
struct DistanceTo {
  Vec2<double> point = {0, 0};

  double operator()(const Circle<double>& circle) const {
    return (point - circle.center).norm() - circle.radius;
  }
  double operator()(const Capsule<double>& capsule) const {
    return distance_to_line(point, capsule.point1, capsule.point2) - capsule.radius;
  }
  double operator()(const Polygon<double>& polygon) const {
    double within = -std::numeric_limits<double>::infinity(), outside = -within;
    for (int i = 0; i < polygon.vertices.size(); ++i) {
      const Vec2<double>& next = polygon.vertices[(i + 1) % polygon.vertices.size()];
      within = std::max(within, polygon.normals[i].dot(point - polygon.vertices[i]));
      outside = std::min(outside, distance_to_line(point, polygon.vertices[i], next));
    }
    return (within <= 0 ? within : outside) - polygon.radius;
  }
  double operator()(const Segment<double>& segment) const {
    return distance_to_line(point, segment.point1, segment.point2);
  }
  double operator()(const Chain<double>& chain) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < chain.link_count(); ++i)
      least = std::min(least, distance_to_line(point, chain.point(i), chain.point(i + 1)));
    return least;
  }
};

/// The nearest of those that are wanted.
template <typename Wanted>
std::optional<BodyId> nearest_body(const Snapshot& snapshot, const Vec2<double>& point, double near,
                                   const Wanted& wanted) {
  std::optional<BodyId> found;
  double least = near;
  for (const BodyId id : snapshot.bodies.indices()) {
    const SnapshotBody& body = snapshot.bodies[id];
    if (id == ground || body.removed || !wanted(body)) continue;
    for (const Shape<double>& shape : body.shapes) {
      const double distance = std::max(0.0, std::visit(DistanceTo{body.pose.local(point)}, shape));
      if (distance > least || (found && distance == least)) continue;
      found = id;
      least = distance;
    }
  }
  return found;
}

}  // namespace

std::optional<BodyId> movable_body_at(const Snapshot& snapshot, const Vec2<double>& point, double near) {
  return nearest_body(snapshot, point, near,
                      [](const SnapshotBody& body) { return body.type == BodyType::dynamic; });
}

std::optional<BodyId> body_at(const Snapshot& snapshot, const Vec2<double>& point, double near) {
  const std::optional<BodyId> movable = movable_body_at(snapshot, point, near);
  return movable ? movable : nearest_body(snapshot, point, near, [](const SnapshotBody&) { return true; });
}

}  // namespace cairn::playground
