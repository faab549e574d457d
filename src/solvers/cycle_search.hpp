// Floor 4. Whether impulses come back.
#pragma once

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Finds that all impulses are, to the last bit, what they were after an earlier sweep. One remembered state
/// is compared, renewed after sweeps 1, 2, 4, 8 ...: it finds a cycle of any length in memory for one (R. P.
/// Brent, 1980).
template <Scalar Real>
class CycleSearch {
 public:
  /// Nothing is remembered of so many rows. Only sweeps that are a multiple of `stride` apart are alike.
  void begin(int rows, int stride) {
    impulse_.reserve(rows);
    stride_ = stride;
    sweep_ = 0;
    moved_ = false;
  }
  /// After each sweep, counted from 1: whether impulses are those of a sweep that was alike, and have moved
  /// in between. `moved`: in this one, by more than rounding.
  bool comes_back(const PerRow<Real>& impulse, int sweep, bool moved) {
    moved_ = moved_ || moved;
    if (sweep_ > 0 && moved_ && (sweep - sweep_) % stride_ == 0 && impulse == impulse_) return true;
    if (sweep_ == 0 || sweep >= 2 * sweep_) {
      impulse_ = impulse;
      sweep_ = sweep;
      moved_ = false;
    }
    return false;
  }

 private:
  int stride_ = 1;
  PerRow<Real> impulse_;  // [N s] remembered,
  int sweep_ = 0;         // after this sweep, a power of two; 0: nothing is
  bool moved_ = false;    // since then
};

}  // namespace cairn
