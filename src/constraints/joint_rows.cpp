// Floor 3. The shared rows of joints.
#include "constraints/joint_rows.hpp"

#include <algorithm>
#include <cmath>

#include "math/check.hpp"

namespace cairn {

JointEnds::JointEnds(BodyId first, BodyId second, const Vec2<double>& anchor_a, const Vec2<double>& anchor_b,
                     PerBodySpan<const Pose<double>> poses)
    : a(first),
      b(second),
      local_a(poses[a].local(anchor_a)),
      local_b(poses[b].local(anchor_b)),
      reference_angle(poses[b].angle - poses[a].angle) {}

template <Scalar Real>
void append_pin_rows(BodyId a, BodyId b, const JointArms<Real>& arms, RowSpecs<Real>& rows) {
  RowSpec<Real>& x = rows.emplace_back();
  x.a = a;
  x.b = b;
  x.error = arms.d.x();
  x.jacobian_a = {-1, 0, arms.r_a.y()};
  x.jacobian_b = {1, 0, -arms.r_b.y()};
  x.part = static_cast<std::uint64_t>(JointPart::x);

  RowSpec<Real>& y = rows.emplace_back();
  y.a = a;
  y.b = b;
  y.error = arms.d.y();
  y.jacobian_a = {0, -1, -arms.r_a.x()};
  y.jacobian_b = {0, 1, arms.r_b.x()};
  y.part = static_cast<std::uint64_t>(JointPart::y);
}

template <Scalar Real>
RowSpec<Real> angle_row(BodyId a, BodyId b, Real angle) {
  RowSpec<Real> row;
  row.a = a;
  row.b = b;
  row.error = angle;
  row.jacobian_a = {0, 0, -1};
  row.jacobian_b = {0, 0, 1};
  row.part = static_cast<std::uint64_t>(JointPart::angle);
  return row;
}

template <Scalar Real>
void append_limit_rows(const RowSpec<Real>& coordinate, const JointLimits& limits, RowSpecs<Real>& rows) {
  RowSpec<Real> row = coordinate;
  if (limits.lower && limits.lower == limits.upper) {
    row.error -= static_cast<Real>(*limits.lower);
    row.part = static_cast<std::uint64_t>(JointPart::lower_limit);
    return rows.push_back(row);
  }
  row.bounds = Bounds<Real>::unilateral();
  row.keeps_slop = false;
  if (limits.lower) {
    row.error = coordinate.error - static_cast<Real>(*limits.lower);
    row.part = static_cast<std::uint64_t>(JointPart::lower_limit);
    if (row.error <= static_cast<Real>(limits.margin)) rows.push_back(row);
  }
  if (limits.upper) {
    row.error = static_cast<Real>(*limits.upper) - coordinate.error;
    row.jacobian_a = -coordinate.jacobian_a;
    row.jacobian_b = -coordinate.jacobian_b;
    row.part = static_cast<std::uint64_t>(JointPart::upper_limit);
    if (row.error <= static_cast<Real>(limits.margin)) rows.push_back(row);
  }
}

template <Scalar Real>
void append_motor_row(const RowSpec<Real>& coordinate, double speed, double max_force, RowSpecs<Real>& rows) {
  RowSpec<Real> row = coordinate;
  row.error = 0;
  row.speed = static_cast<Real>(speed);
  row.max_force = static_cast<Real>(max_force);
  row.part = static_cast<std::uint64_t>(JointPart::motor);
  rows.push_back(row);
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

template void append_pin_rows(BodyId, BodyId, const JointArms<float>&, RowSpecs<float>&);
template void append_pin_rows(BodyId, BodyId, const JointArms<double>&, RowSpecs<double>&);
template void append_pin_rows(BodyId, BodyId, const JointArms<long double>&, RowSpecs<long double>&);
template void add_pin_stiffness(BodyId, BodyId, const JointArms<float>&, const Vec2<float>&,
                                PerBody<Vec3<float>>&);
template void add_pin_stiffness(BodyId, BodyId, const JointArms<double>&, const Vec2<double>&,
                                PerBody<Vec3<double>>&);
template void add_pin_stiffness(BodyId, BodyId, const JointArms<long double>&, const Vec2<long double>&,
                                PerBody<Vec3<long double>>&);
template void add_line_stiffness(BodyId, const Vec2<float>&, const Vec2<float>&, float, float,
                                 PerBody<Vec3<float>>&);
template void add_line_stiffness(BodyId, const Vec2<double>&, const Vec2<double>&, double, double,
                                 PerBody<Vec3<double>>&);
template void add_line_stiffness(BodyId, const Vec2<long double>&, const Vec2<long double>&, long double,
                                 long double, PerBody<Vec3<long double>>&);
template RowSpec<float> angle_row(BodyId, BodyId, float);
template RowSpec<double> angle_row(BodyId, BodyId, double);
template RowSpec<long double> angle_row(BodyId, BodyId, long double);
template void append_limit_rows(const RowSpec<float>&, const JointLimits&, RowSpecs<float>&);
template void append_limit_rows(const RowSpec<double>&, const JointLimits&, RowSpecs<double>&);
template void append_limit_rows(const RowSpec<long double>&, const JointLimits&, RowSpecs<long double>&);
template void append_motor_row(const RowSpec<float>&, double, double, RowSpecs<float>&);
template void append_motor_row(const RowSpec<double>&, double, double, RowSpecs<double>&);
template void append_motor_row(const RowSpec<long double>&, double, double, RowSpecs<long double>&);

}  // namespace cairn
