// Floor 4. Rows made a little soft around a centre: what Newton's method solves.
#pragma once

#include <cairn/solvers/exact/proximal_center.hpp>

namespace cairn {

/// Around a centre x', with rows softer by epsilon,
///   x_i(u) = clamp(x'_i - (w'_i + (G du)_i) / (epsilon + c_i)),   du = u - G^T x',
/// says of every velocity which impulses it calls for, friction after the normal impulses that limit it. So
/// impulses can be eliminated, however many depend on each other: what is left is to find du with
///   F(du) = du - G^T (x(du) - x') = 0.
/// F is piecewise linear but for discs; without friction it is the gradient of a strongly convex function.
template <Scalar Real>
class ProximalMap {
 public:
  /// How soft the rows are from now on.
  void soften(Real epsilon) { epsilon_ = epsilon; }
  /// How soft they are.
  Real softness() const { return epsilon_; }

  /// |F(du)|, and all that follows is of this evaluation.
  Real evaluate(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center, const Vector<Real>& du);
  /// |F(0)|.
  Real evaluate(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center);
  /// F.
  const Vector<Real>& value() const { return value_; }
  /// x(du).
  const Vector<Real>& x() const { return x_; }
  /// G^T (x(du) - x').
  const Vector<Real>& response() const { return response_; }
  /// Whether row i is at none of its bounds.
  bool is_held(int i) const { return x_(i) == wish_(i); }
  /// Calls visit(left, right, factor), each side the terms of a row: dF/du is the identity and the sum of
  /// factor left right^T.
  template <typename Visit>
  void for_each_slope(const ScaledRows<Real>& rows, const Visit& visit) const;
  /// Whether that is symmetric: no row slides at a limit that follows another row's impulse.
  bool has_symmetric_slope(const ScaledRows<Real>& rows) const;
  /// How many numbers it keeps.
  Eigen::Index numbers() const { return x_.size() + wish_.size() + response_.size() + value_.size(); }

 private:
  template <typename ProductOf>
  void respond(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center, const ProductOf& product_of);
  Real slope_of_limit(const ScaledRows<Real>& rows, int i, int other) const;

  Real epsilon_ = 1;
  Vector<Real> x_;
  Vector<Real> wish_;  // the same before clamping
  Vector<Real> response_;
  Vector<Real> value_;
};

template <Scalar Real>
template <typename Visit>
void ProximalMap<Real>::for_each_slope(const ScaledRows<Real>& rows, const Visit& visit) const {
  for (int i = 0; i < rows.rows().size(); ++i) {
    const auto& row = rows.rows()[i];
    if (row.unit == 0) continue;
    const auto terms = rows.terms_of(row);
    if (is_held(i)) {
      visit(terms, terms, 1 / (epsilon_ + row.softness));
    } else if (row.bounds.is_friction()) {
      for (const int other : {row.bounds.normal_row, row.bounds.second_normal_row}) {
        if (other == Bounds<Real>::none || rows.rows()[other].unit == 0) continue;
        const auto& normal = rows.rows()[other];
        const Real slope = slope_of_limit(rows, i, other);
        if (slope != 0) visit(terms, rows.terms_of(normal), slope / (epsilon_ + normal.softness));
      }
    }
  }
}

}  // namespace cairn
