// Floor 3. The prismatic joint's rows: two for the slide, and what its limits and motor need.
#include "constraints/prismatic_joint.hpp"

#include "math/check.hpp"

namespace cairn {

namespace {

/// C = direction . d, for a direction that turns with a.
template <Scalar Real>
RowSpec<Real> slide_row(BodyId a, BodyId b, const JointArms<Real>& arms, const Vec2<Real>& direction) {
  const Vec2<Real> arm_a = arms.r_a + arms.d;
  RowSpec<Real> row;
  row.a = a;
  row.b = b;
  row.error = direction.dot(arms.d);
  row.jacobian_a = {-direction.x(), -direction.y(), -cross(arm_a, direction)};
  row.jacobian_b = {direction.x(), direction.y(), cross(arms.r_b, direction)};
  return row;
}

}  // namespace

PrismaticJoint::PrismaticJoint(const Spec& spec, std::span<const Pose<double>> poses)
    : a_(spec.a),
      b_(spec.b),
      limits_{.lower = spec.lower, .upper = spec.upper, .margin = spec.limit_margin},
      motor_(spec.motor) {
  require(a_ != b_, "PrismaticJoint", "b", "another body than a", b_.index);
  require_finite(spec.anchor, "PrismaticJoint", "anchor", "m");
  require_finite(spec.axis, "PrismaticJoint", "axis", "m");
  const double length = spec.axis.stableNorm();
  require(length > 0 && std::isfinite(length), "PrismaticJoint", "axis", "of a finite length > 0 m", length);
  require_limits(limits_, "PrismaticJoint", "m");
  if (motor_) {
    require_finite(motor_->speed, "PrismaticJoint", "motor speed", "m/s");
    require(motor_->max_force > 0 && std::isfinite(motor_->max_force), "PrismaticJoint", "motor max_force",
            "a finite number > 0 N", motor_->max_force);
  }
  const Pose<double>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<double>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  local_a_ = pose_a.local(spec.anchor);
  local_b_ = pose_b.local(spec.anchor);
  local_axis_ = Rotation<double>(pose_a.angle).transposed_times(spec.axis / length);
  reference_angle_ = pose_b.angle - pose_a.angle;
}

template <Scalar Real>
void PrismaticJoint::rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
  const Pose<Real>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<Real>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  const JointArms<Real> arms = joint_arms(pose_a, pose_b, local_a_, local_b_);
  const Vec2<Real> u = Rotation<Real>(pose_a.angle) * local_axis_.template cast<Real>();

  // The last rows of a sweep are satisfied best: the slide itself comes after its motor and its limits.
  if (motor_ || limits_.lower || limits_.upper) {
    const RowSpec<Real> along = slide_row(a_, b_, arms, u);
    if (motor_) append_motor_row(along, motor_->speed, motor_->max_force, rows);
    append_limit_rows(along, limits_, rows);
  }
  RowSpec<Real> across = slide_row(a_, b_, arms, perpendicular(u));
  across.part = static_cast<std::uint64_t>(JointPart::y);
  rows.push_back(across);
  rows.push_back(angle_row(a_, b_, pose_b.angle - pose_a.angle - static_cast<Real>(reference_angle_)));
}

template void PrismaticJoint::rows(const std::vector<Pose<float>>&, RowSpecs<float>&) const;
template void PrismaticJoint::rows(const std::vector<Pose<double>>&, RowSpecs<double>&) const;
template void PrismaticJoint::rows(const std::vector<Pose<long double>>&, RowSpecs<long double>&) const;

}  // namespace cairn
