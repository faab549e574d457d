// Floor 4. Newton's method on rows that are a little soft: what newton() and NewtonSolver share.
#pragma once

#include <cairn/solvers/exact/proximal_map.hpp>

namespace cairn {

/// Seeks du with F(du) = 0 of a ProximalMap, by steps du - share * change. Who asks says where a change comes
/// from: factors of the moment, or older ones.
template <Scalar Real>
class NewtonSteps {
 public:
  /// Where steps are taken.
  struct Place {
    const ScaledRows<Real>& rows;        // that are solved
    const ProximalCenter<Real>& center;  // around which they are soft
    ProximalMap<Real>& map;              // its last evaluation is the answer
  };

  /// Calls step() from du = 0 on, so many times at most, until |F| is small; step() says whether it helped.
  /// @returns whether |F| is small.
  template <typename Step>
  bool solve(const Place& at, Real small, int most_steps, const Step& step) {
    du_.setZero(at.rows.freedoms());
    error_ = at.map.evaluate(at.rows, at.center);
    for (int i = 0; i < most_steps && error_ > small; ++i)
      if (!step()) return false;
    return error_ <= small;
  }
  /// The whole step, where that leaves so much of |F| at most; else nothing has changed, and it is false.
  bool leap(const Place& at, const Vector<Real>& change, Real share_left);
  /// A share of the step that makes |F| fall: the largest of 1, 1/2, 1/4 ...; false: none does.
  bool shorten(const Place& at, const Vector<Real>& change, Real least_share);
  /// How many numbers it keeps.
  Eigen::Index numbers() const { return du_.size() + next_.size(); }

 private:
  Vector<Real> du_;
  Vector<Real> next_;  // where it may go
  Real error_ = 0;     // |F(du)|
};

}  // namespace cairn
