// Floor 2. One form for every shape in the narrowphase: the convex hull of a few points, rounded by a radius.
#include <cairn/collision/rounded_hull.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace cairn {
namespace {

template <Scalar Real>
struct HullMaker {
  Vec2<Real> position;      // [m], of the body, relative to the origin of the hull
  Rotation<Real> rotation;  // from the body's frame to the world's

  /// Number by number: what has just been written as two numbers is slow to read as a vector.
  Vec2<Real> placed(const Vec2<Real>& local) const {
    const Vec2<Real> arm = rotation * local;
    return {position.x() + arm.x(), position.y() + arm.y()};
  }

  RoundedHull<Real> operator()(const Circle<Real>& shape) const {
    RoundedHull<Real> hull;
    hull.count = 1;
    hull.radius = shape.radius;
    hull.vertices[0] = placed(shape.center);
    return hull;
  }

  RoundedHull<Real> operator()(const Capsule<Real>& shape) const {
    const Vec2<Real> edge = shape.point2 - shape.point1;
    const Real length = hypotenuse(edge.x(), edge.y());
    // Two points of a shape given in double can be one point in float.
    if (!(length > 0)) return (*this)(Circle<Real>{shape.point1, shape.radius});
    RoundedHull<Real> hull;
    hull.count = 2;
    hull.radius = shape.radius;
    hull.vertices[0] = placed(shape.point1);
    hull.vertices[1] = placed(shape.point2);
    hull.normals[0] = rotation * Vec2<Real>(edge.y() / length, -edge.x() / length);
    hull.normals[1] = -hull.normals[0];
    return hull;
  }

  RoundedHull<Real> operator()(const Segment<Real>& shape) const {
    return (*this)(Capsule<Real>{shape.point1, shape.point2, Real(0)});
  }

  /// A chain is no hull: its links are.
  RoundedHull<Real> operator()(const Chain<Real>&) const {
    assert(false);
    return {};
  }

  RoundedHull<Real> operator()(const Polygon<Real>& shape) const {
    RoundedHull<Real> hull;
    hull.count = shape.vertices.size();
    hull.radius = shape.radius;
    for (int i = 0; i < hull.count; ++i) {
      hull.vertices[i] = placed(shape.vertices[i]);
      hull.normals[i] = rotation * shape.normals[i];
    }
    return hull;
  }
};

}  // namespace

template <Scalar Real>
RoundedHull<Real> rounded_hull(const Shape<Real>& shape, const Frame<Real>& frame, const Vec2<Real>& origin) {
  const HullMaker<Real> maker = {frame.position - origin, frame.rotation};
  RoundedHull<Real> hull = std::visit(maker, shape);
  const Vec2<Real>& first = hull.vertex(0);
  for (int i = 0; i < hull.count; ++i) {
    const Vec2<Real>& vertex = hull.vertex(i);
    const Real x = vertex.x() - first.x(), y = vertex.y() - first.y();
    hull.size_squared = std::max(hull.size_squared, x * x + y * y);
    hull.extent = std::max({hull.extent, std::abs(vertex.x()), std::abs(vertex.y())});
  }
  return hull;
}

template RoundedHull<float> rounded_hull(const Shape<float>&, const Frame<float>&, const Vec2<float>&);
template RoundedHull<double> rounded_hull(const Shape<double>&, const Frame<double>&, const Vec2<double>&);

}  // namespace cairn
