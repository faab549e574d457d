// Floor 3. One scalar constraint as a solver sees it, and the problem that all of them make together.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

#include "dynamics/body.hpp"

namespace cairn {

/// The interval that an impulse may take (paper, end of 2.2). For friction the interval depends on the
/// impulse of another row: that coupling is data, so that every solver treats it in the same way.
template <Scalar Real>
struct Bounds {
  static constexpr int none = -1;

  Real lower = -std::numeric_limits<Real>::infinity();  // [N s]
  Real upper = std::numeric_limits<Real>::infinity();   // [N s]
  Real friction = 0;                                    // mu
  int normal_row = none;                                // the row whose impulse times mu is the limit

  static Bounds equality() { return {}; }
  static Bounds unilateral() { return {.lower = 0}; }
  static Bounds at_most(Real limit) { return {.lower = -limit, .upper = limit}; }
  static Bounds coulomb(Real mu, int normal) { return {.friction = mu, .normal_row = normal}; }

  bool is_equality() const { return normal_row == none && lower == -upper && lower < -max_finite(); }
  bool is_unilateral() const { return normal_row == none && lower == 0; }
  bool is_friction() const { return normal_row != none; }

  /// The value of the interval nearest to x, at the impulses as they are now. A NaN stays a NaN.
  Real clamp(Real x, const std::vector<Real>& impulse) const {
    if (normal_row == none) return std::max(std::min(x, upper), lower);
    const Real limit = friction * std::max(impulse[static_cast<std::size_t>(normal_row)], Real(0));
    return std::max(std::min(x, limit), -limit);
  }

 private:
  static constexpr Real max_finite() { return std::numeric_limits<Real>::max(); }
};

/// Names an impulse across steps, so that a row finds last step's value even when other rows have come or
/// gone (paper 2.3). Ordered: joints first, then contacts.
struct RowKey {
  std::uint64_t source = 0;  // which joint, or which two colliders
  std::uint64_t part = 0;    // which of its rows: feature id, limit, motor ...
  auto operator<=>(const RowKey&) const = default;
};

/// One row: j v + softness * impulse = bias, with the impulse inside its bounds. j has six numbers, three for
/// each of two bodies; all other entries of a row of J (6) are zero.
template <Scalar Real>
struct ConstraintRow {
  BodyId a = {};
  BodyId b = {};
  Vec3<Real> jacobian_a = Vec3<Real>::Zero();  // j (5): 1, 1, m for a length; 0, 0, 1 for an angle
  Vec3<Real> jacobian_b = Vec3<Real>::Zero();
  Real bias = 0;      // zeta (7): the value j v should take [m/s or rad/s]
  Real softness = 0;  // gamma (paper 4.3) [1/kg]; 0: rigid
  Bounds<Real> bounds = {};
  RowKey key = {};
};

/// The rows that one joint or manifold wrote: consecutive, solved together by solvers that can.
struct RowBlock {
  int first = 0;
  int count = 0;
};

/// All that a solver needs to know of one step, and all that it answers: a plain value.
/// n bodies, m rows.
template <Scalar Real>
struct VelocityProblem {
  std::vector<ConstraintRow<Real>> rows = {};  // m
  std::vector<RowBlock> blocks = {};           // cover all rows
  std::vector<Vec3<Real>> inverse_mass = {};   // n, the diagonal of M^-1 (2)
  std::vector<Vec3<Real>> velocity = {};       // n; in: v_1 with gravity already applied; out: v_2 (11)
  std::vector<Real> impulse = {};              // m [N s]; in: warm start; out: the answer
  Real dt = 1;                                 // [s]; the paper's lambda is impulse / dt

  int row_count() const { return static_cast<int>(rows.size()); }
  int body_count() const { return static_cast<int>(velocity.size()); }
};

/// j v: how fast the row's error changes.
template <Scalar Real>
Real row_velocity(const ConstraintRow<Real>& row, const std::vector<Vec3<Real>>& velocity) {
  return row.jacobian_a.dot(velocity[static_cast<std::size_t>(row.a.index)]) +
         row.jacobian_b.dot(velocity[static_cast<std::size_t>(row.b.index)]);
}

/// v += M^-1 j^T p: gives the row's two bodies the impulse p [N s] (paper (19), (21)).
template <Scalar Real>
void apply_impulse(const ConstraintRow<Real>& row, Real p, const std::vector<Vec3<Real>>& inverse_mass,
                   std::vector<Vec3<Real>>& velocity) {
  const auto a = static_cast<std::size_t>(row.a.index);
  const auto b = static_cast<std::size_t>(row.b.index);
  velocity[a] += inverse_mass[a].cwiseProduct(row.jacobian_a) * p;
  velocity[b] += inverse_mass[b].cwiseProduct(row.jacobian_b) * p;
}

/// j M^-1 j^T + gamma: A_ii of (15), the inverse of the effective mass [1/kg].
template <Scalar Real>
Real inverse_effective_mass(const ConstraintRow<Real>& row, const std::vector<Vec3<Real>>& inverse_mass) {
  const auto a = static_cast<std::size_t>(row.a.index);
  const auto b = static_cast<std::size_t>(row.b.index);
  return row.jacobian_a.dot(inverse_mass[a].cwiseProduct(row.jacobian_a)) +
         row.jacobian_b.dot(inverse_mass[b].cwiseProduct(row.jacobian_b)) + row.softness;
}

}  // namespace cairn
