// Floor 1. Making shapes: validation, moving, and casting to another scalar.
#include <cairn/geometry/shape.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {
namespace {

// The finest detail of a polygon, relative to its size (lengths, sines of angles and areas alike). A float
// resolves 1.2e-7 of the size, so that details of this size keep a direction in every scalar.
constexpr double finest_detail = 1e-6;

void require_positive(double value, const char* maker, const char* field) {
  require(value > 0, maker, field, "> 0 m", value);
  require_finite(value, maker, field, "m");
}

void require_not_negative(double value, const char* maker, const char* field) {
  require(value >= 0, maker, field, ">= 0 m", value);
  require_finite(value, maker, field, "m");
}

std::string text(const Vec2<double>& point) { return fmt::format("({}, {})", point.x(), point.y()); }

void require_apart(const Vec2<double>& point1, const Vec2<double>& point2, const char* maker) {
  require_finite(point1, maker, "point1", "m");
  require_finite(point2, maker, "point2", "m");
  require(point1 != point2, maker, "point2", "another point than point1", text(point2));
}

double bounding_size(const List<Vec2<double>>& points) {
  Vec2<double> lower = points[0];
  Vec2<double> upper = points[0];
  for (const Vec2<double>& point : points) {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  return hypotenuse(upper.x() - lower.x(), upper.y() - lower.y());
}

/// Positive when the points turn counter-clockwise.
double signed_area(const List<Vec2<double>>& points) {
  double twice = 0;
  for (int i = 1; i + 1 < points.size(); ++i) {
    twice += cross<double>(points[i] - points[0], points[i + 1] - points[0]);
  }
  return twice / 2;
}

void require_distinct(const List<Vec2<double>>& points, double size) {
  for (int i = 0; i < points.size(); ++i) {
    for (int j = i + 1; j < points.size(); ++j) {
      if ((points[j] - points[i]).norm() > finest_detail * size) continue;
      require(false, "polygon", fmt::format("points[{}]", j),
              fmt::format("farther than {:.6g} m from points[{}]", finest_detail * size, i), text(points[j]));
    }
  }
}

/// Every corner must turn left, and all corners together once around. `order` lists the points
/// counter-clockwise, so that a message can name the index that the caller used.
void require_convex(const List<Vec2<double>>& points, const List<int>& order) {
  const int count = order.size();
  double turned = 0;  // [rad]
  for (int i = 0; i < count; ++i) {
    const Vec2<double>& corner = points[order[i]];
    const Vec2<double> before = (corner - points[order[(i + count - 1) % count]]).normalized();
    const Vec2<double> after = (points[order[(i + 1) % count]] - corner).normalized();
    const double sine = cross<double>(before, after);
    const std::string field = fmt::format("points[{}]", order[i]);
    require(sine >= -finest_detail, "polygon", field, "a corner that turns outwards (convex)", text(corner));
    require(sine > finest_detail, "polygon", field, "out of line with its neighbours", text(corner));
    turned += arc_tangent(sine, before.dot(after));
  }
  const double rounds = std::round(turned / (2 * pi));
  require(rounds == 1, "polygon", "number of turns around the inside", "1 (the edges cross)", rounds);
}

/// Outward unit normals of the edges. From the double vertices, so that they are as good as the scalar allows
/// even where rounding the vertices to float bends a short edge.
/// @throws std::invalid_argument where an edge has no length, because the polygon was moved too far away.
template <Scalar Real>
void set_normals(const Polygon<double>& source, Polygon<Real>& target) {
  const int count = source.vertices.size();
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    const Vec2<double> edge = source.vertices[next] - source.vertices[i];
    const double length = hypotenuse(edge.x(), edge.y());
    if (!(length > 0)) {
      require(false, "polygon", fmt::format("vertices[{}]", i), "another point than the next, as rounded",
              text(source.vertices[i]));
    }
    target.normals[i] = {static_cast<Real>(edge.y() / length), static_cast<Real>(-edge.x() / length)};
  }
}

/// A polygon that has its vertices; its normals are to be set.
template <Scalar Real>
Polygon<Real> without_normals(List<Vec2<Real>> vertices, Real radius) {
  Polygon<Real> result{.vertices = std::move(vertices), .radius = radius};
  result.normals.resize(result.vertices.size());
  return result;
}

/// `transform` applied to every point that defines the shape.
struct Mover {
  Pose<double> transform = {};

  Shape<double> operator()(const Circle<double>& shape) const {
    return Circle<double>{transform.world(shape.center), shape.radius};
  }
  Shape<double> operator()(const Capsule<double>& shape) const {
    return Capsule<double>{transform.world(shape.point1), transform.world(shape.point2), shape.radius};
  }
  Shape<double> operator()(const Polygon<double>& shape) const {
    Polygon<double> result = shape;
    for (Vec2<double>& vertex : result.vertices) vertex = transform.world(vertex);
    set_normals(result, result);
    return result;
  }
  Shape<double> operator()(const Segment<double>& shape) const {
    return Segment<double>{transform.world(shape.point1), transform.world(shape.point2)};
  }
  Shape<double> operator()(const Chain<double>& shape) const {
    Chain<double> result = shape;
    for (Vec2<double>& point : result.points) point = transform.world(point);
    result.before = transform.world(shape.before);
    result.after = transform.world(shape.after);
    return result;
  }
};

template <Scalar Real>
struct Caster {
  static Vec2<Real> cast(const Vec2<double>& point) { return point.template cast<Real>(); }

  Shape<Real> operator()(const Circle<double>& shape) const {
    return Circle<Real>{cast(shape.center), static_cast<Real>(shape.radius)};
  }
  Shape<Real> operator()(const Capsule<double>& shape) const {
    return Capsule<Real>{cast(shape.point1), cast(shape.point2), static_cast<Real>(shape.radius)};
  }
  Shape<Real> operator()(const Polygon<double>& shape) const {
    List<Vec2<Real>> vertices;
    vertices.reserve(shape.vertices.size());
    for (const Vec2<double>& vertex : shape.vertices) vertices.push_back(cast(vertex));
    Polygon<Real> result = without_normals(std::move(vertices), static_cast<Real>(shape.radius));
    result.is_piece = shape.is_piece;
    set_normals(shape, result);
    return result;
  }
  Shape<Real> operator()(const Segment<double>& shape) const {
    return Segment<Real>{cast(shape.point1), cast(shape.point2)};
  }
  Shape<Real> operator()(const Chain<double>& shape) const {
    List<Vec2<Real>> points;
    points.reserve(shape.points.size());
    for (const Vec2<double>& point : shape.points) points.push_back(cast(point));
    return Chain<Real>{std::move(points), cast(shape.before), cast(shape.after), shape.closed};
  }
};

}  // namespace

Circle<double> circle(double radius, const Vec2<double>& center) {
  require_positive(radius, "circle", "radius");
  require_finite(center, "circle", "center", "m");
  return {center, radius};
}

Capsule<double> capsule(const Vec2<double>& point1, const Vec2<double>& point2, double radius) {
  require_positive(radius, "capsule", "radius");
  require_apart(point1, point2, "capsule");
  return {point1, point2, radius};
}

Polygon<double> box(double width, double height, double radius) {
  require_positive(width, "box", "width");
  require_positive(height, "box", "height");
  require_not_negative(radius, "box", "radius");
  const double x = width / 2;
  const double y = height / 2;
  Polygon<double> result = without_normals<double>({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, radius);
  set_normals(result, result);
  return result;
}

Polygon<double> polygon(const List<Vec2<double>>& points, double radius) {
  require_not_negative(radius, "polygon", "radius");
  require(points.size() >= 3 && points.size() <= int{max_polygon_vertices}, "polygon", "number of points",
          fmt::format("3 to {}", max_polygon_vertices), fmt::format("{}", points.size()));
  for (int i = 0; i < points.size(); ++i) {
    require_finite(points[i], "polygon", fmt::format("points[{}]", i), "m");
  }
  const double size = bounding_size(points);
  require_distinct(points, size);
  const double area = signed_area(points);
  require(std::abs(area) > finest_detail * size * size, "polygon", "area",
          fmt::format("> {:.6g} m^2 for a size of {:.6g} m", finest_detail * size * size, size),
          std::abs(area));
  List<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (area < 0) std::reverse(order.begin(), order.end());
  require_convex(points, order);

  List<Vec2<double>> vertices;
  vertices.reserve(points.size());
  for (const int i : order) vertices.push_back(points[i]);
  Polygon<double> result = without_normals(std::move(vertices), radius);
  set_normals(result, result);
  return result;
}

Segment<double> segment(const Vec2<double>& point1, const Vec2<double>& point2) {
  require_apart(point1, point2, "segment");
  return {point1, point2};
}

Shape<double> moved(const Shape<double>& shape, const Vec2<double>& offset, double angle) {
  require_finite(offset, "moved", "offset", "m");
  require_finite(angle, "moved", "angle", "rad");
  return std::visit(Mover{{offset, angle}}, shape);
}

template <Scalar Real>
Shape<Real> shape_cast(const Shape<double>& shape) {
  return std::visit(Caster<Real>{}, shape);
}

std::string shape_name(const Shape<double>& shape) {
  constexpr const char* names[] = {"circle", "capsule", "polygon", "segment", "chain"};
  static_assert(std::variant_size_v<Shape<double>> == std::size(names));
  return names[shape.index()];
}

template Shape<float> shape_cast<float>(const Shape<double>&);
template Shape<double> shape_cast<double>(const Shape<double>&);

}  // namespace cairn
