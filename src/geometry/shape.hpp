// Floor 1. Shapes, given in the frame of the body that carries them.
#pragma once

#include <string>
#include <variant>

#include "math/math.hpp"
#include "math/list.hpp"

namespace cairn {

/// As many corners as a polygon may have.
inline constexpr int max_polygon_vertices = 16;

/// All points within `radius` of the center.
template <Scalar Real>
struct Circle {
  Vec2<Real> center = Vec2<Real>::Zero();  // [m]
  Real radius = 0;                         // [m]

  /// Member by member.
  bool operator==(const Circle&) const = default;
};

/// All points within `radius` of the segment from point1 to point2.
template <Scalar Real>
struct Capsule {
  Vec2<Real> point1 = Vec2<Real>::Zero();  // [m]
  Vec2<Real> point2 = Vec2<Real>::Zero();  // [m]
  Real radius = 0;                         // [m]

  /// Member by member.
  bool operator==(const Capsule&) const = default;
};

/// A convex polygon, counter-clockwise, rounded by `radius` (all points within `radius` of it).
template <Scalar Real>
struct Polygon {
  List<Vec2<Real>> vertices = {};  // [m]
  List<Vec2<Real>> normals = {};   // as many; normals[i]: outward, of the edge i -> i + 1
  Real radius = 0;                 // [m]

  /// Member by member.
  bool operator==(const Polygon&) const = default;
};

/// A line without thickness and without mass: for static scenery. Both sides collide.
template <Scalar Real>
struct Segment {
  Vec2<Real> point1 = Vec2<Real>::Zero();  // [m]
  Vec2<Real> point2 = Vec2<Real>::Zero();  // [m]

  /// Member by member.
  bool operator==(const Segment&) const = default;
};

/// Any of the shapes.
template <Scalar Real>
using Shape = std::variant<Circle<Real>, Capsule<Real>, Polygon<Real>, Segment<Real>>;

// Makers, in double: scenes are written in double and converted once. Each throws std::invalid_argument,
// naming the maker, the field, the rule, the unit and the value, when a number is not finite or out of range.

/// @throws std::invalid_argument unless radius > 0.
Circle<double> circle(double radius, const Vec2<double>& center = {0, 0});

/// @throws std::invalid_argument unless radius > 0 and the points differ.
Capsule<double> capsule(const Vec2<double>& point1, const Vec2<double>& point2, double radius);

/// A rectangle around the origin, rounded outwards by `radius`.
/// @throws std::invalid_argument unless width > 0, height > 0 and radius >= 0.
Polygon<double> box(double width, double height, double radius = 0);

/// A convex polygon through the given points, in either turning sense (stored counter-clockwise).
/// @throws std::invalid_argument with fewer than 3 or more than 16 points, two equal points, collinear or
/// non-convex points, no area, or radius < 0.
Polygon<double> polygon(const List<Vec2<double>>& points, double radius = 0);

/// @throws std::invalid_argument when the points coincide.
Segment<double> segment(const Vec2<double>& point1, const Vec2<double>& point2);

/// The same shape moved by `offset`, turned by `angle` around the origin first.
Shape<double> moved(const Shape<double>& shape, const Vec2<double>& offset, double angle = 0);

/// The same shape in another scalar. Polygon normals are computed anew in that scalar.
template <Scalar Real>
Shape<Real> shape_cast(const Shape<double>& shape);

/// "circle", "capsule", "polygon" or "segment".
std::string shape_name(const Shape<double>& shape);

}  // namespace cairn
