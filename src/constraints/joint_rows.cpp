// Floor 3. The shared rows of joints.
#include <cairn/constraints/joint_rows.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>

namespace cairn {

JointEnds::JointEnds(BodyId first, BodyId second, const Vec2<double>& anchor_a, const Vec2<double>& anchor_b,
                     PerBodySpan<const Pose<double>> poses)
    : a(first),
      b(second),
      local_a(poses[a].local(anchor_a)),
      local_b(poses[b].local(anchor_b)),
      reference_angle(poses[b].angle - poses[a].angle) {}

template <Scalar Real>
FixedList<RigidRow<Real>, 2> pin_rows(BodyId a, BodyId b, const JointArms<Real>& arms) {
  return {RigidRow<Real>{.a = a,
                         .b = b,
                         .error = arms.d.x(),
                         .jacobian_a = {-1, 0, arms.r_a.y()},
                         .jacobian_b = {1, 0, -arms.r_b.y()},
                         .part = static_cast<std::uint64_t>(JointPart::x)},
          RigidRow<Real>{.a = a,
                         .b = b,
                         .error = arms.d.y(),
                         .jacobian_a = {0, -1, -arms.r_a.x()},
                         .jacobian_b = {0, 1, arms.r_b.x()},
                         .part = static_cast<std::uint64_t>(JointPart::y)}};
}

template <Scalar Real>
RigidRow<Real> angle_row(BodyId a, BodyId b, Real angle) {
  return {.a = a,
          .b = b,
          .error = angle,
          .jacobian_a = {0, 0, -1},
          .jacobian_b = {0, 0, 1},
          .part = static_cast<std::uint64_t>(JointPart::angle)};
}

template <Scalar Real>
void add_limit_rows(const RigidRow<Real>& coordinate, const JointLimits& limits, RowWriter<Real>& rows) {
  if (limits.lower && limits.lower == limits.upper) {
    RigidRow<Real> row = coordinate;
    row.error -= static_cast<Real>(*limits.lower);
    row.part = static_cast<std::uint64_t>(JointPart::lower_limit);
    return rows.add(row);
  }
  RowSpec<Real> row = coordinate;
  row.bounds = Bounds<Real>::unilateral();
  row.keeps_slop = false;
  if (limits.lower) {
    row.error = coordinate.error - static_cast<Real>(*limits.lower);
    row.part = static_cast<std::uint64_t>(JointPart::lower_limit);
    if (row.error <= static_cast<Real>(limits.margin)) rows.add(row);
  }
  if (limits.upper) {
    row.error = static_cast<Real>(*limits.upper) - coordinate.error;
    row.jacobian_a = -coordinate.jacobian_a;
    row.jacobian_b = -coordinate.jacobian_b;
    row.part = static_cast<std::uint64_t>(JointPart::upper_limit);
    if (row.error <= static_cast<Real>(limits.margin)) rows.add(row);
  }
}

template <Scalar Real>
void add_motor_row(const RigidRow<Real>& coordinate, const JointMotor& motor, RowWriter<Real>& rows,
                   Real inverse_mass) {
  RowSpec<Real> row = coordinate;
  row.error = motor.target ? coordinate.error - static_cast<Real>(*motor.target) : Real(0);
  row.speed = static_cast<Real>(motor.speed);
  row.max_force = static_cast<Real>(motor.max_force);
  row.approach = motor.target ? static_cast<Real>(motor.rate) : Real(0);
  row.brake = static_cast<Real>(motor.max_force) * inverse_mass;
  row.part = static_cast<std::uint64_t>(JointPart::motor);
  rows.add(row);
}

/// The Schur complement of one or two rows that hold: A - b^T K^-1 b.
template <Scalar Real>
Real inverse_mass_beside(const RigidRow<Real>& row, Span<const RigidRow<Real>> held,
                         const RowWriter<Real>& rows) {
  const Vec3<Real> of_a = rows.inverse_mass(row.a), of_b = rows.inverse_mass(row.b);
  const auto coupling = [&](const RigidRow<Real>& one, const RigidRow<Real>& other) {
    return dot<Real>(one.jacobian_a, of_a.cwiseProduct(other.jacobian_a)) +
           dot<Real>(one.jacobian_b, of_b.cwiseProduct(other.jacobian_b));
  };
  const RigidRow<Real>&first = held.front(), &last = held.back();
  const Real free = coupling(row, row), b = coupling(row, first), k = coupling(first, first);
  if (!(k > 0)) return free;
  const Real beside_first = free - b * b / k;
  const Real c = coupling(row, last) - coupling(first, last) * b / k;
  const Real left = coupling(last, last) - coupling(first, last) * coupling(first, last) / k;
  return held.size() > 1 && left > 0 ? beside_first - c * c / left : beside_first;
}

template <Scalar Real>
void add_pin_stiffness(BodyId a, BodyId b, const JointArms<Real>& arms, const Vec2<Real>& force_on_b,
                       PerBody<Vec3<Real>>& stiffness) {
  stiffness[a].z() += std::abs(arms.r_a.dot(force_on_b));
  stiffness[b].z() += std::abs(arms.r_b.dot(force_on_b));
}

template <Scalar Real>
void add_line_stiffness(BodyId body, const Vec2<Real>& arm, const Vec2<Real>& direction, Real length,
                        Real tension, PerBody<Vec3<Real>>& stiffness) {
  const Real reach = std::abs(arm.dot(direction)), l = std::max(length, reach);
  const Real force = std::abs(tension), across = 2 * force / length;
  stiffness[body].x() += across * (1 + reach / l);
  stiffness[body].y() += across * (1 + reach / l);
  stiffness[body].z() += across * reach * (reach + l) + force * reach;
}

void require_limits(const JointLimits& limits, const std::string& place, const std::string& unit) {
  if (limits.lower) require_finite(*limits.lower, place, "lower", unit);
  if (limits.upper) require_finite(*limits.upper, place, "upper", unit);
  if (limits.lower && limits.upper) {
    require(*limits.upper >= *limits.lower, place, "upper",
            ">= lower, " + shortest(*limits.lower) + " " + unit, *limits.upper);
  }
  require(limits.margin >= 0 && std::isfinite(limits.margin), place, "limit_margin",
          "a finite number >= 0 " + unit, limits.margin);
}

template void add_pin_stiffness(BodyId, BodyId, const JointArms<float>&, const Vec2<float>&,
                                PerBody<Vec3<float>>&);
template void add_pin_stiffness(BodyId, BodyId, const JointArms<double>&, const Vec2<double>&,
                                PerBody<Vec3<double>>&);
template void add_line_stiffness(BodyId, const Vec2<float>&, const Vec2<float>&, float, float,
                                 PerBody<Vec3<float>>&);
template void add_line_stiffness(BodyId, const Vec2<double>&, const Vec2<double>&, double, double,
                                 PerBody<Vec3<double>>&);
template FixedList<RigidRow<float>, 2> pin_rows(BodyId, BodyId, const JointArms<float>&);
template RigidRow<float> angle_row(BodyId, BodyId, float);
template void add_limit_rows(const RigidRow<float>&, const JointLimits&, RowWriter<float>&);
template void add_motor_row(const RigidRow<float>&, const JointMotor&, RowWriter<float>&, float);
template float inverse_mass_beside(const RigidRow<float>&, Span<const RigidRow<float>>,
                                   const RowWriter<float>&);
template void add_motor_row(const RigidRow<double>&, const JointMotor&, RowWriter<double>&, double);
template double inverse_mass_beside(const RigidRow<double>&, Span<const RigidRow<double>>,
                                    const RowWriter<double>&);
template FixedList<RigidRow<double>, 2> pin_rows(BodyId, BodyId, const JointArms<double>&);
template RigidRow<double> angle_row(BodyId, BodyId, double);
template void add_limit_rows(const RigidRow<double>&, const JointLimits&, RowWriter<double>&);

}  // namespace cairn
