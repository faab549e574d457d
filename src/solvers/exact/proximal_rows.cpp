// Floor 4. Impulses as functions of velocities.
#include "solvers/exact/proximal_rows.hpp"
#include "math/list.hpp"

#include <cmath>

namespace cairn {

template <Scalar Real>
void ProximalRows<Real>::begin(const VelocityProblem<Real>& problem) {
  freedoms_ = 3 * problem.body_count();
  epsilon_ = 1;
  root_.clear();
  for (const Vec3<Real>& mass : problem.inverse_mass) root_.push_back(mass.cwiseSqrt());
  terms_.clear();
  rows_.clear();
  for (const ConstraintRow<Real>& row : problem.rows) append(problem, row);
  const int m = rows_.size();
  x_ = wish_ = center_ = center_w_ = Vector<Real>::Zero(m);
  value_ = center_u_ = Vector<Real>::Zero(freedoms_);
  measure_scale(problem);
}

template <Scalar Real>
void ProximalRows<Real>::append(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
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
    const Vec3<Real> value = (unit * root_[body]).cwiseProduct(jacobian);
    if (!value.isZero(0)) terms_.push_back({body.index, value});
  });
  scaled.count = terms_.size() - scaled.first;
  rows_.push_back(scaled);
}

/// As exact_scale, from the rows as they are here.
template <Scalar Real>
void ProximalRows<Real>::measure_scale(const VelocityProblem<Real>& problem) {
  Real wishes = 0, speeds = 0, energy = 0;
  for (const Row& row : rows_) {
    if (row.unit == 0) continue;
    speeds += row.constant * row.constant;
    if (row.bounds.is_friction()) continue;
    const Real wish = std::max(std::min(-row.constant, row.bounds.upper), row.bounds.lower);
    wishes += wish * wish;
  }
  for (const BodyId body : problem.velocity.indices()) {
    for (int axis = 0; axis < 3; ++axis) {
      const Real inverse = problem.inverse_mass[body](axis), speed = problem.velocity[body](axis);
      if (inverse > 0) energy += speed * speed / inverse;
    }
  }
  scale_ = std::max({std::sqrt(wishes), Real(1e-12) * std::sqrt(energy), Real(1e-3) * std::sqrt(speeds)});
}

template <Scalar Real>
Real ProximalRows<Real>::product(const Row& row, const Vector<Real>& u) const {
  Real sum = 0;
  for (const Term& term : terms_of(row)) {
    for (int axis = 0; axis < 3; ++axis) sum += term.value(axis) * u(3 * term.body + axis);
  }
  return sum;
}

template <Scalar Real>
void ProximalRows<Real>::add_to(Vector<Real>& u, const Row& row, Real change) const {
  for (const Term& term : terms_of(row)) {
    for (int axis = 0; axis < 3; ++axis) u(3 * term.body + axis) += term.value(axis) * change;
  }
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
  center_on([&](int i) { return impulse[i]; });
}

template <Scalar Real>
void ProximalRows<Real>::center_at_last() {
  center_on([&](int i) { return rows_[i].unit * x_(i); });
}

template <Scalar Real>
template <typename ImpulseOf>
void ProximalRows<Real>::center_on(const ImpulseOf& impulse_of) {
  center_u_.setZero();
  for_each_row([&](int i) {
    const Row& row = rows_[i];
    center_(i) = clamp(i, row.unit > 0 ? impulse_of(i) / row.unit : Real(0), center_);
    add_to(center_u_, row, center_(i));
  });
  Real sum = 0;
  for (int i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    center_w_(i) = product(row, center_u_) + row.softness * center_(i) + row.constant;
    const Real e = center_(i) - clamp(i, center_(i) - center_w_(i), center_);
    sum += e * e;
  }
  error_ = std::sqrt(sum);
}

template <Scalar Real>
const Vector<Real>& ProximalRows<Real>::evaluate(const Vector<Real>& du) {
  value_ = du;
  for_each_row([&](int i) {
    const Row& row = rows_[i];
    wish_(i) = center_(i) - (center_w_(i) + product(row, du)) / (epsilon_ + row.softness);
    x_(i) = clamp(i, wish_(i), x_);
    const Real change = x_(i) - center_(i);
    if (change != 0) add_to(value_, row, -change);
  });
  return value_;
}

template <Scalar Real>
bool ProximalRows<Real>::has_symmetric_slope() const {
  bool is_symmetric = true;
  for_each_slope([&](const auto& left, const auto& right, Real) {
    if (left.data() != right.data()) is_symmetric = false;
  });
  return is_symmetric;
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
void ProximalRows<Real>::copy_impulses(const Vector<Real>& x, PerRow<Real>& impulse) const {
  impulse.resize(rows_.size());
  for (int i = 0; i < rows_.size(); ++i) impulse[i] = rows_[i].unit * x(i);
}

template <Scalar Real>
std::size_t ProximalRows<Real>::memory() const {
  const Eigen::Index numbers =
      center_.size() + center_u_.size() + center_w_.size() + x_.size() + wish_.size() + value_.size();
  return terms_.bytes() + rows_.bytes() + root_.bytes() + static_cast<std::size_t>(numbers) * sizeof(Real);
}

template class ProximalRows<double>;
template class ProximalRows<long double>;

}  // namespace cairn
