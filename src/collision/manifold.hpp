// Floor 2. What the narrowphase finds out about two shapes that touch or nearly touch.
#pragma once

#include <cstdint>

#include <cairn/dynamics/body.hpp>
#include <cairn/math/math.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// One point of contact.
template <Scalar Real>
struct ManifoldPoint {
  Vec2<Real> position = Vec2<Real>::Zero();  // [m], world; midway between the two surfaces
  Real separation = 0;                       // [m], along the normal; negative in overlap
  std::uint32_t feature = 0;                 // which features touch: the same number in the next step
};

/// Which features touch: a face of one hull and a vertex of the other, or two corners.
enum class FeatureKind : std::uint32_t { face_of_a = 0, face_of_b = 1, corners = 2 };

/// The id of two features: each the number of a face or a vertex.
constexpr std::uint32_t feature_id(FeatureKind kind, int first, int second) {
  return static_cast<std::uint32_t>(kind) << 16 | static_cast<std::uint32_t>(first) << 8 |
         static_cast<std::uint32_t>(second);
}
/// The kind that an id was made of.
constexpr FeatureKind feature_kind(std::uint32_t feature) { return FeatureKind{feature >> 16}; }

/// Up to two points that share a normal. All points of a manifold lie at one height along the normal (the
/// mean of their mid-points), so that their tangent rows are exactly equal and never contradict each other.
template <Scalar Real>
struct Manifold {
  int collider_a = 0;                      // indices into the world's colliders, collider_a < collider_b
  int collider_b = 0;                      // the higher one
  int count = 0;                           // 0: apart by more than the margin
  Vec2<Real> normal = Vec2<Real>::Zero();  // unit, from a to b
  FixedList<ManifoldPoint<Real>, 2> points = {};  // the first `count` of them are in use
};

}  // namespace cairn
