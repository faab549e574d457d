// Floor 4. The impulses around which rows are made soft.
#pragma once

#include <algorithm>
#include <cmath>

#include <cairn/solvers/exact/scaled_rows.hpp>

namespace cairn {

/// A centre x' inside the bounds of ScaledRows, the velocities u' = G^T x' and w' that come with it, and how
/// far it is from the answer.
template <Scalar Real>
class ProximalCenter {
 public:
  /// Goes to these impulses [N s], brought inside their bounds.
  void go_to(const ScaledRows<Real>& rows, const PerRow<Real>& impulse);
  /// Goes to x, which is inside, with G^T (x - x').
  void go_to(const ScaledRows<Real>& rows, const Vector<Real>& x, const Vector<Real>& change);
  /// Goes on the way that led from x' to x, to where the rows for which is_held(i) have the least w'. Where
  /// anything else has led here, it stays.
  template <typename IsHeld>
  void go_on(const ScaledRows<Real>& rows, const IsHeld& is_held);
  /// Stays, where the rows have changed.
  void stay(const ScaledRows<Real>& rows) {
    look_around(rows);
    forget_way();
  }

  /// x'.
  const Vector<Real>& x() const { return x_; }
  /// u'.
  const Vector<Real>& u() const { return u_; }
  /// w'.
  const Vector<Real>& w() const { return w_; }
  /// |x'|: error() cannot fall below its roundings.
  Real size() const { return size_; }
  /// |x' - clamp(x' - w')|: R_E times its scale.
  Real error() const { return error_; }
  /// The same of one row: the root of the mean of squares.
  Real error_of_a_row() const {
    return error_ / std::sqrt(static_cast<Real>(std::max(x_.size(), Eigen::Index{1})));
  }
  /// How many numbers it keeps.
  Eigen::Index numbers() const {
    return x_.size() + u_.size() + w_.size() + earlier_.size() + earlier_w_.size();
  }

 private:
  void look_around(const ScaledRows<Real>& rows);
  void forget_way() {
    earlier_ = x_;
    earlier_w_ = w_;
  }

  Vector<Real> x_;
  Vector<Real> u_;
  Vector<Real> w_;
  Vector<Real> earlier_;    // x' before the way that led here
  Vector<Real> earlier_w_;  // w' there
  Real size_ = 0;
  Real error_ = 0;
};

template <Scalar Real>
template <typename IsHeld>
void ProximalCenter<Real>::go_on(const ScaledRows<Real>& rows, const IsHeld& is_held) {
  Real along = 0, square = 0;
  for (Eigen::Index i = 0; i < x_.size(); ++i) {
    if (!is_held(static_cast<int>(i))) continue;
    const Real change = w_(i) - earlier_w_(i);
    along -= w_(i) * change;
    square += change * change;
  }
  if (!(along > 0)) return;
  const Real more = along / square;
  u_.setZero();
  rows.for_each_row([&](int i) {
    x_(i) = rows.clamp(i, x_(i) + more * (x_(i) - earlier_(i)), x_);
    rows.terms_of(rows.rows()[i]).add_to(u_, x_(i));
  });
  stay(rows);
}

}  // namespace cairn
