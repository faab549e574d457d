// Floor 1. Shapes, given in the frame of the body that carries them.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include <cairn/math/math.hpp>
#include <cairn/math/list.hpp>

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
  bool is_piece = false;           // of an outline: on the inner side of its edges may lie other pieces

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

/// Ground of any form: links from point to point, without thickness and without mass, for bodies that are not
/// dynamic. It has one side: walking from point to point, the solid is on the left hand, and bodies touch it
/// from the right, as they do a polygon whose corners run counter-clockwise. So ground runs from right to
/// left, and a room clockwise. What comes from the solid side goes through. Its inner points are smooth: a
/// body that slides over one meets no edge of the next link.
template <Scalar Real>
struct Chain {
  List<Vec2<Real>> points = {};            // [m]
  Vec2<Real> before = Vec2<Real>::Zero();  // [m] where an open one would come from: a point that is not there
  Vec2<Real> after = Vec2<Real>::Zero();   // [m] and where it would go on to
  bool closed = false;                     // the last point is linked to the first

  /// Member by member.
  bool operator==(const Chain&) const = default;
  /// Of links.
  int link_count() const { return points.size() - (closed ? 0 : 1); }
  /// Of link i, from point(i) to point(i + 1); from -1 to link_count() + 1.
  const Vec2<Real>& point(int i) const {
    const int count = points.size();
    if (closed) return points[(i + count) % count];
    return i < 0 ? before : i < count ? points[i] : after;
  }
};

/// Any of the shapes.
template <Scalar Real>
using Shape = std::variant<Circle<Real>, Capsule<Real>, Polygon<Real>, Segment<Real>, Chain<Real>>;

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

/// As many corners as an outline may have.
inline constexpr int max_outline_vertices = 500;

/// A body of any outline without holes, in either turning sense: convex polygons that fill it, side by side,
/// which are pieces of one another's surface. One polygon where it is convex and has at most 16 corners. The
/// outline is cut into triangles, ear by ear, each time the least slender one that can be cut off (G.
/// Meisters, Polygons Have Ears, 1975); then diagonals are left out as long as what they part is convex
/// together (S. Hertel and K. Mehlhorn, Fast Triangulation of Simple Polygons, 1983): at most four times as
/// many pieces as there have to be.
/// @throws std::invalid_argument with fewer than 3 or more than 500 points, two equal points, a corner in
/// line with its neighbours, edges that meet, and no area.
List<Shape<double>> outline(const List<Vec2<double>>& points);

/// @throws std::invalid_argument when the points coincide.
Segment<double> segment(const Vec2<double>& point1, const Vec2<double>& point2);

/// How a chain ends. The points before and after an open one are not part of it: they say how it would go on,
/// so that its ends are as smooth as its inner points. Left out, it goes on straight.
struct ChainEnds {
  bool closed = false;                      // the last point is linked to the first
  std::optional<Vec2<double>> before = {};  // [m]
  std::optional<Vec2<double>> after = {};   // [m]
};

/// @throws std::invalid_argument with fewer than 2 points, or 3 of a closed one, for neighbouring points that
/// are equal, a corner that turns straight back, and points before or after a closed one.
Chain<double> chain(const List<Vec2<double>>& points, const ChainEnds& ends = {});

/// How many pieces a shape collides in: each link of a chain is one, and every other shape as it is.
template <Scalar Real>
int piece_count(const Shape<Real>& shape) {
  const Chain<Real>* chain = std::get_if<Chain<Real>>(&shape);
  return chain == nullptr ? 1 : chain->link_count();
}

/// Whether a shape is a piece of an outline().
inline bool is_piece(const Shape<double>& shape) {
  const auto* const polygon = std::get_if<Polygon<double>>(&shape);
  return polygon != nullptr && polygon->is_piece;
}

/// The same shape moved by `offset`, turned by `angle` around the origin first.
Shape<double> moved(const Shape<double>& shape, const Vec2<double>& offset, double angle = 0);

/// The same shape in another scalar. Polygon normals are computed anew in that scalar.
template <Scalar Real>
Shape<Real> shape_cast(const Shape<double>& shape);

/// "circle", "capsule", "polygon", "segment" or "chain".
std::string shape_name(const Shape<double>& shape);

}  // namespace cairn
