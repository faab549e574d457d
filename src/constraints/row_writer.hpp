// Floor 3. What a joint says of its rows, and whom it tells.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <cairn/constraints/row.hpp>
#include <cairn/constraints/softness.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// One scalar condition between two bodies that holds rigidly, C = 0, before anybody decided how fast errors
/// go.
template <Scalar Real>
struct RigidRow {
  BodyId a = {};                               // the first body
  BodyId b = {};                               // the second body
  Real error = 0;                              // C (3) [m or rad]; for an inequality: the room left
  Vec3<Real> jacobian_a = Vec3<Real>::Zero();  // dC/dt = j v (5)
  Vec3<Real> jacobian_b = Vec3<Real>::Zero();  // the same for b
  std::uint64_t part = 0;                      // names the row within its joint, from step to step
  Real speed = 0;                              // [m/s or rad/s] that j v should have where C is 0: of a motor
};

/// One that may be of any other kind.
template <Scalar Real>
struct RowSpec : RigidRow<Real> {
  /// With a body: without one, every new row would be cleared as a whole before its members are set.
  RowSpec() {}
  /// The same, with what makes it another kind still to be set.
  RowSpec(const RigidRow<Real>& row) : RigidRow<Real>(row) {}

  Bounds<Real> bounds = {};  // a friction row names its normal row by place among those of its joint
  /// [N or N m]; replaces the bounds by |impulse| <= max_force dt, or by what the row that they name has left
  /// of a disc of that radius
  std::optional<Real> max_force = {};
  std::optional<Softness> softness = {};   // none: rigid
  bool keeps_slop = true;                  // an inequality: may stay violated by the slop, as contacts do
  FixedList<RowTerm<Real>, 2> extra = {};  // a third and a fourth body
  int extra_count = 0;                     // how many of `extra` there are
  bool jumps = false;                      // C does, from pose to pose: it has no arc to follow
  /// [1/s] of a servo: how fast C goes, though not faster than `speed`; 0: the row goes at `speed` itself
  Real approach = 0;
  Real brake = 0;  // [m/s^2 or rad/s^2] of a servo: by what its force could slow it down; 0: not known
};

/// How far the condition is from holding [m or rad], signed: all of the error of an equality, the missing
/// room of an inequality, and nothing for a row that is meant to give way.
template <Scalar Real>
Real violation(const RowSpec<Real>& spec) {
  if (spec.softness || spec.max_force) return 0;
  return spec.bounds.is_equality() ? spec.error : std::min(spec.error, Real(0));
}

/// j v at these velocities.
template <Scalar Real>
Real row_velocity(const RigidRow<Real>& row, const PerBody<Vec3<Real>>& velocity) {
  return dot(row.jacobian_a, velocity[row.a]) + dot(row.jacobian_b, velocity[row.b]);
}
/// The same for any other kind.
template <Scalar Real>
Real row_velocity(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& velocity) {
  Real jv = row_velocity<Real>(static_cast<const RigidRow<Real>&>(spec), velocity);
  for (int k = 0; k < spec.extra_count; ++k) jv += dot(spec.extra[k].jacobian, velocity[spec.extra[k].body]);
  return jv;
}

/// [m/s or rad/s] Of the row of a servo in a step of dt [s]: what is missing asks for it, and no more than
/// all of that within the step, and no more than half of its brake stops in time.
template <Scalar Real>
Real servo_speed(const RowSpec<Real>& servo, Real dt) {
  const Real missing = std::abs(servo.error);
  Real speed = std::min(servo.speed, missing * std::min(servo.approach, 1 / dt));
  if (servo.brake > 0) speed = std::min(speed, std::sqrt(servo.brake * missing));
  return servo.error > 0 ? -speed : speed;
}

/// The row of a servo as that of a motor, in a step of dt [s].
template <Scalar Real>
RowSpec<Real> motor_of(const RowSpec<Real>& servo, Real dt) {
  RowSpec<Real> motor = servo;
  motor.speed = servo_speed(servo, dt);
  motor.error = 0;
  motor.approach = 0;
  return motor;
}

/// The rows of a joint, or of all of them.
template <Scalar Real>
using RowSpecs = List<RowSpec<Real>>;

/// Whom a joint tells its rows, one after the other.
template <Scalar Real>
class RowWriter {
 public:
  virtual ~RowWriter() = default;
  /// The next row.
  virtual void add(const RowSpec<Real>& row) = 0;
  /// The next row, which is a rigid equality of two bodies: soonest written.
  virtual void add(const RigidRow<Real>& row) = 0;
  /// [m/s, m/s, rad/s] that a body would have at the end of the step without constraints, for rows that
  /// depend on it, as friction along the way that a body goes.
  virtual Vec3<Real> velocity(BodyId body) const = 0;
  /// [1/kg, 1/kg, 1/(kg m^2)] of a body, for rows that depend on it, as the braking of a servo; 0: not known.
  virtual Vec3<Real> inverse_mass(BodyId) const { return Vec3<Real>::Zero(); }
};

/// Keeps what it is told, for those who want to know what joints state. Nobody moves.
template <Scalar Real>
class StatedRows final : public RowWriter<Real> {
 public:
  /// Rows go behind those that are there. `inverse_mass`: of bodies, where it is known.
  explicit StatedRows(RowSpecs<Real>& rows, const PerBody<Vec3<Real>>* inverse_mass = nullptr)
      : rows_(rows), inverse_mass_(inverse_mass) {}
  void add(const RowSpec<Real>& row) override { rows_.push_back(row); }
  void add(const RigidRow<Real>& row) override { rows_.push_back(row); }
  Vec3<Real> velocity(BodyId) const override { return Vec3<Real>::Zero(); }
  Vec3<Real> inverse_mass(BodyId body) const override {
    return inverse_mass_ == nullptr ? Vec3<Real>(Vec3<Real>::Zero()) : (*inverse_mass_)[body];
  }

 private:
  RowSpecs<Real>& rows_;
  const PerBody<Vec3<Real>>* inverse_mass_;
};

}  // namespace cairn
