// Floor 5. Where paths lead.
#include <cairn/world/lasting_action.hpp>

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

/// [m] Of the points as they come.
double sum_of_legs(const List<Vec2<double>>& points) {
  double sum = 0;
  for (int i = 0; i + 1 < points.size(); ++i) sum += (points[i + 1] - points[i]).norm();
  return sum;
}

double way_back(const FollowPath& path) { return (path.points.front() - path.points.back()).norm(); }

}  // namespace

double FollowPath::length() const {
  const double there = sum_of_legs(points);
  if (kind == PathKind::to_and_fro) return 2 * there;
  return kind == PathKind::round ? there + way_back(*this) : there;
}

Vec2<double> FollowPath::place(double seconds) const {
  const double whole = length(), gone = std::max(0.0, speed * seconds);
  double left = kind == PathKind::once ? std::min(gone, whole) : std::fmod(gone, whole);
  if (kind == PathKind::to_and_fro) left = std::min(left, whole - left);
  for (int i = 0; i < points.size(); ++i) {
    const Vec2<double>& next = points[(i + 1) % points.size()];
    const double leg = (next - points[i]).norm();
    const bool is_last = i + 1 == points.size() || (kind != PathKind::round && i + 2 == points.size());
    if (left > leg && !is_last) {
      left -= leg;
      continue;
    }
    return leg > 0 ? Vec2<double>(points[i] + std::min(left / leg, 1.0) * (next - points[i])) : points[i];
  }
  return points.back();
}

}  // namespace cairn
