// Floor 4. Impulses as functions of velocities.
#include "solvers/exact/proximal_rows.hpp"
#include "math/list.hpp"

#include <cmath>

namespace cairn {

template <Scalar Real>
void ProximalRows<Real>::begin(const VelocityProblem<Real>& problem) {
  freedoms_ = 3 * problem.body_count();
  epsilon_ = 1;
  late_.clear();
  root_.clear();
  for (const Vec3<Real>& mass : problem.inverse_mass) root_.push_back(mass.cwiseSqrt());
  terms_.clear();
  rows_.clear();
  for (const ConstraintRow<Real>& row : problem.rows) append(problem, row);
  for (Vector<Real>* one : {&x_, &wish_, &center_, &center_w_, &earlier_, &earlier_w_}) one->resize(rows_.size());
  for (Vector<Real>* one : {&value_, &response_, &center_u_}) one->resize(freedoms_);
  measure_scale(problem);
}

template <Scalar Real>
bool ProximalRows<Real>::begin_again(const VelocityProblem<Real>& problem) {
  if (rows_.size() != problem.row_count() || root_.size() != problem.body_count()) return false;
  epsilon_ = 1;
  for (int i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    if (row.unit * row.unit * problem.rows[i].softness != row.softness) return false;
    row.constant = row.unit * (row_velocity(problem, problem.rows[i]) - problem.rows[i].bias);
  }
  measure_scale(problem);
  return true;
}

template <Scalar Real>
void ProximalRows<Real>::append(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
  const int first = terms_.size();
  Real inverse = row.softness, jv = 0;  // A_ii, and j v
  const auto take_term = [&](BodyId body, const Vec3<Real>& jacobian) __attribute__((always_inline)) {
    const Vec3<Real> value = root_[body].cwiseProduct(jacobian);
    jv += dot(jacobian, problem.velocity[body]);
    if (value.isZero(0)) return;
    inverse += dot(value, value);
    terms_.push_back({body.index, value});
  };
  take_term(row.a, row.jacobian_a);
  take_term(row.b, row.jacobian_b);
  for_each_extra_term(problem, row, take_term);
  const Real unit = inverse > 0 ? 1 / std::sqrt(inverse) : Real(0);
  for (int k = first; k < terms_.size(); ++k) terms_[k].value *= unit;
  Row& scaled = rows_.emplace_back();
  scaled.first = first;
  scaled.count = terms_.size() - first;
  scaled.softness = unit * unit * row.softness;
  scaled.constant = unit * (jv - row.bias);
  scaled.unit = unit;
  scaled.bounds = row.bounds;
  if (is_late(rows_.size() - 1)) late_.push_back(rows_.size() - 1);
  if (row.bounds.is_equality() || row.bounds.is_friction() || !(unit > 0)) return;
  scaled.bounds.lower /= unit;
  scaled.bounds.upper /= unit;
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
Real ProximalRows<Real>::clamp_friction(const Row& row, Real wish, const Vector<Real>& x) const {
  const Bounds<Real>& bounds = row.bounds;
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
  center_u_.setZero();
  for_each_row([&](int i) {
    const Row& row = rows_[i];
    center_(i) = clamp(i, row.unit > 0 ? impulse[i] / row.unit : Real(0), center_);
    add_to(center_u_, row, center_(i));
  });
  look_around();
  forget_way();
}

template <Scalar Real>
void ProximalRows<Real>::center_at_last() {
  earlier_.swap(center_);
  earlier_w_.swap(center_w_);
  center_ = x_;
  center_u_ += response_;
  look_around();
}

template <Scalar Real>
void ProximalRows<Real>::go_on() {
  Real along = 0, square = 0;
  for (int i = 0; i < rows_.size(); ++i) {
    if (rows_[i].unit == 0 || x_(i) != wish_(i)) continue;
    const Real change = center_w_(i) - earlier_w_(i);
    along -= center_w_(i) * change;
    square += change * change;
  }
  if (!(along > 0)) return;
  const Real more = along / square;
  center_u_.setZero();
  for_each_row([&](int i) {
    center_(i) = clamp(i, center_(i) + more * (center_(i) - earlier_(i)), center_);
    add_to(center_u_, rows_[i], center_(i));
  });
  look_around();
  forget_way();
}

/// w' and the error at x'.
template <Scalar Real>
void ProximalRows<Real>::look_around() {
  Real errors = 0, impulses = 0;
  for (int i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const Real x = center_(i), w = product(row, center_u_) + row.softness * x + row.constant;
    const Real e = x - clamp(i, x - w, center_);
    center_w_(i) = w;
    errors += e * e;
    impulses += x * x;
  }
  error_ = std::sqrt(errors);
  center_size_ = std::sqrt(impulses);
}

template <Scalar Real>
const Vector<Real>& ProximalRows<Real>::evaluate(const Vector<Real>& du) {
  respond([&](const Row& row) { return product(row, du); });
  value_ = du - response_;
  return value_;
}

template <Scalar Real>
const Vector<Real>& ProximalRows<Real>::evaluate_at_center() {
  respond([](const Row&) { return Real(0); });
  value_ = -response_;
  return value_;
}

/// x(du), and the velocities that come with it. product_of(row) is G du.
template <Scalar Real>
template <typename ProductOf>
void ProximalRows<Real>::respond(const ProductOf& product_of) {
  response_.setZero();
  for_each_row([&](int i) {
    const Row& row = rows_[i];
    wish_(i) = center_(i) - (center_w_(i) + product_of(row)) / (epsilon_ + row.softness);
    x_(i) = clamp(i, wish_(i), x_);
    const Real change = x_(i) - center_(i);
    if (change != 0) add_to(response_, row, change);
  });
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
  const Eigen::Index numbers = center_.size() + center_u_.size() + center_w_.size() + x_.size() +
                               wish_.size() + response_.size() + value_.size() + earlier_.size() +
                               earlier_w_.size();
  return terms_.bytes() + rows_.bytes() + root_.bytes() + static_cast<std::size_t>(numbers) * sizeof(Real);
}

template class ProximalRows<double>;
template class ProximalRows<long double>;

}  // namespace cairn
