// Floor 3. The weld joint's three rows.
#include <cairn/constraints/weld_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Rigid, or on a spring.
template <Scalar Real>
void add_row(const RigidRow<Real>& row, const std::optional<Softness>& softness, RowWriter<Real>& rows) {
  if (!softness) return rows.add(row);
  RowSpec<Real> soft = row;
  soft.softness = softness;
  rows.add(soft);
}

}  // namespace

WeldJoint::WeldJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : softness_(spec.softness), bending_(spec.bending) {
  require(spec.a != spec.b, "WeldJoint", "b", "another body than a", spec.b.index);
  require_finite(spec.anchor, "WeldJoint", "anchor", "m");
  for (const std::optional<Softness>& soft : {softness_, bending_})
    if (soft) require_softness(*soft, "WeldJoint");
  ends_ = {spec.a, spec.b, spec.anchor, spec.anchor, poses};
}

template <Scalar Real>
void WeldJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  for (const RigidRow<Real>& row : pin_rows(ends_.a, ends_.b, ends_.arms(at))) add_row(row, softness_, rows);
  add_row(angle_row(ends_.a, ends_.b, ends_.angle(at)), bending_, rows);
}

template <Scalar Real>
void WeldJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                        PerBody<Vec3<Real>>& stiffness) const {
  add_pin_stiffness(ends_.a, ends_.b, ends_.arms(at), pin_force(forces), stiffness);
}

template class ConstraintOf<WeldJoint>;

}  // namespace cairn
