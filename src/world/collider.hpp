// Floor 5. The pieces in which a scene's shapes collide.
#pragma once

#include <memory>

#include <cairn/collision/neighbours.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// What colliders that are alike share.
template <Scalar Real>
struct ColliderForm {
  Real radius = 0;       // [m] of a circle around it, about the body's centre of mass
  Real core_radius = 0;  // [m] by which its core is rounded
  /// In the frame of the body's centre of mass; no chain.
  std::shared_ptr<const Shape<Real>> shape = {};
  std::shared_ptr<const Neighbours<Real>> around = {};  // what lies beside it; null: nothing
};

/// A shape of a body, or a link of one that is a chain.
template <Scalar Real>
struct Collider {
  BodyId body = {};                                     // whose it is
  std::shared_ptr<const ColliderForm<Real>> form = {};  // one for all whose shapes are equal
};

/// In the order of bodies, their shapes, and links. Static shapes have the neighbours that collide with the
/// same bodies as they do; shapes of a kinematic body, links of a chain, and pieces of an outline have each
/// other.
template <Scalar Real>
List<Collider<Real>> make_colliders(const Scene& scene);

}  // namespace cairn
