// Floor 4. Two equality rows between two bodies, laid out for sweeps.
#pragma once

#include <algorithm>
#include <cmath>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>
#include <cairn/solvers/iterative/block_solve.hpp>

namespace cairn {

/// The two rows of a pin, or any other two equality rows of a block without further bodies, side by side: all
/// that a sweep needs of them lies in one place, and what is done for both rows is done at once. What
/// BlockFactor and BlockSequentialImpulse do for such a block, in the same order: the same numbers to the
/// last bit.
template <Scalar Real>
class EqualityPair {
 public:
  /// False where the rows do not share two bodies, hold a further one, or cannot be told apart.
  bool begin(const VelocityProblem<Real>& problem, int first, int second);
  /// Where nothing but the biases of the rows has changed.
  void take_bias(const VelocityProblem<Real>& problem) {
    bias_ = {problem.rows[first_].bias, problem.rows[second_].bias};
  }
  /// (22) for both rows; returns the larger change of their impulses [N s].
  Real update(VelocityProblem<Real>& problem, Real relaxation) const;
  /// From the velocity errors of the rows to the changes of their impulses.
  void solve(Real& first, Real& second) const {
    second -= lower_ * first;
    first *= inverse_pivot_(0);
    second *= inverse_pivot_(1);
    first -= lower_ * second;
  }

 private:
  using Two = Vec2<Real>;
  /// Of both rows, for each axis of a body.
  using Columns = FixedList<Two, 3>;

  /// In the order of dot().
  static Two product(const Columns& jacobian, const Vec3<Real>& v) {
    const Two x = jacobian[0] * v.x(), y = jacobian[1] * v.y(), z = jacobian[2] * v.z();
    if constexpr (std::same_as<Real, double>) return (x + y) + z;
    return x + (y + z);
  }
  [[gnu::always_inline]] static Vec3<Real> pushed(const Columns& jacobian, const Vec3<Real>& inverse_mass,
                                                  const Two& p, const Vec3<Real>& v) {
    const Two x = (inverse_mass(0) * jacobian[0]).cwiseProduct(p);
    const Two y = (inverse_mass(1) * jacobian[1]).cwiseProduct(p);
    const Two z = (inverse_mass(2) * jacobian[2]).cwiseProduct(p);
    return {(v(0) + x(0)) + x(1), (v(1) + y(0)) + y(1), (v(2) + z(0)) + z(1)};
  }

  BodyId a_ = {};
  BodyId b_ = {};
  int first_ = 0;
  int second_ = 0;
  Columns jacobian_a_ = {};
  Columns jacobian_b_ = {};
  Two bias_ = Two::Zero();
  Two softness_ = Two::Zero();
  Two inverse_pivot_ = Two::Zero();  // of D, in A_BB = L D L^T
  Real lower_ = 0;                   // of L
};

template <Scalar Real>
[[gnu::always_inline]] inline Real EqualityPair<Real>::update(VelocityProblem<Real>& problem,
                                                              Real relaxation) const {
  const Vec3<Real> v_a = problem.velocity[a_], v_b = problem.velocity[b_];
  const Two old = {problem.impulse[first_], problem.impulse[second_]};
  const Two jv = product(jacobian_a_, v_a) + product(jacobian_b_, v_b);
  Two change = bias_ - jv - softness_.cwiseProduct(old);
  solve(change(0), change(1));
  const Two now = old + change * relaxation;
  const Two given = now - old;
  problem.impulse[first_] = now(0);
  problem.impulse[second_] = now(1);
  problem.velocity[a_] = pushed(jacobian_a_, problem.inverse_mass[a_], given, v_a);  // (19), (21)
  problem.velocity[b_] = pushed(jacobian_b_, problem.inverse_mass[b_], given, v_b);
  return std::max(std::max(Real(0), std::abs(given(0))), std::abs(given(1)));
}

}  // namespace cairn
