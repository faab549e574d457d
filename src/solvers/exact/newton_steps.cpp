// Floor 4. Steps that are taken, shortened or refused.
#include <cairn/solvers/exact/newton_steps.hpp>

namespace cairn {

template <Scalar Real>
bool NewtonSteps<Real>::leap(const Place& at, const Vector<Real>& change, Real share_left) {
  next_ = du_ - change;
  const Real left = at.map.evaluate(at.rows, at.center, next_);
  if (left <= share_left * error_) {
    du_.swap(next_);
    error_ = left;
    return true;
  }
  at.map.evaluate(at.rows, at.center, du_);
  return false;
}

template <Scalar Real>
bool NewtonSteps<Real>::shorten(const Place& at, const Vector<Real>& change, Real least_share) {
  for (Real share = 1; share >= least_share; share /= 2) {
    next_ = du_ - share * change;
    const Real left = at.map.evaluate(at.rows, at.center, next_);
    if (!(left < (1 - share / 10000) * error_)) continue;
    du_.swap(next_);
    error_ = left;
    return true;
  }
  return false;
}

template class NewtonSteps<double>;
template class NewtonSteps<long double>;

}  // namespace cairn
