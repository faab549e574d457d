// Floor 2. A manifold that moves with its two bodies, so that it need not be found anew.
#pragma once

#include "collision/manifold.hpp"
#include "math/list.hpp"

namespace cairn {

/// A manifold in the frames of its two bodies. The face that it lies on, if it lies on one, turns with the
/// body that the face belongs to, and each point stays at the same place of the other body's core: so the
/// separations of corners, discs and capsules over a face are exact for any motion, as long as what touches
/// is the same, and so are those between two corners or discs. What is not seen is a change of the features
/// that touch, and how a face that is cut to the width of another slides along it: an error of the second
/// order in how far the bodies have moved beside each other.
template <Scalar Real>
class KeptManifold {
 public:
  KeptManifold() = default;
  /// Of bodies in these frames; the radii [m] are by how much the shapes' cores are rounded.
  KeptManifold(const Manifold<Real>& manifold, const Frame<Real>& frame_a, Real radius_a,
               const Frame<Real>& frame_b, Real radius_b);

  /// The manifold where the bodies are now: points whose separation is below `margin` [m].
  Manifold<Real> at(const Frame<Real>& frame_a, const Frame<Real>& frame_b, Real margin) const;
  /// How many points it has, near or not.
  int count() const { return count_; }

 private:
  /// Which body the normal turns with.
  enum class Face : std::uint8_t { of_a, of_b, none };

  struct Point {
    Vec2<Real> core_a = Vec2<Real>::Zero();  // [m] in the frame of a
    Vec2<Real> core_b = Vec2<Real>::Zero();  // [m] in the frame of b
    std::uint32_t feature = 0;
  };

  FixedList<Point, 2> points_ = {};
  Vec2<Real> normal_ = Vec2<Real>::Zero();  // in the frame of the body whose face it is, else in that of a
  Real radius_a_ = 0;                       // [m]
  Real radius_b_ = 0;                       // [m]
  Face face_ = Face::none;
  std::uint8_t count_ = 0;
};

}  // namespace cairn
