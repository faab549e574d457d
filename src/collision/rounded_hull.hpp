// Floor 2. One form for every shape in the narrowphase: the convex hull of a few points, rounded by a radius.
#pragma once

#include <cmath>

#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// A circle has one vertex and no face; a capsule or segment has two vertices and two faces, one a side; a
/// polygon has as many faces as vertices. All in the directions of the world.
template <Scalar Real>
struct RoundedHull {
  FixedList<Vec2<Real>, max_polygon_vertices> vertices;  // [m], counter-clockwise
  FixedList<Vec2<Real>, max_polygon_vertices> normals;   // normals[i]: outward unit, of the face i -> i + 1
  int count = 0;                                         // of vertices
  Real radius = 0;                                       // [m]
  Real size_squared = 0;                                 // [m^2], see size()
  Real extent = 0;  // [m], the largest coordinate: rounding errors are proportional to it

  /// [m] The largest distance of a vertex from vertex 0.
  Real size() const { return std::sqrt(size_squared); }

  /// Faces: none of a circle, otherwise as many as vertices.
  int face_count() const { return count == 1 ? 0 : count; }
  /// The vertex after vertex i, counter-clockwise.
  int next(int i) const { return i + 1 == count ? 0 : i + 1; }
  /// The vertex before vertex i.
  int previous(int i) const { return i == 0 ? count - 1 : i - 1; }
  /// Vertex i [m].
  const Vec2<Real>& vertex(int i) const { return vertices[i]; }
  /// The outward unit normal of the face from vertex i to the next.
  const Vec2<Real>& normal(int i) const { return normals[i]; }
};

/// The hull of a shape of a body. Positions are relative to `origin`, a point close to the shape, so that no
/// digits are lost where the shape is far from the world's origin.
template <Scalar Real>
RoundedHull<Real> rounded_hull(const Shape<Real>& shape, const Frame<Real>& frame, const Vec2<Real>& origin);

}  // namespace cairn
