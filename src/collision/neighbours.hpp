// Floor 2. What lies beside a shape that never moves, and which contacts that leaves it.
#pragma once

#include <optional>

#include <cairn/collision/rounded_hull.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Unit normals that may stand on a corner: from `from` counter-clockwise to `to`, half a turn at most.
template <Scalar Real>
struct NormalCone {
  Vec2<Real> from = Vec2<Real>::Zero();  // the normal of the surface that ends at the corner
  Vec2<Real> to = Vec2<Real>::Zero();    // and of the one that begins there

  /// Member by member.
  bool operator==(const NormalCone&) const = default;
};

/// How the surface goes on where a face of a hull ends.
template <Scalar Real>
struct FaceEnd {
  /// What lies beyond.
  enum class Kind : char {
    corner,     // the hull's own next face
    neighbour,  // a neighbour, level or over a ridge: beyond the end it is that which is touched
    valley,     // a neighbour that rises from the face
  };
  Kind kind = Kind::corner;  // what lies beyond
  Real rise = 0;             // of a valley: the sine of the angle by which it rises, 1 from a right angle on

  /// Member by member.
  bool operator==(const FaceEnd&) const = default;
};

/// What a hull has to do with where it and its neighbours make one surface: the narrowphase compares two
/// convex hulls, and without it would let a body stumble over the side of the next tile.
///
/// At each corner the solids that meet there leave sectors free. A sector of more than half a turn is a
/// ridge: the normals that may stand on it are those between the normals of its two sides. One of half a turn
/// is level, and has one normal. A narrower one is a valley, whose corner nothing convex can touch. Of a face
/// only what no neighbour covers can be met. All in the frame of the hull's body.
template <Scalar Real>
struct Neighbours {
  /// Of the face from vertex i to the next.
  struct Face {
    Real first = 0;            // [m] from its start: what is not covered lies between these
    Real last = 0;             // [m]
    FaceEnd<Real> start = {};  // at vertex i
    FaceEnd<Real> end = {};    // at the next one

    /// Whether no part of it can be met.
    bool is_covered() const { return !(last > first); }
    /// Member by member.
    bool operator==(const Face&) const = default;
  };
  /// Of a vertex.
  struct Corner {
    bool is_alone = true;                       // nothing lies beside it: any normal may stand on it
    int count = 0;                              // of cones
    FixedList<NormalCone<Real>, 2> cones = {};  // two only where a line without thickness goes on straight

    /// Member by member.
    bool operator==(const Corner&) const = default;
  };

  List<Face> faces = {};      // as many as the hull has
  List<Corner> corners = {};  // as many as vertices
  Real slack = 0;             // [m] so far beyond its end a face may be touched: what neighbours are apart by
  bool one_sided = false;     // a link of a chain: what has its middle behind face 0 is not touched

  /// Member by member.
  bool operator==(const Neighbours&) const = default;
};

/// How far hulls may be from lying exactly beside each other, as a share of the smaller one's size. Box2D's
/// choice (a tenth of its 5 mm slop, for bodies of 1 m) for two faces that are to count as equally far apart.
inline constexpr double level_share = 5e-4;

/// Of a link of a chain: the segment from point(link) to point(link + 1), whose face 0 bodies touch.
template <Scalar Real>
Neighbours<Real> link_neighbours(const Chain<Real>& chain, int link);

/// A shape where it stands for ever, or moves with its neighbours as one body; shapes of different groups do
/// not lie beside each other.
struct StillShape {
  const Shape<double>* shape = nullptr;  // no chain
  Pose<double> pose = {};                // of its body
  int group = 0;                         // any number
};

/// Of each shape what lies beside it; nothing where its neighbours leave it as it is. Shapes of one radius
/// are neighbours, so polygons and segments, or capsules; discs have none. O(n) for shapes that are spread
/// out. Where more than Broadphase::max_pairs of them overlap, none has neighbours.
List<std::optional<Neighbours<double>>> find_neighbours(Span<const StillShape> shapes);

/// The same in another scalar.
template <Scalar Real>
Neighbours<Real> neighbours_cast(const Neighbours<double>& neighbours);

}  // namespace cairn
