// Floor 5. What the bodies of a world have from its scene, and what acts on them besides constraints.
#pragma once

#include <cairn/dynamics/integrate.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What a body has from its scene, and never changes.
template <Scalar Real>
struct BodyTraits {
  Real slop_limit = 0;          // [m] a share of the smallest shape
  Real failed_error = 0;        // [m] likewise: deeper in another, it is on its way through
  double friction_root = 0;     // sqrt(mu): a pair's mu is the product of two
  Real surface_speed = 0;       // [m/s]
  Real rolling_resistance = 0;  // [m]
  Real radius = 0;              // [m] of a circle around all shapes, about the centre of mass

  /// Member by member.
  bool operator==(const BodyTraits&) const = default;
};

/// Bodies that are alike share their traits and forces.
template <Scalar Real>
class BodyKinds {
 public:
  /// Those of the next body.
  void add(const BodyForces<Real>& forces, const BodyTraits<Real>& traits);
  /// Those of a body.
  const BodyTraits<Real>& operator[](BodyId body) const { return traits_[kind_[body]]; }
  /// [m/s] Of all bodies.
  void copy_surface_speeds(PerBody<Real>& speeds) const {
    speeds.clear();
    for (const int kind : kind_) speeds.push_back(traits_[kind].surface_speed);
  }
  /// [m] Of all bodies.
  void copy_rolling_resistances(PerBody<Real>& resistances) const {
    resistances.clear();
    for (const int kind : kind_) resistances.push_back(traits_[kind].rolling_resistance);
  }
  /// As apply_gravity().
  void pull(PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass, const Vec2<Real>& gravity,
            Real time) const {
    apply_gravity(velocity, inverse_mass, kind_, forces_, gravity, time);
  }
  /// As apply_damping().
  void damp(PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass, Real time) const {
    apply_damping(velocity, inverse_mass, kind_, forces_, time);
  }

 private:
  PerBody<int> kind_;  // of a body: its place in the next two
  List<BodyForces<Real>> forces_;
  List<BodyTraits<Real>> traits_;
};

}  // namespace cairn
