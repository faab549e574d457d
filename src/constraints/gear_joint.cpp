// Floor 3. The gear joint's one row.
#include <cairn/constraints/gear_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// The length that two wheels have rolled off on each other, with the angles as they stand.
template <Scalar Real>
Real rolled_length(Real lever_a, Real lever_b, Real angle_a, Real angle_b, Real angle_c) {
  return lever_a * (angle_a - angle_c) + lever_b * (angle_b - angle_c);
}

void require_radius(double radius, const char* field) {
  require(radius > 0 && std::isfinite(radius), "GearJoint", field, "> 0 m and finite", radius);
}

}  // namespace

GearJoint::GearJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : a_(spec.a),
      b_(spec.b),
      c_(spec.c),
      lever_a_(spec.radius_a),
      lever_b_(spec.mesh == Mesh::external ? spec.radius_b : -spec.radius_b) {
  require(a_ != b_, "GearJoint", "b", "another body than a", b_.index);
  require(c_ != a_ && c_ != b_, "GearJoint", "c", "another body than a and b", c_.index);
  require_radius(spec.radius_a, "radius_a");
  require_radius(spec.radius_b, "radius_b");
  start_ = rolled_length(lever_a_, lever_b_, poses[a_].angle, poses[b_].angle, poses[c_].angle);
}

template <Scalar Real>
void GearJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const Real lever_a = static_cast<Real>(lever_a_);
  const Real lever_b = static_cast<Real>(lever_b_);
  RowSpec<Real> row;
  row.a = a_;
  row.b = b_;
  row.error =
      rolled_length(lever_a, lever_b, at[a_].angle, at[b_].angle, at[c_].angle) - static_cast<Real>(start_);
  row.jacobian_a = {0, 0, lever_a};
  row.jacobian_b = {0, 0, lever_b};
  if (c_ != ground) {
    row.extra[0] = {.body = c_, .jacobian = {0, 0, -lever_a - lever_b}};
    row.extra_count = 1;
  }
  rows.add(row);
}

template class ConstraintOf<GearJoint>;

}  // namespace cairn
