// Floor 3. The weld joint's three rows.
#include <cairn/constraints/weld_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

WeldJoint::WeldJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses) {
  require(spec.a != spec.b, "WeldJoint", "b", "another body than a", spec.b.index);
  require_finite(spec.anchor, "WeldJoint", "anchor", "m");
  ends_ = {spec.a, spec.b, spec.anchor, spec.anchor, poses};
}

template <Scalar Real>
void WeldJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  for (const RigidRow<Real>& row : pin_rows(ends_.a, ends_.b, ends_.arms(at))) rows.add(row);
  rows.add(angle_row(ends_.a, ends_.b, ends_.angle(at)));
}

template <Scalar Real>
void WeldJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                        PerBody<Vec3<Real>>& stiffness) const {
  add_pin_stiffness(ends_.a, ends_.b, ends_.arms(at), pin_force(forces), stiffness);
}

template class ConstraintOf<WeldJoint>;

}  // namespace cairn
