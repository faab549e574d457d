// Floor 3. The revolute joint's two rows.
#include "constraints/revolute_joint.hpp"

#include "math/check.hpp"

namespace cairn {

RevoluteJoint::RevoluteJoint(const Spec& spec, std::span<const Pose<double>> poses) : a_(spec.a), b_(spec.b) {
  require(a_ != b_, "RevoluteJoint", "b", "another body than a", b_.index);
  require_finite(spec.anchor, "RevoluteJoint", "anchor", "m");
  local_a_ = poses[static_cast<std::size_t>(a_.index)].local(spec.anchor);
  local_b_ = poses[static_cast<std::size_t>(b_.index)].local(spec.anchor);
}

template <Scalar Real>
void RevoluteJoint::rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
  const Pose<Real>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<Real>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  const Vec2<Real> r_a = Rotation<Real>(pose_a.angle) * local_a_.template cast<Real>();
  const Vec2<Real> r_b = Rotation<Real>(pose_b.angle) * local_b_.template cast<Real>();
  const Vec2<Real> error = pose_b.position + r_b - pose_a.position - r_a;

  RowSpec<Real> x;
  x.a = a_;
  x.b = b_;
  x.error = error.x();
  x.jacobian_a = {-1, 0, r_a.y()};
  x.jacobian_b = {1, 0, -r_b.y()};
  x.part = 0;
  rows.push_back(x);

  RowSpec<Real> y = x;
  y.error = error.y();
  y.jacobian_a = {0, -1, -r_a.x()};
  y.jacobian_b = {0, 1, r_b.x()};
  y.part = 1;
  rows.push_back(y);
}

template void RevoluteJoint::rows(const std::vector<Pose<float>>&, RowSpecs<float>&) const;
template void RevoluteJoint::rows(const std::vector<Pose<double>>&, RowSpecs<double>&) const;
template void RevoluteJoint::rows(const std::vector<Pose<long double>>&, RowSpecs<long double>&) const;

}  // namespace cairn
