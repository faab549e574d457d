// Floor 3. The gear joint's one row.
#include <cairn/constraints/gear_joint.hpp>

#include <cmath>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

void require_radius(double radius, const char* field) {
  require(radius > 0 && std::isfinite(radius), "GearJoint", field, "> 0 m and finite", radius);
}

/// r_b with its sign.
double lever_of(const GearJoint::Spec& spec) {
  if (spec.mesh == GearJoint::Mesh::rack) return 0;
  return spec.mesh == GearJoint::Mesh::external ? spec.radius_b : -spec.radius_b;
}

}  // namespace

GearJoint::GearJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : a_(spec.a),
      b_(spec.b),
      c_(spec.c),
      lever_a_(spec.radius_a),
      lever_b_(lever_of(spec)),
      is_rack_(spec.mesh == Mesh::rack) {
  require(a_ != b_, "GearJoint", "b", "another body than a", b_.index);
  require(c_ != a_ && c_ != b_, "GearJoint", "c", "another body than a and b", c_.index);
  require_radius(spec.radius_a, "radius_a");
  require_radius(spec.radius_b, "radius_b");
  require_finite(spec.axis, "GearJoint", "axis", "m");
  const double length = spec.axis.stableNorm();
  require(length > 0 && std::isfinite(length), "GearJoint", "axis", "of a finite length > 0 m", length);
  local_axis_ = Rotation<double>(poses[c_].angle).transposed_times(spec.axis / length);
  const auto placed = [&](BodyId body) {
    const Pose<double>& pose = poses[body];
    return Placement<double>{pose.position, pose.angle, Rotation<double>(pose.angle)};
  };
  start_ = 0;
  start_ = rolled_length(placed(a_), placed(b_), placed(c_));
}

/// C.
template <Scalar Real>
Real GearJoint::rolled_length(const Placement<Real>& a, const Placement<Real>& b,
                              const Placement<Real>& c) const {
  const Real lever_a = static_cast<Real>(lever_a_), lever_b = static_cast<Real>(lever_b_);
  const Real turned = lever_a * (a.angle - c.angle) + lever_b * (b.angle - c.angle);
  if (!is_rack_) return turned - static_cast<Real>(start_);
  const Vec2<Real> u = c.rotation * local_axis_.template cast<Real>();
  return turned - u.dot(b.position - c.position) - static_cast<Real>(start_);
}

template <Scalar Real>
void GearJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const Real lever_a = static_cast<Real>(lever_a_), lever_b = static_cast<Real>(lever_b_);
  RowSpec<Real> row;
  row.a = a_;
  row.b = b_;
  const Placement<Real> b = at[b_], c = at[c_];
  row.error = rolled_length(at[a_], b, c);
  row.jacobian_a = {0, 0, lever_a};
  row.jacobian_b = {0, 0, lever_b};
  Vec3<Real> of_carrier = {0, 0, -lever_a - lever_b};
  if (is_rack_) {
    const Vec2<Real> u = c.rotation * local_axis_.template cast<Real>();
    row.jacobian_b.template head<2>() = -u;
    of_carrier.template head<2>() = u;
    of_carrier.z() += cross<Real>(b.position - c.position, u);
  }
  if (c_ != ground) {
    row.extra[0] = {.body = c_, .jacobian = of_carrier};
    row.extra_count = 1;
  }
  rows.add(row);
}

/// C is linear in angles. The line of a rack turns with the carrier.
template <Scalar Real>
void GearJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                        PerBody<Vec3<Real>>& stiffness) const {
  if (!is_rack_ || c_ == ground) return;
  const Placement<Real> c = at[c_];
  const Vec2<Real> u = c.rotation * local_axis_.template cast<Real>();
  stiffness[c_].z() += std::abs(forces.of(0) * u.dot(at[b_].position - c.position));
}

template class ConstraintOf<GearJoint>;

}  // namespace cairn
