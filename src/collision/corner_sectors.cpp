// Floor 2. The free sectors around a corner at which solids meet.
#include <cairn/collision/corner_sectors.hpp>

#include <algorithm>

namespace cairn {

double within_turn(double angle) {
  const double rest = angle - 2 * pi * std::floor(angle / (2 * pi));
  return 2 * pi - rest <= same_angle ? 0 : rest;
}

void CornerSectors::add(double begin, double width) {
  // What nearly coincides with the hull's own sides coincides: no sliver of a neighbour covers them.
  const auto snapped = [this](double angle) {
    for (const double side : {0.0, own_, 2 * pi}) {
      if (std::abs(angle - side) <= same_angle) return side;
    }
    return angle;
  };
  const double from = snapped(within_turn(begin)), to = snapped(from + width);
  solid_.push_back({from, std::min(to, 2 * pi)});
  if (to > 2 * pi) solid_.push_back({0, snapped(to - 2 * pi)});
}

bool CornerSectors::is_alone() const {
  const List<FreeSector> sectors = free();
  return sectors.size() == 1 && sectors[0].begin == own_ && sectors[0].width == 2 * pi - own_;
}

List<FreeSector> CornerSectors::free() const {
  List<std::pair<double, double>> sorted = solid_;
  std::sort(sorted.begin(), sorted.end());
  List<FreeSector> sectors;
  double reached = 0;
  for (const auto& [from, to] : sorted) {
    if (from > reached) sectors.push_back({reached, from - reached});
    reached = std::max(reached, to);
  }
  if (reached < 2 * pi) sectors.push_back({reached, 2 * pi - reached});
  return sectors;
}

}  // namespace cairn
