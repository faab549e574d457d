// Floor 2. When two shapes that move come near each other.
#pragma once

#include <limits>
#include <type_traits>

#include <cairn/geometry/shape.hpp>

namespace cairn {

/// A body that goes straight on, and turns as it does, and what its turning moves of a shape.
template <Scalar Real>
struct Course {
  Pose<Real> pose = {};                      // of its centre of mass now
  Vec3<Real> velocity = Vec3<Real>::Zero();  // [m/s, m/s, rad/s]
  Real radius = 0;                           // [m] of a circle about that centre around the shape's core
  const Frame<Real>* frame = nullptr;        // of the pose, where somebody knows it: it must outlive this

  /// Where it is after `time` [s].
  Frame<Real> at(Real time) const;
};

/// When two shapes are near, and how far apart they are then.
template <Scalar Real>
struct Approach {
  Real time = 0;                           // [s] from now
  Real separation = 0;                     // [m] of their surfaces; negative in overlap
  Vec2<Real> normal = Vec2<Real>::Zero();  // unit, from a to b: along which they are so far apart
};

/// The first time within `time` [s] at which the two are no more than `near` [m] (> 0) apart. If there is
/// none, `time`, or one at which they part, or one from which they surely stay more than `far` [m] apart; far
/// is at least near, and the separation may then be less than it is. By conservative advancement along the
/// line between the nearest points, which is Newton's method where nothing turns (B. Mirtich, Impulse-based
/// Dynamic Simulation, 1996).
template <Scalar Real>
Approach<Real> approach(const Shape<Real>& a, const std::type_identity_t<Course<Real>>& course_a,
                        const Shape<Real>& b, const std::type_identity_t<Course<Real>>& course_b, Real time,
                        Real near, Real far = std::numeric_limits<Real>::infinity());

/// [m] How far two shapes are apart along a unit direction from a to b: no more than their surfaces are.
template <Scalar Real>
Real gap_along(const Vec2<Real>& direction, const Shape<Real>& a,
               const std::type_identity_t<Frame<Real>>& frame_a, const Shape<Real>& b,
               const std::type_identity_t<Frame<Real>>& frame_b);

}  // namespace cairn
