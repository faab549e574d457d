// Floor 3. The prismatic joint's rows: two for the slide, and what its limits and motor need.
#include <cairn/constraints/prismatic_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// C = direction . d, for a direction that turns with a.
template <Scalar Real>
RigidRow<Real> slide_row(BodyId a, BodyId b, const JointArms<Real>& arms, const Vec2<Real>& direction,
                         JointPart part) {
  const Vec2<Real> arm_a = arms.r_a + arms.d;
  return {.a = a,
          .b = b,
          .error = direction.dot(arms.d),
          .jacobian_a = {-direction.x(), -direction.y(), -cross(arm_a, direction)},
          .jacobian_b = {direction.x(), direction.y(), cross(arms.r_b, direction)},
          .part = static_cast<std::uint64_t>(part)};
}

void require_motor(const std::optional<PrismaticJoint::Motor>& motor) {
  if (!motor) return;
  require_finite(motor->speed, "PrismaticJoint", "motor speed", "m/s");
  require(motor->max_force > 0 && std::isfinite(motor->max_force), "PrismaticJoint", "motor max_force",
          "a finite number > 0 N", motor->max_force);
}

}  // namespace

PrismaticJoint::PrismaticJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : limits_{.lower = spec.lower, .upper = spec.upper, .margin = spec.limit_margin}, motor_(spec.motor) {
  require(spec.a != spec.b, "PrismaticJoint", "b", "another body than a", spec.b.index);
  require_finite(spec.anchor, "PrismaticJoint", "anchor", "m");
  require_finite(spec.axis, "PrismaticJoint", "axis", "m");
  const double length = spec.axis.stableNorm();
  require(length > 0 && std::isfinite(length), "PrismaticJoint", "axis", "of a finite length > 0 m", length);
  require_limits(limits_, "PrismaticJoint", "m");
  require_motor(motor_);
  ends_ = {spec.a, spec.b, spec.anchor, spec.anchor, poses};
  local_axis_ = Rotation<double>(poses[spec.a].angle).transposed_times(spec.axis / length);
}

std::optional<JointMotor> PrismaticJoint::motor() const {
  if (!motor_) return std::nullopt;
  return JointMotor{.speed = motor_->speed, .max_force = motor_->max_force};
}

std::shared_ptr<const Constraint> PrismaticJoint::with_motor(const std::optional<JointMotor>& motor) const {
  auto other = std::make_shared<PrismaticJoint>(*this);
  other->motor_.reset();
  if (motor) other->motor_ = Motor{.speed = motor->speed, .max_force = motor->max_force};
  require_motor(other->motor_);
  return other;
}

template <Scalar Real>
void PrismaticJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const JointArms<Real> arms = ends_.arms(at);
  const Vec2<Real> u = at[ends_.a].rotation * local_axis_.template cast<Real>();

  // The last rows of a sweep are satisfied best: the slide itself comes after its motor and its limits.
  if (motor_ || limits_.lower || limits_.upper) {
    const RigidRow<Real> along = slide_row(ends_.a, ends_.b, arms, u, JointPart::x);
    if (motor_) add_motor_row(along, motor_->speed, motor_->max_force, rows);
    add_limit_rows(along, limits_, rows);
  }
  rows.add(slide_row<Real>(ends_.a, ends_.b, arms, perpendicular(u), JointPart::y));
  rows.add(angle_row(ends_.a, ends_.b, ends_.angle(at)));
}

template <Scalar Real>
void PrismaticJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                             PerBody<Vec3<Real>>& stiffness) const {
  JointArms<Real> arms = ends_.arms(at);
  arms.r_a += arms.d;
  const Vec2<Real> u = at[ends_.a].rotation * local_axis_.template cast<Real>();
  const auto of = [&](JointPart part) { return forces.of(static_cast<std::uint64_t>(part)); };
  const Real along = of(JointPart::lower_limit) - of(JointPart::upper_limit) + of(JointPart::motor);
  const Vec2<Real> force = along * u + of(JointPart::y) * perpendicular(u);
  add_pin_stiffness(ends_.a, ends_.b, arms, force, stiffness);
}

template class ConstraintOf<PrismaticJoint>;

}  // namespace cairn
