// Floor 3. The rows of limits, motors, springs and ratchets.
#include <cairn/constraints/joint_coordinate.hpp>

#include <cmath>
#include <string>

#include <cairn/math/check.hpp>

namespace cairn {

namespace {

template <Scalar Real>
RowSpec<Real> part_of(const RigidRow<Real>& coordinate, JointPart part) {
  RowSpec<Real> row = coordinate;
  row.part = static_cast<std::uint64_t>(part);
  return row;
}

template <Scalar Real>
void add_spring_row(const RigidRow<Real>& coordinate, const JointSpring& spring, RowWriter<Real>& rows) {
  RowSpec<Real> row = part_of(coordinate, JointPart::spring);
  row.error -= static_cast<Real>(spring.rest);
  row.softness = spring.softness;
  rows.add(row);
}

template <Scalar Real>
void add_ratchet_row(const RigidRow<Real>& coordinate, Real tooth, RowWriter<Real>& rows) {
  RowSpec<Real> row = part_of(coordinate, JointPart::ratchet);
  const Real play = static_cast<Real>(JointCoordinate::ratchet_play);
  row.error = coordinate.error - tooth * std::floor(coordinate.error / tooth + play);
  row.bounds = Bounds<Real>::unilateral();
  row.keeps_slop = false;
  row.jumps = true;
  if (tooth < 0) {
    row.error = -row.error;
    row.jacobian_a = -row.jacobian_a;
    row.jacobian_b = -row.jacobian_b;
  }
  rows.add(row);
}

}  // namespace

JointCoordinate::JointCoordinate(const JointLimits& limits, const std::optional<JointMotor>& motor,
                                 const std::optional<JointSpring>& spring,
                                 const std::optional<double>& ratchet, const char* place, const char* unit)
    : limits_(limits), motor_(motor), spring_(spring), ratchet_(ratchet), place_(place), unit_(unit) {
  require_limits(limits_, place_, unit_);
  require_motor();
  if (spring_) {
    require_softness(spring_->softness, place_);
    require_finite(spring_->rest, place_, "spring rest", unit_);
  }
  if (!ratchet_) return;
  const double tooth = std::abs(*ratchet_);
  require(tooth >= 1e-9 && tooth <= 1e9, place_, "ratchet",
          std::string("from 1e-9 to 1e9 ") + unit_ + ", or the same below 0", *ratchet_);
}

void JointCoordinate::require_motor() const {
  if (!motor_) return;
  const std::string unit = unit_;
  const bool turns = unit == "rad";
  require_finite(motor_->speed, place_, "motor speed", unit + "/s");
  require(motor_->max_force > 0 && std::isfinite(motor_->max_force), place_,
          turns ? "motor max_torque" : "motor max_force",
          turns ? "a finite number > 0 N m" : "a finite number > 0 N", motor_->max_force);
  if (!motor_->target) return;
  require_finite(*motor_->target, place_, "motor target", unit_);
  require(motor_->speed > 0, place_, "motor speed", "> 0 " + unit + "/s where there is a target",
          motor_->speed);
  require(motor_->rate > 0 && std::isfinite(motor_->rate), place_, "motor rate", "a finite number > 0 1/s",
          motor_->rate);
}

void JointCoordinate::change(const std::optional<JointMotor>& motor) {
  motor_ = motor;
  require_motor();
}

JointTraits JointCoordinate::marked(JointTraits traits) const {
  traits.has_servo |= motor_ && motor_->target;
  traits.has_spring |= spring_.has_value();
  traits.has_ratchet |= ratchet_.has_value();
  traits.box2d_rows += motor_ ? 1 : 0;
  traits.box2d_rows += limits_.lower || limits_.upper ? 2 : 0;
  return traits;
}

/// Springs come first, and what holds last: the last rows of a sweep are satisfied best.
template <Scalar Real>
void JointCoordinate::add_rows(const RigidRow<Real>& coordinate, Span<const RigidRow<Real>> held,
                               RowWriter<Real>& rows) const {
  if (spring_) add_spring_row(coordinate, *spring_, rows);
  if (motor_) {
    const bool is_servo = motor_->target.has_value();
    add_motor_row(coordinate, *motor_, rows,
                  is_servo ? inverse_mass_beside(coordinate, held, rows) : Real(0));
  }
  if (ratchet_) add_ratchet_row(coordinate, static_cast<Real>(*ratchet_), rows);
  add_limit_rows(coordinate, limits_, rows);
}

template <Scalar Real>
Real JointCoordinate::force(const RowForces<Real>& forces) const {
  const auto of = [&](JointPart part) { return forces.of(static_cast<std::uint64_t>(part)); };
  const Real ratchet = of(JointPart::ratchet);
  return of(JointPart::lower_limit) - of(JointPart::upper_limit) + (motor_ ? of(JointPart::motor) : Real(0)) +
         of(JointPart::spring) + (ratchet_.value_or(1) > 0 ? ratchet : -ratchet);
}

template void JointCoordinate::add_rows(const RigidRow<float>&, Span<const RigidRow<float>>,
                                        RowWriter<float>&) const;
template void JointCoordinate::add_rows(const RigidRow<double>&, Span<const RigidRow<double>>,
                                        RowWriter<double>&) const;
template float JointCoordinate::force(const RowForces<float>&) const;
template double JointCoordinate::force(const RowForces<double>&) const;

}  // namespace cairn
