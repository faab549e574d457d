// Floor 3. The revolute joint's rows: two for the pin, and what its limits and motor need.
#include "constraints/revolute_joint.hpp"

#include "math/check.hpp"

namespace cairn {

RevoluteJoint::RevoluteJoint(const Spec& spec, std::span<const Pose<double>> poses)
    : a_(spec.a),
      b_(spec.b),
      limits_{.lower = spec.lower, .upper = spec.upper, .margin = spec.limit_margin},
      motor_(spec.motor) {
  require(a_ != b_, "RevoluteJoint", "b", "another body than a", b_.index);
  require_finite(spec.anchor, "RevoluteJoint", "anchor", "m");
  require_limits(limits_, "RevoluteJoint", "rad");
  if (motor_) {
    require_finite(motor_->speed, "RevoluteJoint", "motor speed", "rad/s");
    require(motor_->max_torque > 0 && std::isfinite(motor_->max_torque), "RevoluteJoint", "motor max_torque",
            "a finite number > 0 N m", motor_->max_torque);
  }
  const Pose<double>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<double>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  local_a_ = pose_a.local(spec.anchor);
  local_b_ = pose_b.local(spec.anchor);
  reference_angle_ = pose_b.angle - pose_a.angle;
}

template <Scalar Real>
void RevoluteJoint::rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
  const Pose<Real>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<Real>& pose_b = poses[static_cast<std::size_t>(b_.index)];

  // The last rows of a sweep are satisfied best: the pin itself comes after its motor and its limits.
  if (motor_ || limits_.lower || limits_.upper) {
    const Real angle = pose_b.angle - pose_a.angle - static_cast<Real>(reference_angle_);
    const RowSpec<Real> turn = angle_row(a_, b_, angle);
    if (motor_) append_motor_row(turn, motor_->speed, motor_->max_torque, rows);
    append_limit_rows(turn, limits_, rows);
  }
  append_pin_rows(a_, b_, joint_arms(pose_a, pose_b, local_a_, local_b_), rows);
}

template void RevoluteJoint::rows(const std::vector<Pose<float>>&, RowSpecs<float>&) const;
template void RevoluteJoint::rows(const std::vector<Pose<double>>&, RowSpecs<double>&) const;
template void RevoluteJoint::rows(const std::vector<Pose<long double>>&, RowSpecs<long double>&) const;

}  // namespace cairn
