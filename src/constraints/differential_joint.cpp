// Floor 3. The differential joint's one row.
#include "constraints/differential_joint.hpp"

#include "math/check.hpp"

namespace cairn {

DifferentialJoint::DifferentialJoint(const Spec& spec, std::span<const Pose<double>> poses)
    : a_(spec.a), b_(spec.b), c_(spec.c) {
  require(a_ != b_, "DifferentialJoint", "b", "another body than a", b_.index);
  require(c_ != a_ && c_ != b_, "DifferentialJoint", "c", "another body than a and b", c_.index);
  start_ = poses[static_cast<std::size_t>(a_.index)].angle + poses[static_cast<std::size_t>(b_.index)].angle -
           2 * poses[static_cast<std::size_t>(c_.index)].angle;
}

template <Scalar Real>
void DifferentialJoint::rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const {
  RowSpec<Real> row;
  row.a = a_;
  row.b = b_;
  row.error = poses[static_cast<std::size_t>(a_.index)].angle +
              poses[static_cast<std::size_t>(b_.index)].angle -
              2 * poses[static_cast<std::size_t>(c_.index)].angle - static_cast<Real>(start_);
  row.jacobian_a = {0, 0, 1};
  row.jacobian_b = {0, 0, 1};
  row.extra[0] = {.body = c_, .jacobian = {0, 0, -2}};
  row.extra_count = 1;
  rows.push_back(row);
}

template void DifferentialJoint::rows(const std::vector<Pose<float>>&, RowSpecs<float>&) const;
template void DifferentialJoint::rows(const std::vector<Pose<double>>&, RowSpecs<double>&) const;
template void DifferentialJoint::rows(const std::vector<Pose<long double>>&, RowSpecs<long double>&) const;

}  // namespace cairn
