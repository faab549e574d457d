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

bool InteriorRows::begin(const ProximalRows<double>& rows, double distance) {
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

bool InteriorRows::append(int i) {
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

void InteriorRows::pair_friction(int i, bool& fits) {
  const auto& row = rows_->row(i);
  if (row.unit == 0 || !row.bounds.is_friction()) return;
  const bool has_one_normal = !(row.bounds.disc > 0) && row.bounds.normal_row != Bounds<double>::none &&
                              row.bounds.second_normal_row == Bounds<double>::none;
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
void InteriorRows::set_speeds(Member& member, double distance) const {
  const double x = rows_->center(member.row), w = rows_->center_speed(member.row);
  if (member.sides == 0) {
    member.bound = x;
  } else if (member.sides == 1) {
    member.plus.impulse = std::max(member.direction * (x - member.bound), distance);
    member.plus.speed = std::max(member.direction * w, distance);
  } else {
    const double tangent = member.ratio > 0 ? rows_->center(member.friction) / member.ratio : 0.0;
    const double slip = member.ratio * rows_->center_speed(member.friction);
    member.plus.impulse = std::max((x + tangent) / 2, distance);
    member.minus.impulse = std::max((x - tangent) / 2, distance);
    member.plus.speed = std::max(w + std::abs(slip) + slip, distance);
    member.minus.speed = std::max(w + std::abs(slip) - slip, distance);
  }
}

void InteriorRows::find_velocity() {
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

double InteriorRows::speed_of(int i) const {
  const auto& row = rows_->row(i);
  return rows_->product(row, u_) + row.softness * x_(i) + row.constant;
}

void InteriorRows::linearize() {
  const double smoothing = share_of_smoothing * std::max(std::sqrt(mean_product(0)), rows_->error_of_a_row());
  for (Member& member : members_) {
    if (member.sides == 2) {
      linearize_cone(member, smoothing);
      continue;
    }
    const double softness = rows_->row(member.row).softness + softness_of_systems;
    const double w = speed_of(member.row);
    member.plus.error = member.sides == 0 ? -w : member.plus.speed - member.direction * w;
    const double barrier = member.sides == 0 ? 0.0 : member.plus.speed / member.plus.impulse;
    member.plus_slope = 1 / (barrier + softness);
  }
}

void InteriorRows::linearize_cone(Member& member, double smoothing) const {
  const double w = speed_of(member.row), slip = member.ratio * speed_of(member.friction);
  member.lift_slope = slip == 0 ? 0.0 : slip / std::sqrt(slip * slip + smoothing * smoothing);
  member.plus.error = member.plus.speed - (w + std::abs(slip) + slip);
  member.minus.error = member.minus.speed - (w + std::abs(slip) - slip);
  const double normal = rows_->row(member.row).softness + softness_of_systems;
  const double tangent =
      member.ratio * member.ratio * (rows_->row(member.friction).softness + softness_of_systems);
  const double plus = member.plus.speed / member.plus.impulse + normal + tangent;
  const double minus = member.minus.speed / member.minus.impulse + normal + tangent;
  const double mixed = normal - tangent, determinant = plus * minus - mixed * mixed;
  member.plus_slope = minus / determinant;
  member.minus_slope = plus / determinant;
  member.mixed_slope = -mixed / determinant;
}

void InteriorRows::right_sides(const Member& member, double target, double& plus, double& minus) const {
  const auto of = [target](const Side& side) {
    return (target - side.product) / side.impulse - side.speed + side.error;
  };
  plus = member.sides == 0 ? member.plus.error : of(member.plus);
  minus = member.sides == 2 ? of(member.minus) : 0.0;
}

void InteriorRows::find_right_side(double target, Vector<double>& right) const {
  right.setZero(rows_->freedoms());
  for (const Member& member : members_) {
    double plus, minus;
    right_sides(member, target, plus, minus);
    const double a = member.plus_slope * plus + member.mixed_slope * minus;
    const double b = member.mixed_slope * plus + member.minus_slope * minus;
    rows_->add_to(right, rows_->row(member.row), member.direction * (a + b));
    if (member.friction >= 0) rows_->add_to(right, rows_->row(member.friction), member.ratio * (a - b));
  }
}

void InteriorRows::find_direction(double target, const Vector<double>& du) {
  for (Member& member : members_) {
    double plus, minus;
    right_sides(member, target, plus, minus);
    const double normal = member.direction * rows_->product(rows_->row(member.row), du);
    const double slip =
        member.friction >= 0 ? member.ratio * rows_->product(rows_->row(member.friction), du) : 0.0;
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

template <typename Visit>
void InteriorRows::for_each_side(const Visit& visit) const {
  for (const Member& member : members_) {
    if (member.sides > 0) visit(member.plus);
    if (member.sides > 1) visit(member.minus);
  }
}

void InteriorRows::keep_products() {
  for (Member& member : members_) {
    for (Side* side : {&member.plus, &member.minus})
      side->product = side->impulse_change * side->speed_change;
  }
}

double InteriorRows::longest_step() const {
  double longest = std::numeric_limits<double>::infinity();
  for_each_side([&longest](const Side& side) {
    if (side.impulse_change < 0) longest = std::min(longest, -side.impulse / side.impulse_change);
    if (side.speed_change < 0) longest = std::min(longest, -side.speed / side.speed_change);
  });
  return longest;
}

double InteriorRows::mean_product(double share) const {
  double sum = 0;
  int count = 0;
  for_each_side([&](const Side& side) {
    sum += (side.impulse + share * side.impulse_change) * (side.speed + share * side.speed_change);
    ++count;
  });
  return sum / std::max(count, 1);
}

void InteriorRows::go(double share) {
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

void InteriorRows::copy_impulses_to(PerRow<double>& impulse) const {
  impulse.resize(rows_->row_count());
  for (int i = 0; i < rows_->row_count(); ++i) impulse[i] = rows_->row(i).unit * x_(i);
}

void InteriorRows::clear() {
  members_.clear();
  member_of_.clear();
  x_.resize(0);
  u_.resize(0);
}

std::size_t InteriorRows::memory() const {
  return members_.bytes() + member_of_.bytes() +
         static_cast<std::size_t>(x_.size() + u_.size()) * sizeof(double);
}

}  // namespace cairn
