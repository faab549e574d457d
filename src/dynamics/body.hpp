// Floor 2. Bodies: who they are, and their state as the paper's v (1) and the diagonal of M^-1 (2).
#pragma once

#include <cstdint>

#include <compare>

#include <cairn/math/list.hpp>
#include <cairn/math/math.hpp>

namespace cairn {

/// A body's place in every array of bodies. Body 0 is the ground, which never moves.
struct BodyId {
  int index = 0;  // from 0, the ground
  /// By index.
  auto operator<=>(const BodyId&) const = default;
};

/// Where a body stands in an array.
constexpr std::ptrdiff_t place_of(BodyId body) { return body.index; }

/// One element for each body, the ground first.
template <typename T>
using PerBody = IndexedVector<T, BodyId>;
/// A view of one.
template <typename T>
using PerBodySpan = IndexedSpan<T, BodyId>;

/// Body 0.
inline constexpr BodyId ground = {0};

/// static_body: never moves. kinematic: moves with a given velocity that nothing changes. dynamic: obeys
/// forces.
enum class BodyType { static_body, kinematic, dynamic };

/// With which others a body collides.
struct CollisionFilter {
  std::uint32_t category = 1;         // bits: what it is
  std::uint32_t collides_with = ~0u;  // bits: of which categories both must accept the other's
  /// In the frame of a static or kinematic body, of any length: only what comes from where it points to is
  /// held off, and what comes from elsewhere passes. Zero: everything is held off.
  Vec2<double> one_way = {0, 0};

  /// Member by member.
  bool operator==(const CollisionFilter&) const = default;
};

/// Whether bodies with these filters may touch: neither has excluded the other's category.
inline bool may_touch(const CollisionFilter& a, const CollisionFilter& b) {
  return (a.category & b.collides_with) != 0 && (b.category & a.collides_with) != 0;
}

/// Parallel arrays over all bodies; planar, so three numbers a body where the paper has six.
template <Scalar Real>
struct BodyState {
  PerBody<Pose<Real>> pose;          // of centres of mass [m, rad]
  PerBody<Vec3<Real>> velocity;      // [m/s, m/s, rad/s]; eq. (1)
  PerBody<Vec3<Real>> inverse_mass;  // [1/kg, 1/kg, 1/(kg m^2)]; the diagonal of eq. (2); 0: cannot be moved
};

}  // namespace cairn
