// Floor 1. Axis-aligned bounding boxes.
#pragma once

#include <type_traits>

#include <cairn/geometry/shape.hpp>

namespace cairn {

/// A box whose sides are along x and y.
template <Scalar Real>
struct Aabb {
  Vec2<Real> lower = Vec2<Real>::Zero();  // [m]
  Vec2<Real> upper = Vec2<Real>::Zero();  // [m]

  /// Whether they have a point in common; boxes that touch do.
  bool overlaps(const Aabb& other) const {
    return lower.x() <= other.upper.x() && other.lower.x() <= upper.x() && lower.y() <= other.upper.y() &&
           other.lower.y() <= upper.y();
  }
};

/// The bounding box of a shape of a body, grown by `margin` [m] on every side.
template <Scalar Real>
Aabb<Real> bounding_box(const Shape<Real>& shape, const std::type_identity_t<Frame<Real>>& frame,
                        Real margin = 0);

/// The bounding circle's radius about the body's origin [m].
template <Scalar Real>
Real bounding_radius(const Shape<Real>& shape);

}  // namespace cairn
