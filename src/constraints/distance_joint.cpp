// Floor 3. The distance joint's one row.
#include "constraints/distance_joint.hpp"

#include "math/check.hpp"

namespace cairn {

DistanceJoint::DistanceJoint(const Spec& spec, std::span<const Pose<double>> poses) : a_(spec.a), b_(spec.b) {
  require(a_ != b_, "DistanceJoint", "b", "another body than a", b_.index);
  require_finite(spec.anchor_a, "DistanceJoint", "anchor_a", "m");
  require_finite(spec.anchor_b, "DistanceJoint", "anchor_b", "m");
  local_a_ = poses[static_cast<std::size_t>(a_.index)].local(spec.anchor_a);
  local_b_ = poses[static_cast<std::size_t>(b_.index)].local(spec.anchor_b);
  require_finite(spec.length, "DistanceJoint", "length", "m");
  length_ = spec.length < 0 ? (spec.anchor_b - spec.anchor_a).norm() : spec.length;
  require(length_ > 0, "DistanceJoint", "length", "> 0 m", length_);
}

template <Scalar Real>
void DistanceJoint::rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
  const Pose<Real>& pose_a = poses[static_cast<std::size_t>(a_.index)];
  const Pose<Real>& pose_b = poses[static_cast<std::size_t>(b_.index)];
  const Vec2<Real> r_a = Rotation<Real>(pose_a.angle) * local_a_.template cast<Real>();
  const Vec2<Real> r_b = Rotation<Real>(pose_b.angle) * local_b_.template cast<Real>();
  const Vec2<Real> d = pose_b.position + r_b - pose_a.position - r_a;
  const Real distance = d.norm();
  if (!(distance > 0)) return;

  const Vec2<Real> u = d / distance;
  RowSpec<Real> row;
  row.a = a_;
  row.b = b_;
  row.error = distance - static_cast<Real>(length_);
  row.jacobian_a = {-u.x(), -u.y(), -cross(r_a, u)};
  row.jacobian_b = {u.x(), u.y(), cross(r_b, u)};
  rows.push_back(row);
}

template void DistanceJoint::rows(const std::vector<Pose<float>>&, RowSpecs<float>&) const;
template void DistanceJoint::rows(const std::vector<Pose<double>>&, RowSpecs<double>&) const;
template void DistanceJoint::rows(const std::vector<Pose<long double>>&, RowSpecs<long double>&) const;

}  // namespace cairn
