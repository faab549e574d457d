// Floor 3. The revolute joint's rows: two for the pin, and what its limits and motor need.
#include <cairn/constraints/revolute_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

void require_motor(const std::optional<RevoluteJoint::Motor>& motor) {
  if (!motor) return;
  require_finite(motor->speed, "RevoluteJoint", "motor speed", "rad/s");
  require(motor->max_torque > 0 && std::isfinite(motor->max_torque), "RevoluteJoint", "motor max_torque",
          "a finite number > 0 N m", motor->max_torque);
}

}  // namespace

RevoluteJoint::RevoluteJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : limits_{.lower = spec.lower, .upper = spec.upper, .margin = spec.limit_margin}, motor_(spec.motor) {
  require(spec.a != spec.b, "RevoluteJoint", "b", "another body than a", spec.b.index);
  require_finite(spec.anchor, "RevoluteJoint", "anchor", "m");
  require_limits(limits_, "RevoluteJoint", "rad");
  require_motor(motor_);
  ends_ = {spec.a, spec.b, spec.anchor, spec.anchor, poses};
}

std::optional<JointMotor> RevoluteJoint::motor() const {
  if (!motor_) return std::nullopt;
  return JointMotor{.speed = motor_->speed, .max_force = motor_->max_torque};
}

std::shared_ptr<const Constraint> RevoluteJoint::with_motor(const std::optional<JointMotor>& motor) const {
  auto other = std::make_shared<RevoluteJoint>(*this);
  other->motor_.reset();
  if (motor) other->motor_ = Motor{.speed = motor->speed, .max_torque = motor->max_force};
  require_motor(other->motor_);
  return other;
}

template <Scalar Real>
void RevoluteJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  // The last rows of a sweep are satisfied best: the pin itself comes after its motor and its limits.
  if (motor_ || limits_.lower || limits_.upper) {
    const RigidRow<Real> turn = angle_row(ends_.a, ends_.b, ends_.angle(at));
    if (motor_) add_motor_row(turn, motor_->speed, motor_->max_torque, rows);
    add_limit_rows(turn, limits_, rows);
  }
  for (const RigidRow<Real>& row : pin_rows(ends_.a, ends_.b, ends_.arms(at))) rows.add(row);
}

template <Scalar Real>
void RevoluteJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                            PerBody<Vec3<Real>>& stiffness) const {
  add_pin_stiffness(ends_.a, ends_.b, ends_.arms(at), pin_force(forces), stiffness);
}

template class ConstraintOf<RevoluteJoint>;

}  // namespace cairn
