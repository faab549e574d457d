// Floor 4. Impulses and speeds that are never negative.
#include <cairn/solvers/exact/interior_rows.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

namespace {

// Of the matrix alone, not of the answer: what a system is softer by keeps its roundings small.
constexpr double softness_of_systems = 1e-5;
constexpr double share_of_smoothing = 0.1;  // |w_t| is round below so much of the root of the mean product

}  // namespace

bool InteriorRows::begin(const ScaledRows<double>& rows, const ProximalCenter<double>& center,
                         double distance) {
  if (!find_interior_members(rows, members_)) return false;
  for (Member& member : members_) set_speeds(center, member, distance);
  find_velocity(rows);
  return true;
}

/// From the centre; the velocity may come from elsewhere after that.
void InteriorRows::set_speeds(const ProximalCenter<double>& center, Member& member, double distance) {
  const double x = center.x()(member.row), w = center.w()(member.row);
  if (member.sides == 0) {
    member.bound = x;
  } else if (member.sides == 1) {
    member.plus.impulse = std::max(member.direction * (x - member.bound), distance);
    member.plus.speed = std::max(member.direction * w, distance);
  } else {
    const double tangent = member.ratio > 0 ? center.x()(member.friction) / member.ratio : 0.0;
    const double slip = member.ratio * center.w()(member.friction);
    member.plus.impulse = std::max((x + tangent) / 2, distance);
    member.minus.impulse = std::max((x - tangent) / 2, distance);
    member.plus.speed = std::max(w + std::abs(slip) + slip, distance);
    member.minus.speed = std::max(w + std::abs(slip) - slip, distance);
  }
}

void InteriorRows::find_velocity(const ScaledRows<double>& rows) {
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

double InteriorRows::speed_of(const ScaledRows<double>& rows, int i) const {
  const auto& row = rows.rows()[i];
  return rows.terms_of(row).product(u_) + row.softness * x_(i) + row.constant;
}

void InteriorRows::linearize(const ScaledRows<double>& rows, double error_of_a_row) {
  const double smoothing = share_of_smoothing * std::max(std::sqrt(mean_product(0)), error_of_a_row);
  for (Member& member : members_) {
    if (member.sides == 2) {
      linearize_cone(rows, member, smoothing);
      continue;
    }
    const double softness = rows.rows()[member.row].softness + softness_of_systems;
    const double w = speed_of(rows, member.row);
    member.plus.error = member.sides == 0 ? -w : member.plus.speed - member.direction * w;
    const double barrier = member.sides == 0 ? 0.0 : member.plus.speed / member.plus.impulse;
    member.plus_slope = 1 / (barrier + softness);
  }
}

void InteriorRows::linearize_cone(const ScaledRows<double>& rows, Member& member, double smoothing) const {
  const double w = speed_of(rows, member.row), slip = member.ratio * speed_of(rows, member.friction);
  member.lift_slope = slip == 0 ? 0.0 : slip / std::sqrt(slip * slip + smoothing * smoothing);
  member.plus.error = member.plus.speed - (w + std::abs(slip) + slip);
  member.minus.error = member.minus.speed - (w + std::abs(slip) - slip);
  const double normal = rows.rows()[member.row].softness + softness_of_systems;
  const double tangent =
      member.ratio * member.ratio * (rows.rows()[member.friction].softness + softness_of_systems);
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

void InteriorRows::find_right_side(const ScaledRows<double>& rows, double target,
                                   Vector<double>& right) const {
  right.setZero(rows.freedoms());
  for (const Member& member : members_) {
    double plus, minus;
    right_sides(member, target, plus, minus);
    const double a = member.plus_slope * plus + member.mixed_slope * minus;
    const double b = member.mixed_slope * plus + member.minus_slope * minus;
    rows.terms_of(rows.rows()[member.row]).add_to(right, member.direction * (a + b));
    if (member.friction >= 0)
      rows.terms_of(rows.rows()[member.friction]).add_to(right, member.ratio * (a - b));
  }
}

void InteriorRows::follow_velocity(const ScaledRows<double>& rows, double target, const Vector<double>& du) {
  for (Member& member : members_) {
    double plus, minus;
    right_sides(member, target, plus, minus);
    const double normal = member.direction * rows.terms_of(rows.rows()[member.row]).product(du);
    const double slip =
        member.friction >= 0 ? member.ratio * rows.terms_of(rows.rows()[member.friction]).product(du) : 0.0;
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

void InteriorRows::go(const ScaledRows<double>& rows, double share) {
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

void InteriorRows::clear() {
  members_.clear();
  x_.resize(0);
  u_.resize(0);
}

std::size_t InteriorRows::memory() const {
  return members_.bytes() + static_cast<std::size_t>(x_.size() + u_.size()) * sizeof(double);
}

}  // namespace cairn
