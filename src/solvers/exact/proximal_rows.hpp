// Floor 4. Rows made a little soft around the impulses of the moment: what Newton's method solves.
#pragma once

#include <algorithm>
#include <cmath>

#include "constraints/row.hpp"
#include "solvers/system_matrix.hpp"
#include "math/list.hpp"

namespace cairn {

/// A problem in sqrt(J), as in exact_rows.hpp, but row by row and with its equalities: x_i = impulse_i
/// sqrt(A_ii) and u = M^(1/2) (v - v_before), 3 n numbers, so that u = G^T x and w = G u + c x + s. Every row
/// of G has at most the length 1.
///
/// Around a centre x', with rows softer by epsilon,
///   x_i(u) = clamp(x'_i - (w'_i + (G du)_i) / (epsilon + c_i)),   du = u - G^T x',
/// says of every velocity which impulses it calls for, friction after the normal impulses that limit it. So
/// impulses can be eliminated, however many depend on each other: what is left is to find du with
///   F(du) = du - G^T (x(du) - x') = 0.
/// F is piecewise linear but for discs; without friction it is the gradient of a strongly convex function.
template <Scalar Real>
class ProximalRows {
 public:
  /// What a row of G has for one body, not all 0.
  struct Term {
    int body = 0;                           // its number
    Vec3<Real> value = Vec3<Real>::Zero();  // of G, for each axis
  };

  /// What a row has.
  struct Row {
    int first = 0;             // of its terms
    int count = 0;             // of them
    Real softness = 0;         // c
    Real constant = 0;         // s
    Real unit = 0;             // impulse = unit * x; 0: the row can do nothing
    Bounds<Real> bounds = {};  // in sqrt(J); those of friction and its disc as they were [N s]
  };

  /// Keeps what it needs of the problem, in memory that is used again; its impulses are not looked at.
  void begin(const VelocityProblem<Real>& problem);
  /// The same where biases and velocities alone have changed; false: softness has, and begin() is needed.
  bool begin_again(const VelocityProblem<Real>& problem);
  /// exact_scale of the problem.
  Real scale() const { return scale_; }

  /// Takes x' from impulses [N s], brought inside their bounds.
  void center_at(const PerRow<Real>& impulse);
  /// Takes x' from the last evaluation, and the velocities that come with it.
  void center_at_last();
  /// x' goes on the way that center_at_last() took it, to where the rows that are held have the least w'.
  /// Where anything else set x', it stays.
  void go_on();
  /// Keeps x' where begin_again() has changed the rows.
  void keep_center() {
    look_around();
    forget_way();
  }
  /// x' [N s].
  void copy_center_to(PerRow<Real>& impulse) const { copy_impulses(center_, impulse); }
  /// v [m/s, m/s, rad/s] of a body after the impulses x', if it was `before` without them.
  Vec3<Real> center_velocity(BodyId body, const Vec3<Real>& before) const {
    return before + root_[body].cwiseProduct(center_u_.template segment<3>(3 * body.index));
  }
  /// |x'|: error() cannot fall below its roundings.
  Real center_size() const { return center_size_; }
  /// How soft the rows are from now on.
  void soften(Real epsilon) { epsilon_ = epsilon; }
  /// How soft they are.
  Real softness() const { return epsilon_; }

  /// m: all rows of the problem, in its order.
  int row_count() const { return rows_.size(); }
  /// What row i has.
  const Row& row(int i) const { return rows_[i]; }
  /// What a row of G has.
  Span<const Term> terms_of(const Row& row) const { return {terms_.data() + row.first, row.count}; }
  /// A row of G times u.
  Real product(const Row& row, const Vector<Real>& u) const {
    Real sum = 0;
    for (const Term& term : terms_of(row)) {
      for (int axis = 0; axis < 3; ++axis) sum += term.value(axis) * u(3 * term.body + axis);
    }
    return sum;
  }
  /// u + G^T of a row's change.
  void add_to(Vector<Real>& u, const Row& row, Real change) const {
    for (const Term& term : terms_of(row)) {
      for (int axis = 0; axis < 3; ++axis) u(3 * term.body + axis) += term.value(axis) * change;
    }
  }
  /// x'_i.
  Real center(int i) const { return center_(i); }
  /// w'_i.
  Real center_speed(int i) const { return center_w_(i); }

  /// 3 n: the numbers of du.
  Eigen::Index freedoms() const { return freedoms_; }
  /// |x - clamp(x - w)| at the centre: R_E times its scale.
  Real error() const { return error_; }
  /// The same of one row: the root of the mean of squares.
  Real error_of_a_row() const { return error_ / std::sqrt(std::max(Real(rows_.size()), Real(1))); }
  /// F(du).
  const Vector<Real>& evaluate(const Vector<Real>& du);
  /// F(0).
  const Vector<Real>& evaluate_at_center();
  /// F of the last evaluation.
  const Vector<Real>& value() const { return value_; }
  /// Calls visit(left, right, factor), each side the terms of a row: dF/du at the last evaluation is the
  /// identity and the sum of factor left right^T.
  template <typename Visit>
  void for_each_slope(const Visit& visit) const;
  /// Whether that is symmetric: no row slides at a limit that follows another row's impulse.
  bool has_symmetric_slope() const;
  /// Calls visit(terms) for the terms of every row.
  template <typename Visit>
  void for_each_terms(const Visit& visit) const {
    for (const Row& row : rows_) visit(terms_of(row));
  }
  /// Bytes of all this.
  std::size_t memory() const;
  /// x(du) of the last evaluation [N s].
  void copy_impulses_to(PerRow<Real>& impulse) const { copy_impulses(x_, impulse); }

 private:
  void append(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row);
  void measure_scale(const VelocityProblem<Real>& problem);
  template <typename ProductOf>
  void respond(const ProductOf& product_of);
  void copy_impulses(const Vector<Real>& x, PerRow<Real>& impulse) const;
  void look_around();
  void forget_way() {
    earlier_ = center_;
    earlier_w_ = center_w_;
  }
  Real clamp(int i, Real wish, const Vector<Real>& x) const {
    const Row& row = rows_[i];
    if (row.unit == 0) return 0;
    if (row.bounds.is_friction()) return clamp_friction(row, wish, x);
    return std::max(std::min(wish, row.bounds.upper), row.bounds.lower);
  }
  Real clamp_friction(const Row& row, Real wish, const Vector<Real>& x) const;
  /// d clamp / d x_other, at the end that `wish` is beyond.
  Real slope_of_limit(int i, int other) const;
  /// Whether row i is limited by one behind it.
  bool is_late(int i) const {
    return std::max(rows_[i].bounds.normal_row, rows_[i].bounds.second_normal_row) > i;
  }
  /// Calls visit(i) for all rows, those that limit others before them.
  template <typename Visit>
  void for_each_row(const Visit& visit) const {
    for (int i = 0; i < rows_.size(); ++i)
      if (!is_late(i)) visit(i);
    for (const int i : late_) visit(i);
  }

  Eigen::Index freedoms_ = 0;
  Real epsilon_ = 1;
  Real scale_ = 0;
  Real error_ = 0;  // at the centre
  Real center_size_ = 0;
  List<int> late_;  // rows that are limited by one behind them
  List<Term> terms_;
  PerRow<Row> rows_;
  PerBody<Vec3<Real>> root_;  // of each body's inverse mass
  Vector<Real> center_;       // x'
  Vector<Real> center_u_;     // G^T x'
  Vector<Real> center_w_;     // w'
  Vector<Real> earlier_;      // x' before the last evaluation became it
  Vector<Real> earlier_w_;    // w' there
  Vector<Real> x_;            // of the last evaluation
  Vector<Real> wish_;         // the same before clamping
  Vector<Real> response_;     // G^T (x - x')
  Vector<Real> value_;        // F
};

template <Scalar Real>
template <typename Visit>
void ProximalRows<Real>::for_each_slope(const Visit& visit) const {
  for (int i = 0; i < rows_.size(); ++i) {
    const auto at = i;
    const Row& row = rows_[i];
    if (row.unit == 0) continue;
    if (x_(at) == wish_(at)) {
      visit(terms_of(row), terms_of(row), 1 / (epsilon_ + row.softness));
    } else if (row.bounds.is_friction()) {
      for (const int other : {row.bounds.normal_row, row.bounds.second_normal_row}) {
        if (other == Bounds<Real>::none) continue;
        const Row& normal = rows_[other];
        if (normal.unit == 0) continue;
        const Real slope = slope_of_limit(i, other);
        if (slope != 0) visit(terms_of(row), terms_of(normal), slope / (epsilon_ + normal.softness));
      }
    }
  }
}

}  // namespace cairn
