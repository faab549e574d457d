// Floor 2. Semi-implicit Euler: velocities first, then positions with the new velocities.
#pragma once

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What acts on one body besides constraints.
template <Scalar Real>
struct BodyForces {
  Real gravity_scale = 1;    // how many times the gravity of the scene it feels
  Real linear_damping = 0;   // [1/s]
  Real angular_damping = 0;  // [1/s]

  /// Member by member.
  bool operator==(const BodyForces&) const = default;
};

/// v += dt g for every body that forces can move (inverse mass > 0): the left half of (12). dt [s]. What acts
/// on a body is that of its kind: forces[kind[body]].
template <Scalar Real>
void apply_gravity(PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass,
                   const PerBody<int>& kind, const List<BodyForces<Real>>& forces, const Vec2<Real>& gravity,
                   Real dt);

/// v /= 1 + c dt: damping by implicit Euler, so that no step turns a velocity around.
template <Scalar Real>
void apply_damping(PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass,
                   const PerBody<int>& kind, const List<BodyForces<Real>>& forces, Real dt);

/// x += dt v for every body, kinematic ones too.
template <Scalar Real>
void integrate_positions(BodyState<Real>& state, Real dt);

}  // namespace cairn
