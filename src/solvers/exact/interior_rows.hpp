// Floor 4. Rows on the way through the interior of their bounds: the interior point method.
#pragma once

#include "solvers/exact/proximal_rows.hpp"

namespace cairn {

/// The rows of ProximalRows as pairs of numbers that are never negative, an impulse p and a speed z, with
///   p z = mu   for all of them, on the central path,
/// and mu on its way to 0 (S. Mehrotra, On the implementation of a primal-dual interior point method, 1992).
/// A row with one bound has one such pair. A contact with friction has two: its impulse is a sum of the two
/// edges of the cone, p+ (1, m) + p- (1, -m), and z+- = w_n + m |w_t| +- m w_t, where the lift m |w_t| keeps
/// the contact from opening as it slides (G. De Saxce, Z.-Q. Feng, The bipotential method, 1998). Rows
/// without bounds have no z.
///
/// Which rows are at their bounds need not be guessed: where many change at once, 15 to 30 systems lead to
/// the answer, however many they are. Numbers are in sqrt(J), as in ProximalRows.
class InteriorRows {
 public:
  /// Begins from the centre of `rows`, brought so far away from bounds [sqrt(J)]. `rows` must outlive it.
  /// @returns false for rows of other kinds: two bounds, discs, several normals or frictions a contact.
  bool begin(const ProximalRows<double>& rows, double distance);

  /// Holds no rows any more.
  void clear();
  /// Finds what follows from the impulses and speeds of the moment.
  void linearize();
  /// Calls visit(left, right, factor) as ProximalRows does.
  template <typename Visit>
  void for_each_slope(const Visit& visit) const;
  /// Whether that is symmetric: no friction.
  bool has_symmetric_slope() const { return !has_friction_; }
  /// Of no proximal problem.
  double softness() const { return 0; }

  /// The right-hand side of the system for p z = target, without second order or with what keep_products()
  /// has kept.
  void find_right_side(double target, Vector<double>& right) const;
  /// The direction, from its solution.
  void find_direction(double target, const Vector<double>& du);
  /// Keeps the products of changes.
  void keep_products();
  /// The largest share of the direction that leaves no number negative.
  double longest_step() const;
  /// The mean of p z after that share of the direction.
  double mean_product(double share) const;
  /// Goes that share.
  void go(double share);
  /// The impulses of the moment [N s].
  void copy_impulses_to(PerRow<double>& impulse) const;
  /// Bytes of all this.
  std::size_t memory() const;

 private:
  /// One p with its z.
  struct Side {
    double impulse = 0;
    double speed = 0;
    double impulse_change = 0;
    double speed_change = 0;
    double error = 0;    // of the speed, beside what the velocities say
    double product = 0;  // of changes
  };
  /// What a row gives, with its friction where it has some.
  struct Member {
    int row = 0;
    int friction = -1;
    int sides = 1;          // 0: without bounds
    double direction = 1;   // -1: it has an upper bound
    double bound = 0;       // or, without bounds, the impulse itself
    double ratio = 0;       // m
    double lift_slope = 0;  // d|w_t| / dw_t, smooth at 0
    Side plus = {};
    Side minus = {};
    double plus_slope = 0, minus_slope = 0, mixed_slope = 0;  // -dp / dz, with each other
  };
  bool append(int i);
  void pair_friction(int i, bool& fits);
  void set_speeds(Member& member, double distance) const;
  void linearize_cone(Member& member, double smoothing) const;
  double speed_of(int i) const;
  void find_velocity();
  void right_sides(const Member& member, double target, double& plus, double& minus) const;
  template <typename Visit>
  void for_each_side(const Visit& visit) const;

  const ProximalRows<double>* rows_ = nullptr;
  bool has_friction_ = false;
  List<Member> members_;
  List<int> member_of_;  // of each row that is no friction
  Vector<double> x_;     // impulses of rows
  Vector<double> u_;     // G^T x
};

template <typename Visit>
void InteriorRows::for_each_slope(const Visit& visit) const {
  for (const Member& member : members_) {
    const auto normal = rows_->terms_of(rows_->row(member.row));
    const double a = member.plus_slope, b = member.mixed_slope, c = member.minus_slope;
    visit(normal, normal, a + 2 * b + c);
    if (member.friction < 0) continue;
    const auto tangent = rows_->terms_of(rows_->row(member.friction));
    const double m = member.ratio, plus = member.lift_slope + 1, minus = member.lift_slope - 1;
    visit(normal, tangent, m * ((a + b) * plus + (b + c) * minus));
    visit(tangent, normal, m * (a - c));
    visit(tangent, tangent, m * m * ((a - b) * plus + (b - c) * minus));
  }
}

}  // namespace cairn
