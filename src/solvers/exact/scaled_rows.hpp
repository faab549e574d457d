// Floor 4. The rows of a problem without units: what Newton's method computes with.
#pragma once

#include <algorithm>

#include <cairn/constraints/row.hpp>
#include <cairn/solvers/system_matrix.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// A problem in sqrt(J), as in exact_rows.hpp, but row by row and with its equalities: x_i = impulse_i
/// sqrt(A_ii) and u = M^(1/2) (v - v_before), 3 n numbers, so that u = G^T x and w = G u + c x + s. Every row
/// of G has at most the length 1.
template <Scalar Real>
class ScaledRows {
 public:
  /// What a row of G has for one body, not all 0.
  struct Term {
    int body = 0;                           // its number
    Vec3<Real> value = Vec3<Real>::Zero();  // of G, for each axis
  };

  /// A row of G.
  struct Terms : Span<const Term> {
    /// Times u.
    Real product(const Vector<Real>& u) const {
      Real sum = 0;
      for (const Term& term : *this) {
        for (int axis = 0; axis < 3; ++axis) sum += term.value(axis) * u(3 * term.body + axis);
      }
      return sum;
    }
    /// u + G^T of a change of x_i.
    void add_to(Vector<Real>& u, Real change) const {
      for (const Term& term : *this) {
        for (int axis = 0; axis < 3; ++axis) u(3 * term.body + axis) += term.value(axis) * change;
      }
    }
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
  /// 3 n.
  Eigen::Index freedoms() const { return 3 * root_.size(); }
  /// Whether any of them has bounds.
  bool have_bounds() const { return have_bounds_; }
  /// All rows of the problem, in its order.
  const PerRow<Row>& rows() const { return rows_; }
  /// What a row of G has.
  Terms terms_of(const Row& row) const { return {{terms_.data() + row.first, row.count}}; }
  /// The value nearest to `wish` that row i may have beside the others.
  Real clamp(int i, Real wish, const Vector<Real>& x) const {
    const Row& row = rows_[i];
    if (row.unit == 0) return 0;
    if (row.bounds.is_friction()) return clamp_friction(row, wish, x);
    return std::max(std::min(wish, row.bounds.upper), row.bounds.lower);
  }
  /// Calls visit(i) for all rows, those that limit others before them.
  template <typename Visit>
  void for_each_row(const Visit& visit) const {
    for (int i = 0; i < rows_.size(); ++i)
      if (!is_late(i)) visit(i);
    for (const int i : late_) visit(i);
  }
  /// The impulses [N s] that x means.
  void copy_impulses(const Vector<Real>& x, PerRow<Real>& impulse) const;
  /// v [m/s, m/s, rad/s] of a body after u, if it was `before` without.
  Vec3<Real> velocity_of(BodyId body, const Vec3<Real>& before, const Vector<Real>& u) const {
    return before + root_[body].cwiseProduct(u.template segment<3>(3 * body.index));
  }
  /// Bytes of all this.
  std::size_t memory() const { return terms_.bytes() + rows_.bytes() + late_.bytes() + root_.bytes(); }

 private:
  void append(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row);
  void measure_scale(const VelocityProblem<Real>& problem);
  Real clamp_friction(const Row& row, Real wish, const Vector<Real>& x) const;
  /// Whether row i is limited by one behind it.
  bool is_late(int i) const {
    return std::max(rows_[i].bounds.normal_row, rows_[i].bounds.second_normal_row) > i;
  }

  Real scale_ = 0;
  bool have_bounds_ = false;
  List<Term> terms_;
  PerRow<Row> rows_;
  List<int> late_;            // rows that are limited by one behind them
  PerBody<Vec3<Real>> root_;  // of each body's inverse mass
};

}  // namespace cairn
