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
bool InteriorRows<Real>::begin(const ProximalRows<Real>& rows, Real distance) {
  rows_ = &rows;
  has_friction_ = false;
  members_.clear();
  member_of_.assign(rows.row_count(), -1);
  bool fits = true;
  for (int i = 0; i < rows.row_count(); ++i) fits = append(i) && fits;
  for (int i = 0; i < rows.row_count(); ++i) pair_friction(i, fits);
  if (!fits) return false;
  for (Member& member : members_) set_speeds(member, distance);
  find_velocity();
  return true;
}

template <Scalar Real>
bool InteriorRows<Real>::append(int i) {
  const auto& row = rows_->row(i);
  if (row.unit == 0 || row.bounds.is_friction()) return true;
  const bool has_lower = std::isfinite(row.bounds.lower), has_upper = std::isfinite(row.bounds.upper);
  Member member{.row = i};
  if (has_lower) member.bound = row.bounds.lower;
  if (has_upper) member.bound = row.bounds.upper;
  if (has_upper) member.direction = -1;
  if (!has_lower && !has_upper) member.sides = 0;
  member_of_[i] = members_.size();
  members_.push_back(member);
  return !(has_lower && has_upper);
}

template <Scalar Real>
void InteriorRows<Real>::pair_friction(int i, bool& fits) {
  const auto& row = rows_->row(i);
  if (row.unit == 0 || !row.bounds.is_friction()) return;
  const bool has_one_normal = !(row.bounds.disc > 0) && row.bounds.normal_row != Bounds<Real>::none &&
                              row.bounds.second_normal_row == Bounds<Real>::none;
  const int place = has_one_normal ? member_of_[row.bounds.normal_row] : -1;
  if (place < 0) {
    fits = false;
    return;
  }
  Member& member = members_[place];
  if (member.friction >= 0 || member.sides != 1 || member.direction < 0 || member.bound != 0) fits = false;
  member.friction = i;
  member.sides = 2;
  member.ratio = row.bounds.friction * rows_->row(member.row).unit / row.unit;
  has_friction_ = true;
}

/// From the centre; the velocity may come from elsewhere after that.
template <Scalar Real>
void InteriorRows<Real>::set_speeds(Member& member, Real distance) const {
  const Real x = rows_->center(member.row), w = rows_->center_speed(member.row);
  if (member.sides == 0) {
    member.bound = x;
  } else if (member.sides == 1) {
    member.plus.impulse = std::max(member.direction * (x - member.bound), distance);
    member.plus.speed = std::max(member.direction * w, distance);
  } else {
    const Real tangent = member.ratio > 0 ? rows_->center(member.friction) / member.ratio : Real(0);
    const Real slip = member.ratio * rows_->center_speed(member.friction);
    member.plus.impulse = std::max((x + tangent) / 2, distance);
    member.minus.impulse = std::max((x - tangent) / 2, distance);
    member.plus.speed = std::max(w + std::abs(slip) + slip, distance);
    member.minus.speed = std::max(w + std::abs(slip) - slip, distance);
  }
}

template <Scalar Real>
void InteriorRows<Real>::find_velocity() {
  x_.setZero(rows_->row_count());
  u_.setZero(rows_->freedoms());
  for (const Member& member : members_) {
    x_(member.row) = member.bound + member.direction * (member.plus.impulse + member.minus.impulse);
    rows_->add_to(u_, rows_->row(member.row), x_(member.row));
    if (member.friction < 0) continue;
    x_(member.friction) = member.ratio * (member.plus.impulse - member.minus.impulse);
    rows_->add_to(u_, rows_->row(member.friction), x_(member.friction));
  }
}

template <Scalar Real>
Real InteriorRows<Real>::speed_of(int i) const {
  const auto& row = rows_->row(i);
  return rows_->product(row, u_) + row.softness * x_(i) + row.constant;
}

template <Scalar Real>
void InteriorRows<Real>::linearize() {
  const Real smoothing =
      Real(share_of_smoothing) * std::max(std::sqrt(mean_product(0)), rows_->error_of_a_row());
  for (Member& member : members_) {
    if (member.sides == 2) {
      linearize_cone(member, smoothing);
      continue;
    }
    const Real softness = rows_->row(member.row).softness + Real(softness_of_systems);
    const Real w = speed_of(member.row);
    member.plus.error = member.sides == 0 ? -w : member.plus.speed - member.direction * w;
    const Real barrier = member.sides == 0 ? Real(0) : member.plus.speed / member.plus.impulse;
    member.plus_slope = 1 / (barrier + softness);
  }
}

template <Scalar Real>
void InteriorRows<Real>::linearize_cone(Member& member, Real smoothing) const {
  const Real w = speed_of(member.row), slip = member.ratio * speed_of(member.friction);
  member.lift_slope = slip == 0 ? Real(0) : slip / std::sqrt(slip * slip + smoothing * smoothing);
  member.plus.error = member.plus.speed - (w + std::abs(slip) + slip);
  member.minus.error = member.minus.speed - (w + std::abs(slip) - slip);
  const Real normal = rows_->row(member.row).softness + Real(softness_of_systems);
  const Real tangent =
      member.ratio * member.ratio * (rows_->row(member.friction).softness + Real(softness_of_systems));
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
void InteriorRows<Real>::find_right_side(Real target, Vector<Real>& right) const {
  right.setZero(rows_->freedoms());
  for (const Member& member : members_) {
    Real plus, minus;
    right_sides(member, target, plus, minus);
    const Real a = member.plus_slope * plus + member.mixed_slope * minus;
    const Real b = member.mixed_slope * plus + member.minus_slope * minus;
    rows_->add_to(right, rows_->row(member.row), member.direction * (a + b));
    if (member.friction >= 0) rows_->add_to(right, rows_->row(member.friction), member.ratio * (a - b));
  }
}

template <Scalar Real>
void InteriorRows<Real>::find_direction(Real target, const Vector<Real>& du) {
  for (Member& member : members_) {
    Real plus, minus;
    right_sides(member, target, plus, minus);
    const Real normal = member.direction * rows_->product(rows_->row(member.row), du);
    const Real slip =
        member.friction >= 0 ? member.ratio * rows_->product(rows_->row(member.friction), du) : Real(0);
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
void InteriorRows<Real>::go(Real share) {
  for (Member& member : members_) {
    if (member.sides == 0) member.bound += share * member.plus.impulse_change;
    for (Side* side : {&member.plus, &member.minus}) {
      if (side->impulse != 0) side->impulse += share * side->impulse_change;
      side->speed += share * side->speed_change;
      side->product = 0;
    }
  }
  find_velocity();
}

template <Scalar Real>
void InteriorRows<Real>::copy_impulses_to(PerRow<Real>& impulse) const {
  impulse.resize(rows_->row_count());
  for (int i = 0; i < rows_->row_count(); ++i) impulse[i] = rows_->row(i).unit * x_(i);
}

template <Scalar Real>
void InteriorRows<Real>::clear() {
  members_.clear();
  member_of_.clear();
  x_.resize(0);
  u_.resize(0);
}

template <Scalar Real>
std::size_t InteriorRows<Real>::memory() const {
  return members_.bytes() + member_of_.bytes() +
         static_cast<std::size_t>(x_.size() + u_.size()) * sizeof(Real);
}

template class InteriorRows<double>;
template class InteriorRows<long double>;

}  // namespace cairn
