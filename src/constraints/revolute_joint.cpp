// Floor 3. The revolute joint's rows: two for the pin, and what its limits and motor need.
#include <cairn/constraints/revolute_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

RevoluteJoint::RevoluteJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses) {
  require(spec.a != spec.b, "RevoluteJoint", "b", "another body than a", spec.b.index);
  require_finite(spec.anchor, "RevoluteJoint", "anchor", "m");
  std::optional<JointMotor> motor;
  if (spec.motor) motor = {spec.motor->speed, spec.motor->max_torque, spec.motor->target, spec.motor->rate};
  const JointLimits limits{.lower = spec.lower, .upper = spec.upper, .margin = spec.limit_margin};
  turn_ = JointCoordinate(limits, motor, spec.spring, spec.ratchet, "RevoluteJoint", "rad");
  ends_ = {spec.a, spec.b, spec.anchor, spec.anchor, poses};
}

std::shared_ptr<const Constraint> RevoluteJoint::with_motor(const std::optional<JointMotor>& motor) const {
  auto other = std::make_shared<RevoluteJoint>(*this);
  other->turn_.change(motor);
  return other;
}

template <Scalar Real>
void RevoluteJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const FixedList<RigidRow<Real>, 2> pin = pin_rows(ends_.a, ends_.b, ends_.arms(at));
  // The last rows of a sweep are satisfied best: the pin itself comes after what is asked of the angle.
  if (!turn_.is_free()) turn_.add_rows<Real>(angle_row(ends_.a, ends_.b, ends_.angle(at)), pin, rows);
  for (const RigidRow<Real>& row : pin) rows.add(row);
}

template <Scalar Real>
void RevoluteJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                            PerBody<Vec3<Real>>& stiffness) const {
  add_pin_stiffness(ends_.a, ends_.b, ends_.arms(at), pin_force(forces), stiffness);
}

template class ConstraintOf<RevoluteJoint>;

}  // namespace cairn
