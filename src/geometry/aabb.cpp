// Floor 1. Axis-aligned bounding boxes.
#include <cairn/geometry/aabb.hpp>

#include <algorithm>
#include <limits>

namespace cairn {
namespace {

// Every shape is a core of points, their convex hull, and all that is within a radius of it. These call
// `use(point)` for every point of the core and return the radius.
template <Scalar Real, typename Use>
Real visit_core(const Circle<Real>& shape, const Use& use) {
  use(shape.center);
  return shape.radius;
}
template <Scalar Real, typename Use>
Real visit_core(const Capsule<Real>& shape, const Use& use) {
  use(shape.point1);
  use(shape.point2);
  return shape.radius;
}
template <Scalar Real, typename Use>
Real visit_core(const Polygon<Real>& shape, const Use& use) {
  std::for_each(shape.vertices.begin(), shape.vertices.end(), use);
  return shape.radius;
}
template <Scalar Real, typename Use>
Real visit_core(const Segment<Real>& shape, const Use& use) {
  use(shape.point1);
  use(shape.point2);
  return 0;
}
template <Scalar Real, typename Use>
Real visit_core(const Chain<Real>& shape, const Use& use) {
  std::for_each(shape.points.begin(), shape.points.end(), use);
  return 0;
}

}  // namespace

template <Scalar Real>
Aabb<Real> bounding_box(const Shape<Real>& shape, const std::type_identity_t<Frame<Real>>& frame,
                        Real margin) {
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  // The core in the world's directions, seen from the body's origin.
  Vec2<Real> lower = Vec2<Real>::Constant(infinity);
  Vec2<Real> upper = Vec2<Real>::Constant(-infinity);
  const auto include = [&](const Vec2<Real>& local) {
    const Vec2<Real> arm = frame.rotation * local;
    lower = lower.cwiseMin(arm);
    upper = upper.cwiseMax(arm);
  };
  const Real radius = std::visit([&](const auto& held) { return visit_core(held, include); }, shape);
  const Vec2<Real> grown = Vec2<Real>::Constant(radius + margin);
  return {frame.position + lower - grown, frame.position + upper + grown};
}

template <Scalar Real>
Real bounding_radius(const Shape<Real>& shape) {
  Real farthest = 0;
  const auto include = [&](const Vec2<Real>& local) { farthest = std::max(farthest, local.norm()); };
  const Real radius = std::visit([&](const auto& held) { return visit_core(held, include); }, shape);
  return farthest + radius;
}

template Aabb<float> bounding_box(const Shape<float>&, const Frame<float>&, float);
template Aabb<double> bounding_box(const Shape<double>&, const Frame<double>&, double);

template float bounding_radius(const Shape<float>&);
template double bounding_radius(const Shape<double>&);

}  // namespace cairn
