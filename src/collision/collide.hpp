// Floor 2. Narrowphase: the manifold of any two shapes.
#pragma once

#include <type_traits>

#include <cairn/collision/manifold.hpp>
#include <cairn/collision/neighbours.hpp>
#include <cairn/geometry/shape.hpp>

namespace cairn {

/// What lies beside two shapes: of one of them at most, as one of them moves. Null: nothing.
template <Scalar Real>
struct NeighboursOf {
  const Neighbours<Real>* a = nullptr;  // of the first shape
  const Neighbours<Real>* b = nullptr;  // of the second shape
};

/// The contact of two shapes of bodies in these frames: points whose separation is below `margin` [m] (>= 0).
/// Separation is exact for face-vertex, vertex-vertex and round contacts. collider_a and collider_b stay 0.
/// Of a chain it takes the links, each as a segment with its neighbours.
template <Scalar Real>
Manifold<Real> collide(const Shape<Real>& a, const std::type_identity_t<Frame<Real>>& frame_a,
                       const Shape<Real>& b, const std::type_identity_t<Frame<Real>>& frame_b, Real margin,
                       const std::type_identity_t<NeighboursOf<Real>>& around = {});

}  // namespace cairn
