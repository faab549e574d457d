// Floor 3. The weld joint's three rows.
#include "constraints/weld_joint.hpp"

#include "constraints/joint_rows.hpp"
#include "math/check.hpp"

namespace cairn {

WeldJoint::WeldJoint(const Spec& spec, std::span<const Pose<double>> poses) : a_(spec.a), b_(spec.b) {
  require(a_ != b_, "WeldJoint", "b", "another body than a", b_.index);
  require_finite(spec.anchor, "WeldJoint", "anchor", "m");
  const Pose<double>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<double>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  local_a_ = pose_a.local(spec.anchor);
  local_b_ = pose_b.local(spec.anchor);
  reference_angle_ = pose_b.angle - pose_a.angle;
}

template <Scalar Real>
void WeldJoint::rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
  const Pose<Real>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<Real>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  append_pin_rows(a_, b_, joint_arms(pose_a, pose_b, local_a_, local_b_), rows);
  rows.push_back(angle_row(a_, b_, pose_b.angle - pose_a.angle - static_cast<Real>(reference_angle_)));
}

template void WeldJoint::rows(const std::vector<Pose<float>>&, RowSpecs<float>&) const;
template void WeldJoint::rows(const std::vector<Pose<double>>&, RowSpecs<double>&) const;
template void WeldJoint::rows(const std::vector<Pose<long double>>&, RowSpecs<long double>&) const;

}  // namespace cairn
