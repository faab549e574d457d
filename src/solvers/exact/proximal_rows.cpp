// Floor 4. Impulses as functions of velocities.
#include "solvers/exact/proximal_rows.hpp"
#include "math/list.hpp"

#include <cmath>

namespace cairn {

template <Scalar Real>
void ProximalRows<Real>::begin(const VelocityProblem<Real>& problem) {
  freedoms_ = 3 * problem.body_count();
  epsilon_ = 1;
  terms_.clear();
  rows_.clear();
  for (const ConstraintRow<Real>& row : problem.rows) {
    const Real inverse = inverse_effective_mass(problem, row);
    const Real unit = inverse > 0 ? 1 / std::sqrt(inverse) : Real(0);
    Row scaled{.first = terms_.size(),
               .softness = unit * unit * row.softness,
               .constant = unit * (row_velocity(problem, row) - row.bias),
               .unit = unit,
               .bounds = row.bounds};
    if (!row.bounds.is_friction() && unit > 0) {
      scaled.bounds.lower /= unit;
      scaled.bounds.upper /= unit;
    }
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      const Vec3<Real>& mass = problem.inverse_mass[body];
      for (int axis = 0; axis < 3; ++axis) {
        const Real value = unit * std::sqrt(mass(axis)) * jacobian(axis);
        if (value != 0) terms_.push_back({3 * body.index + axis, value});
      }
    });
    scaled.count = terms_.size() - scaled.first;
    rows_.push_back(scaled);
  }
  const int m = rows_.size();
  x_ = wish_ = center_ = center_w_ = Vector<Real>::Zero(m);
  value_ = Vector<Real>::Zero(freedoms_);
}

template <Scalar Real>
Real ProximalRows<Real>::product(const Row& row, const Vector<Real>& u) const {
  Real sum = 0;
  for (int k = row.first; k < row.first + row.count; ++k) {
    const Term& term = terms_[k];
    sum += term.value * u(term.column);
  }
  return sum;
}

template <Scalar Real>
Real ProximalRows<Real>::clamp(int i, Real wish, const Vector<Real>& x) const {
  const Row& row = rows_[i];
  if (row.unit == 0) return 0;
  const Bounds<Real>& bounds = row.bounds;
  if (!bounds.is_friction()) return std::max(std::min(wish, bounds.upper), bounds.lower);
  const auto impulse_of = [&](int other) {
    return other == Bounds<Real>::none ? Real(0) : rows_[other].unit * x(other);
  };
  const Real first = impulse_of(bounds.normal_row);
  Real limit =
      bounds.friction * (std::max(first, Real(0)) + std::max(impulse_of(bounds.second_normal_row), Real(0)));
  if (bounds.disc > 0) limit = std::sqrt(std::max(bounds.disc * bounds.disc - first * first, Real(0)));
  limit /= row.unit;
  return std::max(std::min(wish, limit), -limit);
}

template <Scalar Real>
void ProximalRows<Real>::center_at(const PerRow<Real>& impulse) {
  Vector<Real> u = Vector<Real>::Zero(freedoms_);
  for_each_row([&](int i) {
    const auto at = i;
    const Row& row = rows_[i];
    center_(at) = clamp(i, row.unit > 0 ? impulse[i] / row.unit : Real(0), center_);
    for (int k = row.first; k < row.first + row.count; ++k) {
      const Term& term = terms_[k];
      u(term.column) += term.value * center_(at);
    }
  });
  for (int i = 0; i < rows_.size(); ++i) {
    const auto at = i;
    center_w_(at) = product(rows_[i], u) + rows_[i].softness * center_(at) + rows_[i].constant;
  }
}

template <Scalar Real>
Real ProximalRows<Real>::error() const {
  Real sum = 0;
  for (int i = 0; i < rows_.size(); ++i) {
    const auto at = i;
    const Real e = center_(at) - clamp(i, center_(at) - center_w_(at), center_);
    sum += e * e;
  }
  return std::sqrt(sum);
}

template <Scalar Real>
const Vector<Real>& ProximalRows<Real>::evaluate(const Vector<Real>& du) {
  value_ = du;
  for_each_row([&](int i) {
    const auto at = i;
    const Row& row = rows_[i];
    wish_(at) = center_(at) - (center_w_(at) + product(row, du)) / (epsilon_ + row.softness);
    x_(at) = clamp(i, wish_(at), x_);
    const Real change = x_(at) - center_(at);
    if (change == 0) return;
    for (int k = row.first; k < row.first + row.count; ++k) {
      const Term& term = terms_[k];
      value_(term.column) -= term.value * change;
    }
  });
  return value_;
}

template <Scalar Real>
Real ProximalRows<Real>::slope_of_limit(int i, int other) const {
  const Row& row = rows_[i];
  const Row& normal = rows_[other];
  const Real x = x_(other), side = wish_(i) > 0 ? 1 : -1;
  if (x != wish_(other)) return 0;  // held at a bound: the limit does not change
  const Real ratio = side * normal.unit / row.unit;
  if (!(row.bounds.disc > 0)) return x > 0 ? ratio * row.bounds.friction : Real(0);
  const Real impulse = normal.unit * x;
  const Real left = row.bounds.disc * row.bounds.disc - impulse * impulse;
  return left > 0 ? -ratio * impulse / std::sqrt(left) : Real(0);
}

template <Scalar Real>
PerRow<Real> ProximalRows<Real>::impulses_of(const Vector<Real>& x) const {
  PerRow<Real> impulse;
  for (int i = 0; i < rows_.size(); ++i) impulse.push_back(rows_[i].unit * x(i));
  return impulse;
}

template class ProximalRows<double>;
template class ProximalRows<long double>;

}  // namespace cairn
