// Floor 4. Lays two equality rows out for sweeps.
#include <cairn/solvers/iterative/equality_pair.hpp>

namespace cairn {

template <Scalar Real>
bool EqualityPair<Real>::begin(const VelocityProblem<Real>& problem, int first, int second) {
  const ConstraintRow<Real>&one = problem.rows[first], &other = problem.rows[second];
  if (one.a != other.a || one.b != other.b || one.a == one.b) return false;
  if (one.extra_count > 0 || other.extra_count > 0) return false;
  a_ = one.a;
  b_ = one.b;
  first_ = first;
  second_ = second;
  for (int axis = 0; axis < 3; ++axis) {
    jacobian_a_[axis] = {one.jacobian_a(axis), other.jacobian_a(axis)};
    jacobian_b_[axis] = {one.jacobian_b(axis), other.jacobian_b(axis)};
  }
  bias_ = {one.bias, other.bias};
  softness_ = {one.softness, other.softness};
  const auto entry = [&](const ConstraintRow<Real>& row, const ConstraintRow<Real>& column) {
    const Vec3<Real> of_a = problem.inverse_mass[a_].cwiseProduct(row.jacobian_a);
    const Vec3<Real> of_b = problem.inverse_mass[b_].cwiseProduct(row.jacobian_b);
    return dot(of_a, column.jacobian_a) + dot(of_b, column.jacobian_b);
  };
  const Real A_11 = entry(one, one) + one.softness, A_22 = entry(other, other) + other.softness;
  const Real A_21 = entry(other, one);
  if (!(A_11 > BlockFactor<Real>::singular_share(2) * A_11)) return false;
  inverse_pivot_(0) = 1 / A_11;
  lower_ = A_21 * inverse_pivot_(0);
  const Real pivot = A_22 - lower_ * A_21;
  if (!(pivot > BlockFactor<Real>::singular_share(2) * A_22)) return false;
  inverse_pivot_(1) = 1 / pivot;
  return true;
}

template class EqualityPair<float>;
template class EqualityPair<double>;

}  // namespace cairn
