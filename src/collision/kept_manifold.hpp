// Floor 2. A manifold that moves with its two bodies, so that it need not be found anew.
#pragma once

#include <cairn/collision/manifold.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// A manifold in the frames of its two bodies. The face that it lies on, if it lies on one, turns with the
/// body that the face belongs to, and each point stays at the same place of the other body's core: so the
/// separations of corners, discs and capsules over a face are exact for any motion, as long as what touches
/// is the same, and so are those between two corners or discs. What is not seen is a change of the features
/// that touch, and how a face that is cut to the width of another slides along it: an error of the second
/// order in how far the bodies have moved beside each other.
template <Scalar Real>
struct KeptManifold {
  /// Which body's face the points lie on: the normal turns with it.
  enum class Face : std::uint8_t {
    of_a,
    of_b,
    none,  // the normal goes from core to core
  };
  /// A point in the frames of both bodies.
  struct Point {
    Vec2<Real> core_a = Vec2<Real>::Zero();  // [m] in the frame of a
    Vec2<Real> core_b = Vec2<Real>::Zero();  // [m] in the frame of b
  };

  FixedList<Point, 2> points = {};           // the first `count` of them are in use
  Vec2<Real> normal = Vec2<Real>::Zero();    // in the frame of the body whose face it is, else in that of a
  Real radius_a = 0;                         // [m] by which the core of a is rounded
  Real radius_b = 0;                         // [m] by which the core of b is rounded
  FixedList<std::uint32_t, 2> feature = {};  // of each point, as in the manifold
  Face face = Face::none;                    // that the points lie on
  std::uint8_t count = 0;                    // of points, near or not

  /// The manifold where the bodies are now: points whose separation is below `margin` [m].
  Manifold<Real> at(const Frame<Real>& frame_a, const Frame<Real>& frame_b, Real margin) const;
};

/// A manifold of bodies in these frames; the radii [m] are by how much the shapes' cores are rounded.
template <Scalar Real>
KeptManifold<Real> keep(const Manifold<Real>& manifold, const Frame<Real>& frame_a, Real radius_a,
                        const Frame<Real>& frame_b, Real radius_b);

}  // namespace cairn
