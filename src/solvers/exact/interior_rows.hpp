// Floor 4. Rows on the way through the interior of their bounds: the interior point method.
#pragma once

#include <algorithm>

#include <cairn/solvers/exact/interior_members.hpp>
#include <cairn/solvers/exact/proximal_center.hpp>

namespace cairn {

/// The rows of ScaledRows as pairs of numbers that are never negative, an impulse p and a speed z, with
///   p z = mu   for all of them, on the central path,
/// and mu on its way to 0 (S. Mehrotra, On the implementation of a primal-dual interior point method, 1992).
/// A row with one bound has one such pair. A contact with friction has two: its impulse is a sum of the two
/// edges of the cone, p+ (1, m) + p- (1, -m), and z+- = w_n + m |w_t| +- m w_t, where the lift m |w_t| keeps
/// the contact from opening as it slides (G. De Saxce, Z.-Q. Feng, The bipotential method, 1998). Rows
/// without bounds have no z.
///
/// Which rows are at their bounds need not be guessed: where many change at once, 15 to 30 systems lead to
/// the answer, however many they are. Numbers are in sqrt(J), as there.
class InteriorRows {
 public:
  /// Begins from a centre, brought so far away from bounds [sqrt(J)].
  /// @returns false for rows that have no way through the interior, as find_interior_members().
  bool begin(const ScaledRows<double>& rows, const ProximalCenter<double>& center, double distance);

  /// Holds no rows any more.
  void clear();
  /// Finds what follows from the impulses and speeds of the moment. Beside R_E of a row nothing need be
  /// sharp.
  void linearize(const ScaledRows<double>& rows, double error_of_a_row);
  /// Calls visit(left, right, factor) as ProximalMap does.
  template <typename Visit>
  void for_each_slope(const ScaledRows<double>& rows, const Visit& visit) const;
  /// Whether that is symmetric: no friction.
  bool has_symmetric_slope(const ScaledRows<double>&) const {
    return std::none_of(members_.begin(), members_.end(), [](const Member& one) { return one.sides == 2; });
  }

  /// The direction for p z = target, without second order or with what keep_products() has kept. solve()
  /// solves the system of the slopes in place, in `du`.
  template <typename Solve>
  void find_direction(const ScaledRows<double>& rows, double target, Vector<double>& du, const Solve& solve) {
    find_right_side(rows, target, du);
    solve();
    follow_velocity(rows, target, du);
  }
  /// Keeps the products of changes.
  void keep_products();
  /// The largest share of the direction that leaves no number negative.
  double longest_step() const;
  /// The mean of p z after that share of the direction.
  double mean_product(double share) const;
  /// Goes that share.
  void go(const ScaledRows<double>& rows, double share);
  /// The impulses of the moment [sqrt(J)], of all rows.
  const Vector<double>& x() const { return x_; }
  /// Bytes of all this.
  std::size_t memory() const;

 private:
  using Side = InteriorSide;
  using Member = InteriorMember;

  static void set_speeds(const ProximalCenter<double>& center, Member& member, double distance);
  void linearize_cone(const ScaledRows<double>& rows, Member& member, double smoothing) const;
  double speed_of(const ScaledRows<double>& rows, int i) const;
  void find_velocity(const ScaledRows<double>& rows);
  void right_sides(const Member& member, double target, double& plus, double& minus) const;
  void find_right_side(const ScaledRows<double>& rows, double target, Vector<double>& right) const;
  void follow_velocity(const ScaledRows<double>& rows, double target, const Vector<double>& du);
  template <typename Visit>
  void for_each_side(const Visit& visit) const;

  List<Member> members_;
  Vector<double> x_;  // impulses of rows
  Vector<double> u_;  // G^T x
};

template <typename Visit>
void InteriorRows::for_each_slope(const ScaledRows<double>& rows, const Visit& visit) const {
  for (const Member& member : members_) {
    const auto normal = rows.terms_of(rows.rows()[member.row]);
    const double a = member.plus_slope, b = member.mixed_slope, c = member.minus_slope;
    visit(normal, normal, a + 2 * b + c);
    if (member.friction < 0) continue;
    const auto tangent = rows.terms_of(rows.rows()[member.friction]);
    const double m = member.ratio, plus = member.lift_slope + 1, minus = member.lift_slope - 1;
    visit(normal, tangent, m * ((a + b) * plus + (b + c) * minus));
    visit(tangent, normal, m * (a - c));
    visit(tangent, tangent, m * m * ((a - b) * plus + (b - c) * minus));
  }
}

}  // namespace cairn
