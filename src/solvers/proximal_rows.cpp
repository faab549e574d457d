// Floor 4. Impulses as functions of velocities.
#include "solvers/proximal_rows.hpp"

#include <cmath>

namespace cairn {

ProximalRows::ProximalRows(const VelocityProblem<long double>& problem)
    : freedoms_(3 * problem.body_count()) {
  for (const ConstraintRow<long double>& row : problem.rows) {
    const long double inverse = inverse_effective_mass(problem, row);
    const long double unit = inverse > 0 ? 1 / std::sqrt(inverse) : 0.0L;
    Row scaled{.first = static_cast<int>(terms_.size()),
               .softness = unit * unit * row.softness,
               .constant = unit * (row_velocity(problem, row) - row.bias),
               .unit = unit,
               .bounds = row.bounds};
    if (!row.bounds.is_friction() && unit > 0) {
      scaled.bounds.lower /= unit;
      scaled.bounds.upper /= unit;
    }
    for_each_term(problem, row, [&](BodyId body, const Vec3<long double>& jacobian) {
      const Vec3<long double>& mass = problem.inverse_mass[static_cast<std::size_t>(body.index)];
      for (int axis = 0; axis < 3; ++axis) {
        const long double value = unit * std::sqrt(mass(axis)) * jacobian(axis);
        if (value != 0) terms_.push_back({3 * body.index + axis, value});
      }
    });
    scaled.count = static_cast<int>(terms_.size()) - scaled.first;
    rows_.push_back(scaled);
  }
  const auto m = static_cast<Eigen::Index>(rows_.size());
  x_ = wish_ = center_ = center_w_ = Vector<long double>::Zero(m);
  value_ = Vector<long double>::Zero(freedoms_);
}

long double ProximalRows::product(const Row& row, const Vector<long double>& u) const {
  long double sum = 0;
  for (int k = row.first; k < row.first + row.count; ++k) {
    const Term& term = terms_[static_cast<std::size_t>(k)];
    sum += term.value * u(term.column);
  }
  return sum;
}

long double ProximalRows::clamp(std::size_t i, long double wish, const Vector<long double>& x) const {
  const Row& row = rows_[i];
  if (row.unit == 0) return 0;
  const Bounds<long double>& bounds = row.bounds;
  if (!bounds.is_friction()) return std::max(std::min(wish, bounds.upper), bounds.lower);
  const auto impulse_of = [&](int other) {
    return other == Bounds<long double>::none ? 0.0L : rows_[static_cast<std::size_t>(other)].unit * x(other);
  };
  const long double first = impulse_of(bounds.normal_row);
  long double limit =
      bounds.friction * (std::max(first, 0.0L) + std::max(impulse_of(bounds.second_normal_row), 0.0L));
  if (bounds.disc > 0) limit = std::sqrt(std::max(bounds.disc * bounds.disc - first * first, 0.0L));
  limit /= row.unit;
  return std::max(std::min(wish, limit), -limit);
}

void ProximalRows::center_at(const std::vector<long double>& impulse) {
  Vector<long double> u = Vector<long double>::Zero(freedoms_);
  for_each_row([&](std::size_t i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Row& row = rows_[i];
    center_(at) = clamp(i, row.unit > 0 ? impulse[i] / row.unit : 0.0L, center_);
    for (int k = row.first; k < row.first + row.count; ++k) {
      const Term& term = terms_[static_cast<std::size_t>(k)];
      u(term.column) += term.value * center_(at);
    }
  });
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    center_w_(at) = product(rows_[i], u) + rows_[i].softness * center_(at) + rows_[i].constant;
  }
}

long double ProximalRows::error() const {
  long double sum = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const long double e = center_(at) - clamp(i, center_(at) - center_w_(at), center_);
    sum += e * e;
  }
  return std::sqrt(sum);
}

const Vector<long double>& ProximalRows::evaluate(const Vector<long double>& du) {
  value_ = du;
  for_each_row([&](std::size_t i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Row& row = rows_[i];
    wish_(at) = center_(at) - (center_w_(at) + product(row, du)) / (epsilon_ + row.softness);
    x_(at) = clamp(i, wish_(at), x_);
    const long double change = x_(at) - center_(at);
    if (change == 0) return;
    for (int k = row.first; k < row.first + row.count; ++k) {
      const Term& term = terms_[static_cast<std::size_t>(k)];
      value_(term.column) -= term.value * change;
    }
  });
  return value_;
}

long double ProximalRows::slope_of_limit(std::size_t i, int other) const {
  const Row& row = rows_[i];
  const Row& normal = rows_[static_cast<std::size_t>(other)];
  const long double x = x_(other), side = wish_(static_cast<Eigen::Index>(i)) > 0 ? 1 : -1;
  if (x != wish_(other)) return 0;  // held at a bound: the limit does not change
  const long double ratio = side * normal.unit / row.unit;
  if (!(row.bounds.disc > 0)) return x > 0 ? ratio * row.bounds.friction : 0.0L;
  const long double impulse = normal.unit * x;
  const long double left = row.bounds.disc * row.bounds.disc - impulse * impulse;
  return left > 0 ? -ratio * impulse / std::sqrt(left) : 0.0L;
}

void ProximalRows::append_product(const Row& row, const Row& column, long double factor,
                                  std::vector<MatrixEntry>& entries) const {
  for (int k = row.first; k < row.first + row.count; ++k) {
    const Term& left = terms_[static_cast<std::size_t>(k)];
    for (int l = column.first; l < column.first + column.count; ++l) {
      const Term& right = terms_[static_cast<std::size_t>(l)];
      const long double value = factor * left.value * right.value;
      entries.push_back({left.column, right.column, static_cast<double>(value)});
    }
  }
}

void ProximalRows::append_slope(std::vector<MatrixEntry>& entries) const {
  for (int k = 0; k < static_cast<int>(freedoms_); ++k) entries.push_back({k, k, 1});
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Row& row = rows_[i];
    if (row.unit == 0) continue;
    if (x_(at) == wish_(at)) {
      append_product(row, row, 1 / (epsilon_ + row.softness), entries);
    } else if (row.bounds.is_friction()) {
      for (const int other : {row.bounds.normal_row, row.bounds.second_normal_row}) {
        if (other == Bounds<long double>::none) continue;
        const Row& normal = rows_[static_cast<std::size_t>(other)];
        if (normal.unit == 0) continue;
        const long double slope = slope_of_limit(i, other);
        if (slope != 0) append_product(row, normal, slope / (epsilon_ + normal.softness), entries);
      }
    }
  }
}

std::vector<long double> ProximalRows::impulses() const {
  std::vector<long double> impulse;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    impulse.push_back(rows_[i].unit * x_(static_cast<Eigen::Index>(i)));
  return impulse;
}

}  // namespace cairn
