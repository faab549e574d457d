// Floor 4. Impulses and speeds that are never negative.
#include "solvers/exact/interior_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

namespace {

// Of the matrix alone, not of the answer: what a system is softer by keeps its roundings small.
constexpr double softness_of_systems = 1e-5;
constexpr double share_of_smoothing = 0.1;  // |w_t| is round below so much of the root of the mean product

}  // namespace

template <Scalar Real>
bool InteriorRows<Real>::begin(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center,
                               Real distance) {
  if (!find_interior_members(rows, members_)) return false;
  for (Member& member : members_) set_speeds(center, member, distance);
  find_velocity(rows);
  return true;
}

/// From the centre; the velocity may come from elsewhere after that.
template <Scalar Real>
void InteriorRows<Real>::set_speeds(const ProximalCenter<Real>& center, Member& member, Real distance) {
  const Real x = center.x()(member.row), w = center.w()(member.row);
  if (member.sides == 0) {
    member.bound = x;
  } else if (member.sides == 1) {
    member.plus.impulse = std::max(member.direction * (x - member.bound), distance);
    member.plus.speed = std::max(member.direction * w, distance);
  } else {
    const Real tangent = member.ratio > 0 ? center.x()(member.friction) / member.ratio : Real(0);
    const Real slip = member.ratio * center.w()(member.friction);
    member.plus.impulse = std::max((x + tangent) / 2, distance);
    member.minus.impulse = std::max((x - tangent) / 2, distance);
    member.plus.speed = std::max(w + std::abs(slip) + slip, distance);
    member.minus.speed = std::max(w + std::abs(slip) - slip, distance);
  }
}

template <Scalar Real>
void InteriorRows<Real>::find_velocity(const ScaledRows<Real>& rows) {
  x_.setZero(rows.rows().size());
  u_.setZero(rows.freedoms());
  for (const Member& member : members_) {
    x_(member.row) = member.bound + member.direction * (member.plus.impulse + member.minus.impulse);
    rows.terms_of(rows.rows()[member.row]).add_to(u_, x_(member.row));
    if (member.friction < 0) continue;
    x_(member.friction) = member.ratio * (member.plus.impulse - member.minus.impulse);
    rows.terms_of(rows.rows()[member.friction]).add_to(u_, x_(member.friction));
  }
}

template <Scalar Real>
Real InteriorRows<Real>::speed_of(const ScaledRows<Real>& rows, int i) const {
  const auto& row = rows.rows()[i];
  return rows.terms_of(row).product(u_) + row.softness * x_(i) + row.constant;
}

template <Scalar Real>
void InteriorRows<Real>::linearize(const ScaledRows<Real>& rows, Real error_of_a_row) {
  const Real smoothing = Real(share_of_smoothing) * std::max(std::sqrt(mean_product(0)), error_of_a_row);
  for (Member& member : members_) {
    if (member.sides == 2) {
      linearize_cone(rows, member, smoothing);
      continue;
    }
    const Real softness = rows.rows()[member.row].softness + Real(softness_of_systems);
    const Real w = speed_of(rows, member.row);
    member.plus.error = member.sides == 0 ? -w : member.plus.speed - member.direction * w;
    const Real barrier = member.sides == 0 ? Real(0) : member.plus.speed / member.plus.impulse;
    member.plus_slope = 1 / (barrier + softness);
  }
}

template <Scalar Real>
void InteriorRows<Real>::linearize_cone(const ScaledRows<Real>& rows, Member& member, Real smoothing) const {
  const Real w = speed_of(rows, member.row), slip = member.ratio * speed_of(rows, member.friction);
  member.lift_slope = slip == 0 ? Real(0) : slip / std::sqrt(slip * slip + smoothing * smoothing);
  member.plus.error = member.plus.speed - (w + std::abs(slip) + slip);
  member.minus.error = member.minus.speed - (w + std::abs(slip) - slip);
  const Real normal = rows.rows()[member.row].softness + Real(softness_of_systems);
  const Real tangent =
      member.ratio * member.ratio * (rows.rows()[member.friction].softness + Real(softness_of_systems));
  const Real plus = member.plus.speed / member.plus.impulse + normal + tangent;
  const Real minus = member.minus.speed / member.minus.impulse + normal + tangent;
  const Real mixed = normal - tangent, determinant = plus * minus - mixed * mixed;
  member.plus_slope = minus / determinant;
  member.minus_slope = plus / determinant;
  member.mixed_slope = -mixed / determinant;
}

template <Scalar Real>
void InteriorRows<Real>::right_sides(const Member& member, Real target, Real& plus, Real& minus) const {
  const auto of = [target](const Side& side) {
    return (target - side.product) / side.impulse - side.speed + side.error;
  };
  plus = member.sides == 0 ? member.plus.error : of(member.plus);
  minus = member.sides == 2 ? of(member.minus) : Real(0);
}

template <Scalar Real>
void InteriorRows<Real>::find_right_side(const ScaledRows<Real>& rows, Real target,
                                         Vector<Real>& right) const {
  right.setZero(rows.freedoms());
  for (const Member& member : members_) {
    Real plus, minus;
    right_sides(member, target, plus, minus);
    const Real a = member.plus_slope * plus + member.mixed_slope * minus;
    const Real b = member.mixed_slope * plus + member.minus_slope * minus;
    rows.terms_of(rows.rows()[member.row]).add_to(right, member.direction * (a + b));
    if (member.friction >= 0)
      rows.terms_of(rows.rows()[member.friction]).add_to(right, member.ratio * (a - b));
  }
}

template <Scalar Real>
void InteriorRows<Real>::follow_velocity(const ScaledRows<Real>& rows, Real target, const Vector<Real>& du) {
  for (Member& member : members_) {
    Real plus, minus;
    right_sides(member, target, plus, minus);
    const Real normal = member.direction * rows.terms_of(rows.rows()[member.row]).product(du);
    const Real slip = member.friction >= 0
                          ? member.ratio * rows.terms_of(rows.rows()[member.friction]).product(du)
                          : Real(0);
    plus -= normal + (member.lift_slope + 1) * slip;
    if (member.sides == 2) minus -= normal + (member.lift_slope - 1) * slip;
    member.plus.impulse_change = member.plus_slope * plus + member.mixed_slope * minus;
    member.minus.impulse_change = member.mixed_slope * plus + member.minus_slope * minus;
    for (Side* side : {&member.plus, &member.minus}) {
      if (side->impulse == 0) continue;  // there is none
      side->speed_change =
          (target - side->product - side->speed * side->impulse_change) / side->impulse - side->speed;
    }
  }
}

template <Scalar Real>
template <typename Visit>
void InteriorRows<Real>::for_each_side(const Visit& visit) const {
  for (const Member& member : members_) {
    if (member.sides > 0) visit(member.plus);
    if (member.sides > 1) visit(member.minus);
  }
}

template <Scalar Real>
void InteriorRows<Real>::keep_products() {
  for (Member& member : members_) {
    for (Side* side : {&member.plus, &member.minus})
      side->product = side->impulse_change * side->speed_change;
  }
}

template <Scalar Real>
Real InteriorRows<Real>::longest_step() const {
  Real longest = std::numeric_limits<Real>::infinity();
  for_each_side([&longest](const Side& side) {
    if (side.impulse_change < 0) longest = std::min(longest, -side.impulse / side.impulse_change);
    if (side.speed_change < 0) longest = std::min(longest, -side.speed / side.speed_change);
  });
  return longest;
}

template <Scalar Real>
Real InteriorRows<Real>::mean_product(Real share) const {
  Real sum = 0;
  int count = 0;
  for_each_side([&](const Side& side) {
    sum += (side.impulse + share * side.impulse_change) * (side.speed + share * side.speed_change);
    ++count;
  });
  return sum / std::max(count, 1);
}

template <Scalar Real>
void InteriorRows<Real>::go(const ScaledRows<Real>& rows, Real share) {
  for (Member& member : members_) {
    if (member.sides == 0) member.bound += share * member.plus.impulse_change;
    for (Side* side : {&member.plus, &member.minus}) {
      if (side->impulse != 0) side->impulse += share * side->impulse_change;
      side->speed += share * side->speed_change;
      side->product = 0;
    }
  }
  find_velocity(rows);
}

template <Scalar Real>
void InteriorRows<Real>::clear() {
  members_.clear();
  x_.resize(0);
  u_.resize(0);
}

template <Scalar Real>
std::size_t InteriorRows<Real>::memory() const {
  return members_.bytes() + static_cast<std::size_t>(x_.size() + u_.size()) * sizeof(Real);
}

template class InteriorRows<double>;
template class InteriorRows<long double>;

}  // namespace cairn
