// Floor 4. Impulses, and what is left of their rows.
#include <cairn/solvers/exact/proximal_center.hpp>

namespace cairn {

template <Scalar Real>
void ProximalCenter<Real>::go_to(const ScaledRows<Real>& rows, const PerRow<Real>& impulse) {
  x_.resize(rows.rows().size());
  u_.setZero(rows.freedoms());
  rows.for_each_row([&](int i) {
    const auto& row = rows.rows()[i];
    x_(i) = rows.clamp(i, row.unit > 0 ? impulse[i] / row.unit : Real(0), x_);
    rows.terms_of(row).add_to(u_, x_(i));
  });
  stay(rows);
}

template <Scalar Real>
void ProximalCenter<Real>::go_to(const ScaledRows<Real>& rows, const Vector<Real>& x,
                                 const Vector<Real>& change) {
  earlier_.swap(x_);
  earlier_w_.swap(w_);
  x_ = x;
  u_ += change;
  look_around(rows);
}

/// w' and the error at x'.
template <Scalar Real>
void ProximalCenter<Real>::look_around(const ScaledRows<Real>& rows) {
  w_.resize(x_.size());
  Real errors = 0, impulses = 0;
  for (int i = 0; i < rows.rows().size(); ++i) {
    const auto& row = rows.rows()[i];
    const Real x = x_(i), w = rows.terms_of(row).product(u_) + row.softness * x + row.constant;
    const Real e = x - rows.clamp(i, x - w, x_);
    w_(i) = w;
    errors += e * e;
    impulses += x * x;
  }
  error_ = std::sqrt(errors);
  size_ = std::sqrt(impulses);
}

template class ProximalCenter<double>;
template class ProximalCenter<long double>;

}  // namespace cairn
