// Floor 4. Rows lose their units.
#include <cairn/solvers/exact/scaled_rows.hpp>

#include <cmath>

namespace cairn {

template <Scalar Real>
void ScaledRows<Real>::begin(const VelocityProblem<Real>& problem) {
  have_bounds_ = false;
  late_.clear();
  root_.clear();
  for (const Vec3<Real>& mass : problem.inverse_mass) root_.push_back(mass.cwiseSqrt());
  terms_.clear();
  rows_.clear();
  for (const ConstraintRow<Real>& row : problem.rows) append(problem, row);
  measure_scale(problem);
}

template <Scalar Real>
bool ScaledRows<Real>::begin_again(const VelocityProblem<Real>& problem) {
  if (rows_.size() != problem.row_count() || root_.size() != problem.body_count()) return false;
  for (int i = 0; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    if (row.unit * row.unit * problem.rows[i].softness != row.softness) return false;
    row.constant = row.unit * (row_velocity(problem, problem.rows[i]) - problem.rows[i].bias);
  }
  measure_scale(problem);
  return true;
}

template <Scalar Real>
void ScaledRows<Real>::append(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
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
  have_bounds_ = have_bounds_ || !row.bounds.is_equality();
  if (is_late(rows_.size() - 1)) late_.push_back(rows_.size() - 1);
  if (row.bounds.is_equality() || row.bounds.is_friction() || !(unit > 0)) return;
  scaled.bounds.lower /= unit;
  scaled.bounds.upper /= unit;
}

/// As exact_scale, from the rows as they are here.
template <Scalar Real>
void ScaledRows<Real>::measure_scale(const VelocityProblem<Real>& problem) {
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
Real ScaledRows<Real>::clamp_friction(const Row& row, Real wish, const Vector<Real>& x) const {
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
void ScaledRows<Real>::copy_impulses(const Vector<Real>& x, PerRow<Real>& impulse) const {
  impulse.resize(rows_.size());
  for (int i = 0; i < rows_.size(); ++i) impulse[i] = rows_[i].unit * x(i);
}

template class ScaledRows<double>;
template class ScaledRows<long double>;

}  // namespace cairn
