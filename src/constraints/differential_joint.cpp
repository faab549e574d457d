// Floor 3. The differential joint's one row.
#include <cairn/constraints/differential_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

DifferentialJoint::DifferentialJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : a_(spec.a), b_(spec.b), c_(spec.c) {
  require(a_ != b_, "DifferentialJoint", "b", "another body than a", b_.index);
  require(c_ != a_ && c_ != b_, "DifferentialJoint", "c", "another body than a and b", c_.index);
  start_ = poses[a_].angle + poses[b_].angle - 2 * poses[c_].angle;
}

template <Scalar Real>
void DifferentialJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  RowSpec<Real> row;
  row.a = a_;
  row.b = b_;
  row.error = at[a_].angle + at[b_].angle - 2 * at[c_].angle - static_cast<Real>(start_);
  row.jacobian_a = {0, 0, 1};
  row.jacobian_b = {0, 0, 1};
  row.extra[0] = {.body = c_, .jacobian = {0, 0, -2}};
  row.extra_count = 1;
  rows.add(row);
}

template class ConstraintOf<DifferentialJoint>;

}  // namespace cairn
