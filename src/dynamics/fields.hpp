// Floor 2. Fields: what acts on every body of a scene, wherever it is.
#pragma once

#include <optional>

#include <cairn/math/list.hpp>
#include <cairn/math/math.hpp>

namespace cairn {

/// Pulls every dynamic body towards a point with the acceleration strength / r^2, as a heavy star does
/// (Newton 1687). Within `radius` it falls off in proportion to r, as within a star of even density.
struct Attraction {
  Vec2<double> point = {0, 0};  // [m] in the world
  double strength = 0;          // [m^3/s^2] G M; negative: pushes away
  double radius = 0;            // [m]

  /// Member by member.
  bool operator==(const Attraction&) const = default;
};

/// Fills all that is below a level, as gravity sees it. It carries what it displaces (Archimedes): the force
/// is density times gravity times the area below the level, against gravity, at the middle of that area. What
/// moves through it is slowed: every part of that area by drag times density times its velocity against the
/// water.
struct Water {
  double level = 0;            // [m] along the direction against gravity; along y where there is none
  double density = 1;          // [kg/m^2]
  double drag = 0;             // [1/s] how fast a body of the density of water loses velocity
  Vec2<double> flow = {0, 0};  // [m/s] its own velocity

  /// Member by member.
  bool operator==(const Water&) const = default;
};

/// All of them.
struct Fields {
  Vec2<double> wind = {0, 0};         // [m/s] the velocity of the air: Damping::quadratic is against it
  std::optional<Water> water = {};    // none: there is none
  List<Attraction> attractions = {};  // of fixed points
  /// [m^3/(kg s^2)] G: every two dynamic bodies attract each other with G m_a m_b / r^2. Nearer than discs of
  /// their areas would touch, it falls off in proportion to r.
  double gravitation = 0;

  /// Member by member.
  bool operator==(const Fields&) const = default;
};

/// Of length 1: against gravity, or along y where there is none.
inline Vec2<double> up_direction(const Vec2<double>& gravity) {
  const double size = gravity.norm();
  return size > 0 ? Vec2<double>(-gravity / size) : Vec2<double>(0, 1);
}

/// The acceleration [m/s^2] towards what is `way` [m] off. @param radius as Attraction::radius
inline Vec2<double> attraction(const Vec2<double>& way, double strength, double radius) {
  const double r = std::max(way.norm(), radius);
  return r > 0 ? Vec2<double>(strength / (r * r) / r * way) : Vec2<double>(0, 0);
}

/// Its potential [m^2/s^2], 0 far away.
inline double attraction_potential(const Vec2<double>& way, double strength, double radius) {
  const double r = way.norm();
  if (r >= radius) return r > 0 ? -strength / r : 0;
  return -strength * (3 - r * r / (radius * radius)) / (2 * radius);
}

}  // namespace cairn
