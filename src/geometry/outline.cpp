// Floor 1. Outlines that are not convex: cut into convex pieces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <cairn/geometry/shape.hpp>
#include <cairn/math/check.hpp>

namespace cairn {
namespace {

using Point = Vec2<double>;
using Loop = List<int>;  // numbers of points, counter-clockwise

// As that of a polygon: of the size of the outline, and a sine of angles.
constexpr double finest = 1e-6;

std::string place_text(const Point& point) { return fmt::format("({}, {})", point.x(), point.y()); }

std::string point_name(int i) { return fmt::format("points[{}]", i); }

/// The sine of the corner at b, positive where it turns to the left.
double sine_at(const Point& a, const Point& b, const Point& c) {
  return cross<double>((b - a).normalized(), (c - b).normalized());
}

double distance(const Point& point, const Point& from, const Point& to) {
  const Point way = to - from;
  const double along = std::clamp(way.dot(point - from) / way.squaredNorm(), 0.0, 1.0);
  return (point - from - along * way).norm();
}

bool are_crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto parts = [](const Point& from, const Point& to, const Point& one, const Point& other) {
    return (cross<double>(to - from, one - from) > 0) != (cross<double>(to - from, other - from) > 0);
  };
  return parts(a, b, c, d) && parts(c, d, a, b);
}

/// An outline in one turning sense, and what it is cut into.
class Outline {
 public:
  explicit Outline(const List<Point>& points) : points_(points) {
    require(points.size() >= 3 && points.size() <= max_outline_vertices, "outline", "number of points",
            fmt::format("3 to {}", max_outline_vertices), points.size());
    for (const int i : points.indices()) require_finite(points[i], "outline", point_name(i), "m");
    Point lower = points[0], upper = points[0];
    for (const Point& point : points) lower = lower.cwiseMin(point), upper = upper.cwiseMax(point);
    size_ = hypotenuse(upper.x() - lower.x(), upper.y() - lower.y());
    require_corners();
    require_simple();
    loop_.resize(points.size());
    std::iota(loop_.begin(), loop_.end(), 0);
    const double area = area_of(loop_);
    require(std::abs(area) > finest * size_ * size_, "outline", "area",
            fmt::format("> {:.6g} m^2 for a size of {:.6g} m", finest * size_ * size_, size_),
            std::abs(area));
    if (area < 0) std::reverse(loop_.begin(), loop_.end());
  }

  /// Convex pieces.
  List<Loop> pieces() {
    cut_ears();
    std::stable_sort(diagonals_.begin(), diagonals_.end(), [this](const auto& one, const auto& other) {
      return (at(one.second) - at(one.first)).norm() > (at(other.second) - at(other.first)).norm();
    });
    for (const auto& [from, to] : diagonals_) leave_out(from, to);
    return pieces_;
  }

 private:
  const Point& at(int i) const { return points_[i]; }

  double area_of(const Loop& loop) const {
    double twice = 0;
    for (int i = 1; i + 1 < loop.size(); ++i)
      twice += cross<double>(at(loop[i]) - at(loop[0]), at(loop[i + 1]) - at(loop[0]));
    return twice / 2;
  }

  void require_corners() const {
    const int count = points_.size();
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j)
        require((at(j) - at(i)).norm() > finest * size_, "outline", point_name(j),
                fmt::format("farther than {:.6g} m from points[{}]", finest * size_, i), place_text(at(j)));
    }
    for (int i = 0; i < count; ++i) {
      const double sine = sine_at(at((i + count - 1) % count), at(i), at((i + 1) % count));
      require(std::abs(sine) > finest, "outline", point_name(i), "out of line with its neighbours",
              place_text(at(i)));
    }
  }

  /// Edges that are not neighbours must stay apart.
  void require_simple() const {
    const int count = points_.size();
    for (int i = 0; i < count; ++i) {
      const int i_end = (i + 1) % count;
      for (int j = i + 2; j < count; ++j) {
        const int j_end = (j + 1) % count;
        if (j_end == i) continue;
        const Point &a = at(i), &b = at(i_end), &c = at(j), &d = at(j_end);
        const double apart =
            are_crossing(a, b, c, d)
                ? 0
                : std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
        require(apart > finest * size_, "outline", "edges",
                fmt::format("apart ({:.6g} m and more): an outline does not cross or touch itself",
                            finest * size_),
                fmt::format("points[{}] to points[{}] and points[{}] to points[{}]", i, i_end, j, j_end));
      }
    }
  }

  /// How little slender the triangle at corner k of what is left is; negative: it is no ear.
  double ear_quality(int k) const {
    const int count = loop_.size();
    const int before = loop_[(k + count - 1) % count], tip = loop_[k], after = loop_[(k + 1) % count];
    const Point &a = at(before), &b = at(tip), &c = at(after);
    if (sine_at(a, b, c) <= finest) return -1;
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    for (const int i : loop_) {
      if (i != before && i != tip && i != after && holds(a, b, c, at(i))) return -1;
    }
    return cross<double>(b - a, c - a) / (longest * longest);
  }

  /// Whether a triangle, its edges included, has the point in it.
  bool holds(const Point& a, const Point& b, const Point& c, const Point& point) const {
    const auto height = [&point](const Point& from, const Point& to) {
      return cross<double>(to - from, point - from) / (to - from).norm();
    };
    return std::min({height(a, b), height(b, c), height(c, a)}) >= -finest * size_ / 2;
  }

  void cut_ears() {
    while (loop_.size() > 3) {
      int best = 0;
      double quality = -1;
      for (const int k : loop_.indices()) {
        const double of_k = ear_quality(k);
        if (of_k > quality) quality = of_k, best = k;
      }
      require(quality > 0, "outline", "points", "an outline without details finer than a millionth of it",
              "one that cannot be cut");
      const int count = loop_.size();
      const int before = loop_[(best + count - 1) % count], after = loop_[(best + 1) % count];
      pieces_.push_back({before, loop_[best], after});
      diagonals_.push_back({before, after});
      loop_.erase(loop_.begin() + best);
    }
    pieces_.push_back(loop_);
  }

  /// The piece that has this edge, turned so that the edge is its last one; -1: none.
  int with_edge(int from, int to) {
    for (const int k : pieces_.indices()) {
      Loop& piece = pieces_[k];
      const auto found = std::find(piece.begin(), piece.end(), to);
      if (found == piece.end()) continue;
      std::rotate(piece.begin(), found, piece.end());
      if (piece.back() == from) return k;
    }
    return -1;
  }

  /// Joins the two pieces beside a diagonal where they are convex together.
  void leave_out(int from, int to) {
    const int one = with_edge(from, to), other = with_edge(to, from);
    Loop joined = pieces_[one];  // from `to` to `from`
    joined.insert(joined.end(), pieces_[other].begin() + 1, pieces_[other].end() - 1);
    const int count = joined.size();
    if (count > max_polygon_vertices) return;
    for (int i = 0; i < count; ++i) {
      const Point &before = at(joined[(i + count - 1) % count]), &after = at(joined[(i + 1) % count]);
      if (sine_at(before, at(joined[i]), after) <= finest) return;
    }
    pieces_[one] = joined;
    pieces_.erase(pieces_.begin() + other);
  }

  const List<Point>& points_;
  double size_ = 0;  // [m]
  Loop loop_;        // what is left of it
  List<Loop> pieces_;
  List<std::pair<int, int>> diagonals_;
};

}  // namespace

List<Shape<double>> outline(const List<Vec2<double>>& points) {
  List<Shape<double>> shapes;
  const List<Loop> pieces = Outline(points).pieces();
  if (pieces.size() == 1) return {polygon(points)};
  for (const Loop& piece : pieces) {
    List<Point> corners;
    for (const int i : piece) corners.push_back(points[i]);
    Polygon<double> shape = polygon(corners);
    shape.is_piece = true;
    shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace cairn
