// Floor 2. Narrowphase: the manifold of any two shapes.
#pragma once

#include "collision/manifold.hpp"
#include "geometry/shape.hpp"

namespace cairn {

/// The contact of two shapes at two poses: points whose separation is below `margin` [m] (>= 0).
/// Separation is exact for face-vertex, vertex-vertex and round contacts. collider_a and collider_b stay 0.
template <Scalar Real>
Manifold<Real> collide(const Shape<Real>& a, const Pose<Real>& pose_a, const Shape<Real>& b,
                       const Pose<Real>& pose_b, Real margin);

}  // namespace cairn
