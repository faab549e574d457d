// Floor 1. Making chains.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <cairn/geometry/shape.hpp>
#include <cairn/math/check.hpp>

namespace cairn {
namespace {

// Of the length of a chain's box: shorter links, and smaller angles between them, have no direction in float.
constexpr double shortest_link = 1e-6;

std::string chain_text(const Vec2<double>& point) { return fmt::format("({}, {})", point.x(), point.y()); }

double largest_reach(const List<Vec2<double>>& points) {
  double largest = 0;
  for (const Vec2<double>& point : points) largest = std::max(largest, (point - points[0]).norm());
  return largest;
}

/// A link back along the one before has the same line on both of its sides.
void require_turn(const Vec2<double>& from, const Vec2<double>& corner, const Vec2<double>& to,
                  const std::string& field) {
  const Vec2<double> come = (corner - from).normalized(), go = (to - corner).normalized();
  require(std::abs(cross(come, go)) > shortest_link || come.dot(go) > 0, "chain", field,
          "a corner that does not turn straight back", chain_text(corner));
}

void require_far(const Vec2<double>& from, const Vec2<double>& to, double least, const std::string& field) {
  require((to - from).norm() > least, "chain", field,
          fmt::format("farther than {:.6g} m from the point beside it", least), chain_text(to));
}

/// The point behind the end of an open chain, whose link comes from `from`.
Vec2<double> ghost(const std::optional<Vec2<double>>& given, const Vec2<double>& from,
                   const Vec2<double>& end, double least, const std::string& field) {
  if (!given) return 2 * end - from;
  require_finite(*given, "chain", field, "m");
  require_far(end, *given, least, field);
  return *given;
}

}  // namespace

Chain<double> chain(const List<Vec2<double>>& points, const ChainEnds& ends) {
  const int count = points.size();
  const int fewest = ends.closed ? 3 : 2;
  require(count >= fewest, "chain", "number of points", fmt::format("at least {}", fewest), count);
  for (const int i : points.indices()) require_finite(points[i], "chain", fmt::format("points[{}]", i), "m");
  require(!(ends.closed && (ends.before || ends.after)), "chain", "closed",
          "false beside points before or after it", "true");
  Chain<double> result{.points = points, .closed = ends.closed};
  const double least = shortest_link * largest_reach(points);
  for (int i = 0; i < result.link_count(); ++i) {
    const int next = (i + 1) % count;
    require_far(points[i], points[next], least, fmt::format("points[{}]", next));
  }
  if (!ends.closed) {
    result.before = ghost(ends.before, points[1], points[0], least, "before");
    result.after = ghost(ends.after, points[count - 2], points[count - 1], least, "after");
  }
  for (const int i : points.indices()) {
    require_turn(result.point(i - 1), points[i], result.point(i + 1), fmt::format("points[{}]", i));
  }
  return result;
}

}  // namespace cairn
