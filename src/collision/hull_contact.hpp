// Floor 2. The steps of the narrowphase, of two hulls.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/collision/manifold.hpp>
#include <cairn/collision/rounded_hull.hpp>

namespace cairn::narrowphase {

static_assert(max_polygon_vertices <= 256);  // what feature_id has room for

/// A face of the reference hull, and the vertex of the other hull that is deepest below it.
template <Scalar Real>
struct FaceQuery {
  int face = 0;                                              // of the reference hull
  int vertex = 0;                                            // of the other hull
  Real separation = -std::numeric_limits<Real>::infinity();  // [m], of the cores, along the face's normal
};

/// Two hulls, and how exactly their positions are known.
template <Scalar Real>
struct Pair {
  const RoundedHull<Real>& a;  // the first hull
  const RoundedHull<Real>& b;  // the second one
  Real margin = 0;             // [m]
  Real rounding = 0;           // [m], below it lengths are rounding errors

  /// [m] By which the two cores are rounded.
  Real radii() const { return a.radius + b.radius; }
};

/// The face of `reference` from which `other` is farthest away, of those for which counts(face, vertex)
/// holds. Where there is none, its separation is -infinity.
template <Scalar Real, typename Counts>
FaceQuery<Real> farthest_face(const RoundedHull<Real>& reference, const RoundedHull<Real>& other,
                              const Counts& counts) {
  FaceQuery<Real> best;
  for (int face = 0; face < reference.face_count(); ++face) {
    const Vec2<Real>& normal = reference.normal(face);
    int deepest = 0;
    Real separation = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < other.count; ++i) {
      const Real height = normal.dot(other.vertex(i) - reference.vertex(face));
      if (height < separation) {
        separation = height;
        deepest = i;
      }
    }
    if (separation > best.separation && counts(face, deepest)) best = {face, deepest, separation};
  }
  return best;
}

/// A hull without faces answers -infinity.
template <Scalar Real>
FaceQuery<Real> farthest_face(const RoundedHull<Real>& reference, const RoundedHull<Real>& other) {
  return farthest_face(reference, other, [](int, int) { return true; });
}

/// Of the two faces that end at the vertex, the one that is turned most against the normal. A circle's only
/// vertex counts as a face without length.
template <Scalar Real>
int incident_face(const RoundedHull<Real>& hull, int vertex, const Vec2<Real>& normal) {
  if (hull.face_count() == 0) return 0;
  const int before = hull.previous(vertex);
  return hull.normal(before).dot(normal) < hull.normal(vertex).dot(normal) ? before : vertex;
}

/// The least distances between two edges that do not cross: of their corners from each other, and of a corner
/// of one from the inside of the other.
template <Scalar Real>
struct EdgeDistances {
  Real corners = std::numeric_limits<Real>::infinity();  // [m]
  Real inside = std::numeric_limits<Real>::infinity();   // [m]
  int corner_a = 0;                                      // of the nearest two corners that of a
  int corner_b = 0;                                      // and that of b
};

/// Of an edge of a from one of b.
template <Scalar Real>
EdgeDistances<Real> edge_distances(const Pair<Real>& pair, int edge_a, int edge_b) {
  EdgeDistances<Real> result;
  const auto measure_inside = [&](const Vec2<Real>& corner, const Vec2<Real>& start, const Vec2<Real>& end) {
    const Vec2<Real> span = end - start;
    const Real length = span.norm();
    if (!(length > 0)) return;
    const Real along = span.dot(corner - start) / length;
    if (along < -pair.rounding || along > length + pair.rounding) return;
    result.inside = std::min(result.inside, std::abs(cross<Real>(span, corner - start)) / length);
  };
  const int end_a = pair.a.next(edge_a);
  const int end_b = pair.b.next(edge_b);
  for (const int i : {edge_a, end_a}) {
    measure_inside(pair.a.vertex(i), pair.b.vertex(edge_b), pair.b.vertex(end_b));
    for (const int j : {edge_b, end_b}) {
      const Real distance = (pair.b.vertex(j) - pair.a.vertex(i)).norm();
      if (distance < result.corners) {
        result.corners = distance;
        result.corner_a = i;
        result.corner_b = j;
      }
    }
  }
  for (const int j : {edge_b, end_b}) {
    measure_inside(pair.b.vertex(j), pair.a.vertex(edge_a), pair.a.vertex(end_a));
  }
  return result;
}

/// One point between two vertices.
template <Scalar Real>
Manifold<Real> corner_contact(const Pair<Real>& pair, int vertex_a, int vertex_b) {
  const Vec2<Real> gap = pair.b.vertex(vertex_b) - pair.a.vertex(vertex_a);
  const Real distance = hypotenuse(gap.x(), gap.y());
  const Real separation = distance - pair.radii();
  if (!(separation < pair.margin)) return {};
  Manifold<Real> manifold;
  manifold.count = 1;
  // Centres that coincide have no direction: any will do, as long as it is a direction.
  manifold.normal = {0, 1};
  if (distance > pair.rounding) manifold.normal = gap / distance;
  manifold.points[0].position = pair.a.vertex(vertex_a) + manifold.normal * (pair.a.radius + separation / 2);
  manifold.points[0].separation = separation;
  manifold.points[0].feature = feature_id(FeatureKind::corners, vertex_a, vertex_b);
  return manifold;
}

/// An end of the incident face, seen from the reference face.
template <Scalar Real>
struct IncidentPoint {
  int vertex = 0;   // of the incident hull
  Real along = 0;   // [m], from the start of the reference face
  Real height = 0;  // [m], above the reference face, of the cores
};

/// The ends of the incident face, cut to the width of the reference face. An end keeps the name of its vertex
/// when it is cut: the name then does not flicker where the corners of two boxes are in line. Where the two
/// ends fall together, or the faces do not face each other, only the deepest vertex is left.
template <Scalar Real>
struct Clip {
  int count = 0;                                  // of points
  FixedList<IncidentPoint<Real>, 2> points = {};  // the first `count` of them are in use
};

/// Of the face of `incident` that faces the one that was found.
template <Scalar Real>
Clip<Real> clip(const RoundedHull<Real>& reference, const FaceQuery<Real>& query,
                const RoundedHull<Real>& incident, Real rounding) {
  const Vec2<Real>& normal = reference.normal(query.face);
  const Vec2<Real> tangent = perpendicular(normal);
  const Vec2<Real>& start = reference.vertex(query.face);
  const Real length = tangent.dot(reference.vertex(reference.next(query.face)) - start);
  const auto seen = [&](int vertex) {
    const Vec2<Real> arm = incident.vertex(vertex) - start;
    return IncidentPoint<Real>{vertex, tangent.dot(arm), normal.dot(arm)};
  };
  const int face = incident_face(incident, query.vertex, normal);
  const IncidentPoint<Real> first = seen(face);
  const IncidentPoint<Real> second = seen(incident.next(face));

  const Real lower = std::max(std::min(first.along, second.along), Real(0));
  const Real upper = std::min(std::max(first.along, second.along), length);
  if (!(upper - lower > rounding)) return {1, {seen(query.vertex), {}}};
  const auto cut = [&](const IncidentPoint<Real>& end, const IncidentPoint<Real>& other) {
    const Real along = std::clamp(end.along, lower, upper);
    const Real fraction = (along - end.along) / (other.along - end.along);
    return IncidentPoint<Real>{end.vertex, along, end.height + fraction * (other.height - end.height)};
  };
  return {2, {cut(first, second), cut(second, first)}};
}

/// Up to two points on a face of `reference`. The normal points away from that face.
template <Scalar Real>
Manifold<Real> face_contact(const RoundedHull<Real>& reference, const FaceQuery<Real>& query,
                            const RoundedHull<Real>& incident, const Pair<Real>& pair, FeatureKind owner) {
  const Vec2<Real>& normal = reference.normal(query.face);
  const Vec2<Real> tangent = perpendicular(normal);
  const Clip<Real> ends = clip(reference, query, incident, pair.rounding);
  Manifold<Real> manifold;
  manifold.normal = normal;
  Real sum = 0;  // [m], of the separations
  for (int i = 0; i < ends.count; ++i) {
    const IncidentPoint<Real>& end = ends.points[i];
    const Real separation = end.height - pair.radii();
    if (!(separation < pair.margin)) continue;
    ManifoldPoint<Real>& point = manifold.points[manifold.count++];
    point.position = reference.vertex(query.face) + tangent * end.along;
    point.separation = separation;
    point.feature = feature_id(owner, query.face, end.vertex);
    sum += separation;
  }
  // Midway between the two surfaces, at the same height for both points.
  for (int i = 0; i < manifold.count; ++i) {
    const Real half_gap = sum / static_cast<Real>(2 * manifold.count);
    manifold.points[i].position += normal * (reference.radius + half_gap);
  }
  return manifold;
}

/// Box2D's choice (a tenth of its 5 mm slop, for bodies of 1 m): of two faces that are nearly as far apart,
/// the one of `a` is the reference, so that noise does not swap the roles of two boxes at rest, whose
/// features would then change their names. Relative to the smaller body.
inline constexpr double reference_bias = 5e-4;

/// The corners that are nearest, where the cores are apart by their best faces.
template <Scalar Real>
EdgeDistances<Real> nearest_edges(const Pair<Real>& pair, const FaceQuery<Real>& face_a,
                                  const FaceQuery<Real>& face_b) {
  const bool on_a = face_a.separation >= face_b.separation;
  const int edge_a = on_a ? face_a.face : incident_face(pair.a, face_b.vertex, pair.b.normal(face_b.face));
  const int edge_b = on_a ? incident_face(pair.b, face_a.vertex, pair.a.normal(face_a.face)) : face_b.face;
  return edge_distances(pair, edge_a, edge_b);
}

/// Of boxes stacked in line the corners are as near as the faces: there the faces touch.
template <Scalar Real>
bool corners_are_nearer(const EdgeDistances<Real>& distances, Real rounding) {
  return distances.corners < distances.inside - rounding && distances.corners > rounding;
}

/// Up to two points on the better one of two faces.
template <Scalar Real>
Manifold<Real> better_face_contact(const Pair<Real>& pair, const FaceQuery<Real>& face_a,
                                   const FaceQuery<Real>& face_b) {
  const Real bias = static_cast<Real>(reference_bias) * std::min(pair.a.size(), pair.b.size());
  if (face_a.separation >= face_b.separation - bias) {
    return face_contact(pair.a, face_a, pair.b, pair, FeatureKind::face_of_a);
  }
  Manifold<Real> manifold = face_contact(pair.b, face_b, pair.a, pair, FeatureKind::face_of_b);
  manifold.normal = -manifold.normal;
  return manifold;
}

/// The manifold of two hulls.
template <Scalar Real>
Manifold<Real> collide_hulls(const Pair<Real>& pair) {
  if (pair.a.count == 1 && pair.b.count == 1) return corner_contact(pair, 0, 0);
  const FaceQuery<Real> face_a = farthest_face(pair.a, pair.b);
  if (face_a.separation - pair.radii() >= pair.margin) return {};
  const FaceQuery<Real> face_b = farthest_face(pair.b, pair.a);
  const Real separation = std::max(face_a.separation, face_b.separation);
  if (separation - pair.radii() >= pair.margin) return {};
  if (separation >= -pair.rounding) {  // The cores are apart.
    const EdgeDistances<Real> distances = nearest_edges(pair, face_a, face_b);
    if (corners_are_nearer(distances, pair.rounding)) {
      return corner_contact(pair, distances.corner_a, distances.corner_b);
    }
  }
  return better_face_contact(pair, face_a, face_b);
}

}  // namespace cairn::narrowphase
