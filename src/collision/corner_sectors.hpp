// Floor 2. The free sectors around a corner at which solids meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <cairn/collision/neighbours.hpp>

namespace cairn {

/// Angles that differ by less are one [rad]: what rounding leaves of positions that were meant to be level.
inline constexpr double same_angle = 1e-6;

/// The way along one surface, away from a corner, and counter-clockwise around what is free to the next one.
struct FreeSector {
  double begin = 0;  // [rad]
  double width = 0;  // [rad] from 0 to a whole turn

  /// Whether a convex body can touch its corner.
  bool is_open() const { return width >= pi - same_angle; }
};

/// The normals that may stand on the corner of an open sector.
template <Scalar Real>
NormalCone<Real> cone_of(const FreeSector& sector) {
  const bool is_level = sector.width <= pi + same_angle;
  const double from = sector.begin + (is_level ? sector.width / 2 : pi / 2);
  const double to = is_level ? from : sector.begin + sector.width - pi / 2;
  const auto direction = [](double angle) {
    return Vec2<Real>(static_cast<Real>(cosine(angle)), static_cast<Real>(sine(angle)));
  };
  return {direction(from), direction(to)};
}

/// How a face goes on at a corner beside which the sector is free.
template <Scalar Real>
FaceEnd<Real> end_of(const FreeSector& sector) {
  using Kind = typename FaceEnd<Real>::Kind;
  if (sector.is_open()) return {.kind = Kind::neighbour};
  return {.kind = Kind::valley, .rise = static_cast<Real>(sine(std::max(sector.width, pi / 2)))};
}

/// What solids leave free around a corner. Angles are counter-clockwise from the hull's own face that begins
/// at the corner.
class CornerSectors {
 public:
  /// Of a hull with its solid in the sector from angle 0 to `own` [rad].
  explicit CornerSectors(double own) : own_(own) { solid_.push_back({0, own}); }

  /// Another solid, in the sector from `begin` on [rad].
  void add(double begin, double width);
  /// There is no way around the corner.
  void fill() { solid_.push_back({0, 2 * pi}); }
  /// Whether the hull's own two sides bound all that is free.
  bool is_alone() const;
  /// What is free, from the hull's own sector on.
  List<FreeSector> free() const;
  /// Where the hull's own sector ends [rad].
  double own() const { return own_; }

 private:
  double own_;                             // [rad]
  List<std::pair<double, double>> solid_;  // from, to [rad], within one turn
};

/// An angle from 0 on, and less than a turn; what is a rounding error short of a turn is 0.
double within_turn(double angle);

}  // namespace cairn
