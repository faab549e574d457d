// Floor 4. When to look at what takes longer than a sweep.
#pragma once

#include <limits>

#include <cairn/math/math.hpp>

namespace cairn {

/// After which sweeps R_E is computed where they cost less than it does: after the first, and then where the
/// changes of a sweep are small enough. R_E goes with the size of a sweep's steps: what it was, seen last,
/// says at which size it is computed again, three sweeps and a 16th of all later at the soonest.
template <Scalar Real>
class RareLooks {
 public:
  /// Whether to look after this sweep, whose steps are of this size [sqrt(J)]: the root of the sum of
  /// A_ii step^2.
  bool are_due(int sweep, Real size) const { return sweep >= next_ && !(size > below_); }
  /// After that sweep R_E was `residual`.
  void note(int sweep, Real size, Real residual, Real tolerance) {
    below_ = Real(1.25) * size * tolerance / residual;  // a quarter more: the two do not shrink quite alike
    next_ = sweep + 3 + sweep / 16;  // to look takes as long as two or three sweeps in lanes
  }

 private:
  Real below_ = std::numeric_limits<Real>::infinity();  // [sqrt(J)]
  int next_ = 0;                                        // no sweep before it
};

}  // namespace cairn
