// Floor 3. The friction joint's rows: two for sliding, one for turning.
#include <cairn/constraints/friction_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

void require_friction_limit(double value, const char* field, const char* rule) {
  require(value >= 0 && std::isfinite(value), "FrictionJoint", field, rule, value);
}

}  // namespace

FrictionJoint::FrictionJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : max_force_(spec.max_force), max_torque_(spec.max_torque), shape_(spec.shape) {
  require(spec.a != spec.b, "FrictionJoint", "b", "another body than a", spec.b.index);
  const Vec2<double> anchor = spec.anchor.value_or(poses[spec.b].position);
  require_finite(anchor, "FrictionJoint", "anchor", "m");
  require_friction_limit(max_force_, "max_force", "a finite number >= 0 N");
  require_friction_limit(max_torque_, "max_torque", "a finite number >= 0 N m");
  require(max_force_ > 0 || max_torque_ > 0, "FrictionJoint", "max_force", "> 0 N where max_torque is 0 N m",
          max_force_);
  ends_ = {spec.a, spec.b, anchor, anchor, poses};
}

/// To the anchor on b from both centres of mass: the point of a that it slides on is a new one in every step.
template <Scalar Real>
JointArms<Real> FrictionJoint::arms(const Placements<Real>& at) const {
  JointArms<Real> arms = ends_.arms(at);
  arms.r_a += arms.d;
  arms.d.setZero();
  return arms;
}

/// The first axis: along the sliding of b on a, where there is any.
template <Scalar Real>
Vec2<Real> FrictionJoint::first_axis(const JointArms<Real>& arms, const RowWriter<Real>& rows) const {
  if (shape_ == FrictionShape::square) return {1, 0};
  const Vec3<Real> v_a = rows.velocity(ends_.a), v_b = rows.velocity(ends_.b);
  const Vec2<Real> sliding =
      v_b.template head<2>() + cross(v_b.z(), arms.r_b) - v_a.template head<2>() - cross(v_a.z(), arms.r_a);
  const Real speed = sliding.norm();
  if (!(speed > 0)) return {1, 0};
  return sliding / speed;
}

template <Scalar Real>
void FrictionJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const JointArms<Real> to_anchor = arms(at);
  const auto axis_row = [&](const Vec2<Real>& axis, JointPart part) {
    RowSpec<Real> row;
    row.a = ends_.a;
    row.b = ends_.b;
    row.jacobian_a = {-axis.x(), -axis.y(), -cross(to_anchor.r_a, axis)};
    row.jacobian_b = {axis.x(), axis.y(), cross(to_anchor.r_b, axis)};
    row.max_force = static_cast<Real>(max_force_);
    row.part = static_cast<std::uint64_t>(part);
    return row;
  };
  if (max_force_ > 0) {
    const Vec2<Real> s = first_axis(to_anchor, rows);
    rows.add(axis_row(s, JointPart::x));
    RowSpec<Real> across = axis_row(perpendicular(s), JointPart::y);
    if (shape_ == FrictionShape::circle)
      across.bounds = Bounds<Real>::rest_of_disc(static_cast<Real>(max_force_), 0);
    rows.add(across);
  }
  if (max_torque_ > 0) add_motor_row(angle_row<Real>(ends_.a, ends_.b, 0), {.max_force = max_torque_}, rows);
}

template class ConstraintOf<FrictionJoint>;

}  // namespace cairn
