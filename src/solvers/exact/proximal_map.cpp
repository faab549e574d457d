// Floor 4. Impulses as functions of velocities.
#include <cairn/solvers/exact/proximal_map.hpp>

#include <cmath>

namespace cairn {

template <Scalar Real>
Real ProximalMap<Real>::evaluate(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center,
                                 const Vector<Real>& du) {
  respond(rows, center, [&](const auto& row) { return rows.terms_of(row).product(du); });
  value_ = du - response_;
  return value_.norm();
}

template <Scalar Real>
Real ProximalMap<Real>::evaluate(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center) {
  respond(rows, center, [](const auto&) { return Real(0); });
  value_ = -response_;
  return value_.norm();
}

/// x(du), and the velocities that come with it. product_of(row) is G du.
template <Scalar Real>
template <typename ProductOf>
void ProximalMap<Real>::respond(const ScaledRows<Real>& rows, const ProximalCenter<Real>& center,
                                const ProductOf& product_of) {
  x_.resize(rows.rows().size());
  wish_.resize(rows.rows().size());
  response_.setZero(rows.freedoms());
  rows.for_each_row([&](int i) {
    const auto& row = rows.rows()[i];
    wish_(i) = center.x()(i) - (center.w()(i) + product_of(row)) / (epsilon_ + row.softness);
    x_(i) = rows.clamp(i, wish_(i), x_);
    const Real change = x_(i) - center.x()(i);
    if (change != 0) rows.terms_of(row).add_to(response_, change);
  });
}

template <Scalar Real>
bool ProximalMap<Real>::has_symmetric_slope(const ScaledRows<Real>& rows) const {
  bool is_symmetric = true;
  for_each_slope(rows, [&](const auto& left, const auto& right, Real) {
    if (left.data() != right.data()) is_symmetric = false;
  });
  return is_symmetric;
}

/// d clamp / d x_other, at the end that the wish of row i is beyond.
template <Scalar Real>
Real ProximalMap<Real>::slope_of_limit(const ScaledRows<Real>& rows, int i, int other) const {
  const auto& row = rows.rows()[i];
  const auto& normal = rows.rows()[other];
  if (!is_held(other)) return 0;  // the limit does not change
  const Real x = x_(other), ratio = (wish_(i) > 0 ? normal.unit : -normal.unit) / row.unit;
  if (!(row.bounds.disc > 0)) return x > 0 ? ratio * row.bounds.friction : Real(0);
  const Real impulse = normal.unit * x;
  const Real left = row.bounds.disc * row.bounds.disc - impulse * impulse;
  return left > 0 ? -ratio * impulse / std::sqrt(left) : Real(0);
}

template class ProximalMap<double>;
template class ProximalMap<long double>;

}  // namespace cairn
