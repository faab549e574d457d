// Floor 2. What lies beside a shape that never moves: links of chains, and shapes that touch each other.
#include <cairn/collision/neighbours.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <cairn/collision/broadphase.hpp>
#include <cairn/collision/corner_sectors.hpp>

namespace cairn {
namespace {

using Hull = RoundedHull<double>;
using Interval = std::pair<double, double>;

double angle_of_way(const Vec2<double>& way) { return arc_tangent(way.y(), way.x()); }

/// The way from a vertex to the next one, of length 1.
Vec2<double> way_along(const Hull& hull, int face) { return perpendicular(hull.normal(face)); }

double face_length(const Hull& hull, int face) {
  return way_along(hull, face).dot(hull.vertex(hull.next(face)) - hull.vertex(face));
}

/// [rad] The solid at a vertex, from the way to the next one to the way back to the one before.
double solid_angle(const Hull& hull, int vertex) {
  const Vec2<double> back = -way_along(hull, hull.previous(vertex));
  return within_turn(angle_of_way(back) - angle_of_way(way_along(hull, vertex)));
}

/// One hull, and what its neighbours leave of it.
class Neighbourhood {
 public:
  /// Of a hull with faces.
  explicit Neighbourhood(const Hull& hull) : hull_(hull), covered_(hull.count) {
    for (int i = 0; i < hull.count; ++i) sectors_.emplace_back(solid_angle(hull, i));
  }

  void add(const Hull& other) {
    const double near = level_share * std::min(hull_.size(), other.size());
    slack_ = std::max(slack_, near);
    for (int i = 0; i < hull_.count; ++i) {
      other.count == 2 ? meet_line(other, i, near) : meet_polygon(other, i, near);
      if (other.count > 2) cover(other, i, near);
    }
  }

  /// In the frame of the hull's body.
  std::optional<Neighbours<double>> result(const Rotation<double>& rotation) const {
    Neighbours<double> result{.slack = slack_};
    bool is_changed = false;
    for (int i = 0; i < hull_.count; ++i) {
      result.faces.push_back(face(i));
      result.corners.push_back(corner(i, rotation));
      const auto& made = result.faces.back();
      is_changed = is_changed || made.first > 0 || made.last < face_length(hull_, i);
      is_changed = is_changed || !result.corners.back().is_alone;
    }
    if (!is_changed) return std::nullopt;
    return result;
  }

 private:
  /// [rad] As seen from the face that begins at a vertex.
  double turned(int vertex, const Vec2<double>& way) const {
    return angle_of_way(way) - angle_of_way(way_along(hull_, vertex));
  }

  void meet_line(const Hull& line, int vertex, double near) {
    const Vec2<double> way = way_along(line, 0);
    const Vec2<double> arm = hull_.vertex(vertex) - line.vertex(0);
    const double along = way.dot(arm), length = face_length(line, 0);
    if (std::abs(cross(way, arm)) > near || along < -near || along > length + near) return;
    if (along > 2 * near) sectors_[vertex].add(turned(vertex, -way), 0);
    if (along < length - 2 * near) sectors_[vertex].add(turned(vertex, way), 0);
  }

  void meet_polygon(const Hull& other, int vertex, double near) {
    const Vec2<double>& at = hull_.vertex(vertex);
    int face = 0;
    double height = -std::numeric_limits<double>::infinity();  // [m] over the polygon
    for (int k = 0; k < other.count; ++k) {
      const double over = other.normal(k).dot(at - other.vertex(k));
      if (over > height) height = over, face = k;
    }
    if (height > near) return;
    if (height < -near) return sectors_[vertex].fill();
    for (int k = 0; k < other.count; ++k) {
      if ((at - other.vertex(k)).norm() > 2 * near) continue;
      return sectors_[vertex].add(turned(vertex, way_along(other, k)), solid_angle(other, k));
    }
    sectors_[vertex].add(turned(vertex, way_along(other, face)), pi);
  }

  /// What of a face lies in another polygon: of the line beside it, which a gap between the two is too narrow
  /// to hold.
  void cover(const Hull& other, int face, double near) {
    const Vec2<double> start = hull_.vertex(face) + 2 * near * hull_.normal(face),
                       way = way_along(hull_, face);
    const double length = face_length(hull_, face);
    double from = 0, to = length;
    for (int k = 0; k < other.count; ++k) {
      const double over = other.normal(k).dot(start - other.vertex(k)), slope = other.normal(k).dot(way);
      if (slope > 0) {
        to = std::min(to, -over / slope);
      } else if (slope < 0) {
        from = std::max(from, -over / slope);
      } else if (over > 0) {
        return;
      }
    }
    if (from < 2 * near) from = 0;
    if (to > length - 2 * near) to = length;
    if (to > from) covered_[face].push_back({from, to});
  }

  Neighbours<double>::Face face(int i) const {
    Neighbours<double>::Face result{.first = 0, .last = face_length(hull_, i)};
    List<Interval> covered = covered_[i];
    std::sort(covered.begin(), covered.end());
    for (const auto& [from, to] : covered) {
      if (from <= result.first + slack_) result.first = std::max(result.first, to);
    }
    std::sort(covered.begin(), covered.end(),
              [](const Interval& a, const Interval& b) { return a.second > b.second; });
    for (const auto& [from, to] : covered) {
      if (to >= result.last - slack_) result.last = std::min(result.last, from);
    }
    const int next = hull_.next(i);
    if (!sectors_[i].is_alone()) result.start = end_beside(sectors_[i], true);
    if (!sectors_[next].is_alone()) result.end = end_beside(sectors_[next], false);
    return result;
  }

  /// How the surface goes on beside the hull's own sector: clockwise of where it begins, or from its end on.
  static FaceEnd<double> end_beside(const CornerSectors& corner, bool at_begin) {
    for (const FreeSector& sector : corner.free()) {
      const bool is_beside = at_begin ? sector.begin + sector.width >= 2 * pi : sector.begin == corner.own();
      if (is_beside) return end_of<double>(sector);
    }
    return {.kind = FaceEnd<double>::Kind::neighbour};  // the face is covered there
  }

  Neighbours<double>::Corner corner(int i, const Rotation<double>& rotation) const {
    Neighbours<double>::Corner result;
    result.is_alone = sectors_[i].is_alone();
    if (result.is_alone) return result;
    for (FreeSector sector : sectors_[i].free()) {
      if (!sector.is_open() || result.count == result.cones.size()) continue;
      sector.begin += angle_of_way(way_along(hull_, i));
      const NormalCone<double> cone = cone_of<double>(sector);
      result.cones[result.count++] = {rotation.transposed_times(cone.from),
                                      rotation.transposed_times(cone.to)};
    }
    return result;
  }

  const Hull& hull_;
  List<CornerSectors> sectors_;   // of each vertex
  List<List<Interval>> covered_;  // [m] of each face
  double slack_ = 0;              // [m]
};

List<std::pair<int, int>> near_pairs_of(Span<const StillShape> shapes, const List<Hull>& hulls) {
  List<Aabb<double>> boxes;
  for (const int i : shapes.indices()) {
    const double near = level_share * hulls[i].size();
    boxes.push_back(bounding_box(*shapes[i].shape, Frame<double>(shapes[i].pose), near));
  }
  Broadphase<double> broadphase(BroadphaseKind::grid);
  try {
    return broadphase.pairs(boxes, List<char>(boxes.size(), 1));
  } catch (const std::length_error&) {
    return {};
  }
}

/// The corner of a chain between two links, from the solid on the left hand of one to that of the other.
template <Scalar Real>
FaceEnd<Real> add_corner(const Vec2<Real>& before, const Vec2<Real>& corner, const Vec2<Real>& after,
                         Neighbours<Real>& link) {
  const double back = angle_of_way((before - corner).template cast<double>());
  const double on = angle_of_way((after - corner).template cast<double>());
  const FreeSector sector{back, within_turn(on - back)};
  auto& made = link.corners.emplace_back();
  made.is_alone = false;
  if (sector.is_open()) made.cones[made.count++] = cone_of<Real>(sector);
  return end_of<Real>(sector);
}

template <Scalar Real>
FaceEnd<Real> cast_end(const FaceEnd<double>& end) {
  return {static_cast<typename FaceEnd<Real>::Kind>(end.kind), static_cast<Real>(end.rise)};
}

}  // namespace

List<std::optional<Neighbours<double>>> find_neighbours(Span<const StillShape> shapes) {
  List<Hull> hulls;
  for (const StillShape& still : shapes) {
    hulls.push_back(rounded_hull<double>(*still.shape, Frame<double>(still.pose), Vec2<double>(0, 0)));
  }
  List<std::optional<Neighbourhood>> around(hulls.size());
  for (const int i : hulls.indices()) {
    if (hulls[i].face_count() > 0) around[i].emplace(hulls[i]);
  }
  for (const auto& [i, j] : near_pairs_of(shapes, hulls)) {
    if (!around[i] || !around[j] || hulls[i].radius != hulls[j].radius) continue;
    if (shapes[i].group != shapes[j].group) continue;
    around[i]->add(hulls[j]);
    around[j]->add(hulls[i]);
  }
  List<std::optional<Neighbours<double>>> result(hulls.size());
  for (const int i : hulls.indices()) {
    if (around[i]) result[i] = around[i]->result(Rotation<double>(shapes[i].pose.angle));
  }
  return result;
}

template <Scalar Real>
Neighbours<Real> link_neighbours(const Chain<Real>& chain, int link) {
  const Vec2<Real>&from = chain.point(link), &to = chain.point(link + 1);
  const Real length = (to - from).norm();
  Neighbours<Real> result;
  result.slack = static_cast<Real>(level_share) * length;
  result.one_sided = true;
  result.faces.resize(2);  // of face 1, the back, nothing can be met
  result.faces[0].last = length;
  result.faces[0].start = add_corner(chain.point(link - 1), from, to, result);
  result.faces[0].end = add_corner(from, to, chain.point(link + 2), result);
  return result;
}

template <Scalar Real>
Neighbours<Real> neighbours_cast(const Neighbours<double>& neighbours) {
  Neighbours<Real> result;
  result.slack = static_cast<Real>(neighbours.slack);
  result.one_sided = neighbours.one_sided;
  for (const auto& face : neighbours.faces) {
    const Real first = static_cast<Real>(face.first), last = static_cast<Real>(face.last);
    result.faces.push_back({first, last, cast_end<Real>(face.start), cast_end<Real>(face.end)});
  }
  for (const auto& corner : neighbours.corners) {
    auto& made = result.corners.emplace_back();
    made.is_alone = corner.is_alone;
    made.count = corner.count;
    for (int k = 0; k < corner.count; ++k) {
      made.cones[k] = {corner.cones[k].from.template cast<Real>(), corner.cones[k].to.template cast<Real>()};
    }
  }
  return result;
}

template Neighbours<float> link_neighbours(const Chain<float>&, int);
template Neighbours<double> link_neighbours(const Chain<double>&, int);
template Neighbours<float> neighbours_cast(const Neighbours<double>&);
template Neighbours<double> neighbours_cast(const Neighbours<double>&);

}  // namespace cairn
