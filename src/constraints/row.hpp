// Floor 3. One scalar constraint as a solver sees it, and the problem that all of them make together.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

#include <cairn/constraints/contact.hpp>
#include <cairn/constraints/row_rule.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The number of a row, from 0. Any int will do: this type keeps arrays over rows apart from other arrays.
enum RowNumber : int {};

/// One element for each row.
template <typename T>
using PerRow = IndexedVector<T, RowNumber>;

/// The interval that an impulse may take (paper, end of 2.2). For friction the interval depends on the
/// impulse of another row: that coupling is data, so that every solver treats it in the same way. The other
/// row is that of the normal impulse; or, where two rows of friction share a disc, the first of the two: the
/// second may have what the first has left of it.
template <Scalar Real>
struct Bounds {
  /// Stands for no row.
  static constexpr int none = -1;

  Real lower = -std::numeric_limits<Real>::infinity();  // [N s]
  Real upper = std::numeric_limits<Real>::infinity();   // [N s]
  Real friction = 0;                                    // mu
  Real disc = 0;                                        // [N s] radius; 0: no disc
  int normal_row = none;                                // the row whose impulse sets the limit
  int second_normal_row = none;                         // adds its impulse, where friction is one row for two

  /// No bounds: an equality.
  static Bounds equality() { return {}; }
  /// An impulse >= 0 [N s]: the row only pushes.
  static Bounds unilateral() { return {.lower = 0}; }
  /// An impulse of either sign, up to `limit` [N s].
  static Bounds at_most(Real limit) { return {.lower = -limit, .upper = limit}; }
  /// Up to `mu` times the impulse of row `normal`, or of two rows together.
  static Bounds coulomb(Real mu, int normal, int second_normal = none) {
    return {.friction = mu, .normal_row = normal, .second_normal_row = second_normal};
  }
  /// What row `first` leaves of a disc of this radius [N s].
  static Bounds rest_of_disc(Real radius, int first) { return {.disc = radius, .normal_row = first}; }

  /// Whether any impulse is allowed.
  bool is_equality() const { return normal_row == none && lower == -upper && lower < -max_finite(); }
  /// Whether the row only pushes.
  bool is_unilateral() const { return normal_row == none && lower == 0; }
  /// Whether the impulse of another row sets the limit.
  bool is_friction() const { return normal_row != none; }

  /// Rows are counted from `first` now, instead of from 0.
  void shift(int first) {
    if (normal_row != none) normal_row += first;
    if (second_normal_row != none) second_normal_row += first;
  }

  /// The value of the interval nearest to x, at the impulses as they are now. A NaN stays a NaN.
  Real clamp(Real x, const PerRow<Real>& impulse) const {
    if (normal_row == none) return std::max(std::min(x, upper), lower);
    const Real limit = limit_beside(impulse);
    return std::max(std::min(x, limit), -limit);
  }

 private:
  /// What the impulse of the other row leaves, or gives.
  Real limit_beside(const PerRow<Real>& impulse) const {
    const Real other = impulse[normal_row];
    if (disc > 0) {
      const Real used = std::min(std::abs(other), disc);
      return std::sqrt((disc - used) * (disc + used));
    }
    Real load = std::max(other, Real(0));
    if (second_normal_row != none) {
      load += std::max(impulse[second_normal_row], Real(0));
    }
    return friction * load;
  }
  static constexpr Real max_finite() { return std::numeric_limits<Real>::max(); }
};

/// Names an impulse across steps, so that a row finds last step's value even when other rows have come or
/// gone (paper 2.3). Ordered: joints first, then contacts.
struct RowKey {
  std::uint64_t source = 0;  // which joint, or which two colliders
  std::uint64_t part = 0;    // which of its rows: feature id, limit, motor ...
  /// By source, then by part.
  auto operator<=>(const RowKey&) const = default;
};

/// What a row has for one body: three entries of J (6).
template <Scalar Real>
struct RowTerm {
  BodyId body = {};                          // on which it acts
  Vec3<Real> jacobian = Vec3<Real>::Zero();  // j of that body, as in ConstraintRow
};

/// One row: j v + softness * impulse = bias, with the impulse inside its bounds. j has six numbers, three for
/// each of two bodies; all other entries of a row of J (6) are zero, but for those of the rare row that holds
/// more than two bodies (paper 4.3): they stand in the problem's extra_terms.
template <Scalar Real>
struct ConstraintRow {
  BodyId a = {};                               // the first body
  BodyId b = {};                               // the second body
  Vec3<Real> jacobian_a = Vec3<Real>::Zero();  // j (5): 1, 1, m for a length; 0, 0, 1 for an angle
  Vec3<Real> jacobian_b = Vec3<Real>::Zero();  // the same for b
  Real bias = 0;                               // zeta (7): the value j v should take [m/s or rad/s]
  Real softness = 0;                           // gamma (paper 4.3) [1/kg]; 0: rigid
  Bounds<Real> bounds = {};                    // of the impulse [N s]
  RowKey key = {};                             // its name in the next step
  int first_extra = 0;                         // its terms of further bodies, in extra_terms
  int extra_count = 0;                         // how many there are
};

/// What a row is in the second solve of the policies relaxed and soft.
template <Scalar Real>
struct SecondRow {
  Real bias = 0;      // [m/s or rad/s]
  Real softness = 0;  // [1/kg]
};

/// The rows of one joint or contact: consecutive, solved together by solvers that can.
struct RowBlock {
  int first = 0;  // its first row
  int count = 0;  // of rows
  /// Those of a contact whose friction has a row at each point.
  bool of_contact = false;
};

/// Two problems of one number differ in nothing but biases, softness, impulses and velocities: of what it
/// made from the first, a solver may keep the rest. 0 says nothing. A copy of a problem has none, for anybody
/// may change a copy; who changes more of a problem than that renews its number.
class ProblemNumber {
 public:
  /// None.
  ProblemNumber() = default;
  /// None.
  ProblemNumber(const ProblemNumber&) {}
  /// None.
  ProblemNumber& operator=(const ProblemNumber&) {
    value_ = 0;
    return *this;
  }
  /// Gives it one that no problem has had.
  void renew() {
    static std::atomic<std::uint64_t> last = 0;
    value_ = ++last;
  }
  /// 0: none.
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

/// All that a solver needs to know of one step, and all that it answers: a plain value.
/// n bodies, m rows: those of joints first, then those of contacts. A problem that has rows is what they say;
/// only a solver that takes contacts (Solver::takes_contacts()) is given one without the rows of these.
template <Scalar Real>
struct VelocityProblem {
  PerRow<ConstraintRow<Real>> rows = {};                 // m; or those of joints alone
  List<RowBlock> blocks = {};                            // cover all m rows, written or not
  List<RowTerm<Real>> extra_terms = {};                  // of rows on more than two bodies; most have none
  List<Contact<Real>> contacts = {};                     // of the last blocks; none where it was made by hand
  RowRule<Real> rule = {};                               // how errors of contacts go
  FrictionRows friction_rows = FrictionRows::per_point;  // of contacts
  PerBody<Real> surface_speed = {};                      // n [m/s]; none where no surface runs
  PerBody<Real> rolling_resistance = {};                 // n [m]; none where nothing resists rolling
  bool is_second = false;                 // the second solve: of what contacts ask for only rebounds stay
  PerBody<Vec3<Real>> inverse_mass = {};  // n, the diagonal of M^-1 (2)
  PerBody<Vec3<Real>> velocity = {};      // n; in: v_1 with gravity already applied; out: v_2 (11)
  PerRow<Real> impulse = {};              // m [N s]; in: warm start; out: the answer
  Real dt = 1;                            // [s]; the paper's lambda is impulse / dt
  ProblemNumber number = {};              // of its rows and masses

  /// How many are written: m, but for a solver that takes contacts.
  int row_count() const { return rows.size(); }
  /// n, with the ground.
  int body_count() const { return velocity.size(); }
  /// How many blocks are those of joints and of the hand.
  int joint_blocks() const { return blocks.size() - contacts.size(); }
  /// How many rows these have.
  int joint_rows() const { return rows_in(joint_blocks()); }
  /// Whether all rows are written.
  bool has_rows() const { return rows.size() >= rows_in(blocks.size()); }
  /// In the first so many blocks.
  int rows_in(int count) const { return count == 0 ? 0 : blocks[count - 1].first + blocks[count - 1].count; }
};

/// Calls visit(BodyId, jacobian) for every body of a row beyond its two.
template <Scalar Real, typename Row, typename Visit>
void for_each_extra_term(const VelocityProblem<Real>& problem, const Row& row, const Visit& visit) {
  for (int k = row.first_extra; k < row.first_extra + row.extra_count; ++k) {
    const RowTerm<Real>& term = problem.extra_terms[k];
    visit(term.body, term.jacobian);
  }
}

/// Calls visit(BodyId, jacobian) for every body of a row.
template <Scalar Real, typename Visit>
void for_each_term(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, const Visit& visit) {
  visit(row.a, row.jacobian_a);
  visit(row.b, row.jacobian_b);
  for_each_extra_term(problem, row, visit);
}

/// j v: how fast the row's error changes, at these velocities.
template <Scalar Real>
Real row_velocity(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row,
                  const PerBody<Vec3<Real>>& velocity) {
  Real jv = dot(row.jacobian_a, velocity[row.a]) + dot(row.jacobian_b, velocity[row.b]);
  for_each_extra_term(problem, row,
                      [&](BodyId body, const Vec3<Real>& jacobian) { jv += dot(jacobian, velocity[body]); });
  return jv;
}

/// j v at the problem's own velocities.
template <Scalar Real>
Real row_velocity(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
  return row_velocity(problem, row, problem.velocity);
}

/// v += M^-1 j^T p: gives the bodies of one of the problem's rows the impulse p [N s] (paper (19), (21)).
template <Scalar Real>
void apply_impulse(VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, Real p) {
  const BodyId a = row.a, b = row.b;
  problem.velocity[a] += problem.inverse_mass[a].cwiseProduct(row.jacobian_a) * p;
  problem.velocity[b] += problem.inverse_mass[b].cwiseProduct(row.jacobian_b) * p;
  for_each_extra_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
    problem.velocity[body] += problem.inverse_mass[body].cwiseProduct(jacobian) * p;
  });
}

/// Gives every row the impulse that it has: a warm start, or (12) from the velocities before the solve.
template <Scalar Real>
void apply_impulses(VelocityProblem<Real>& problem) {
  for (int i = 0; i < problem.row_count(); ++i) {
    apply_impulse(problem, problem.rows[i], problem.impulse[i]);
  }
}

/// j M^-1 j^T + gamma: A_ii of (15), the inverse of the effective mass [1/kg].
template <Scalar Real>
Real inverse_effective_mass(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
  Real sum = 0;
  for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
    sum += dot<Real>(jacobian, problem.inverse_mass[body].cwiseProduct(jacobian));
  });
  return sum + row.softness;
}

/// 1 / A_ii [kg]; 0 between immovable bodies, where nothing can be done.
template <Scalar Real>
Real effective_mass(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
  const Real inverse = inverse_effective_mass(problem, row);
  return inverse > 0 ? 1 / inverse : Real(0);
}

}  // namespace cairn
