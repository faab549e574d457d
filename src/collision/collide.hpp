// Floor 2. Narrowphase: the manifold of any two shapes.
#pragma once

#include <type_traits>

#include "collision/manifold.hpp"
#include "geometry/shape.hpp"

namespace cairn {

/// The contact of two shapes of bodies in these frames: points whose separation is below `margin` [m] (>= 0).
/// Separation is exact for face-vertex, vertex-vertex and round contacts. collider_a and collider_b stay 0.
template <Scalar Real>
Manifold<Real> collide(const Shape<Real>& a, const std::type_identity_t<Frame<Real>>& frame_a,
                       const Shape<Real>& b, const std::type_identity_t<Frame<Real>>& frame_b, Real margin);

}  // namespace cairn
