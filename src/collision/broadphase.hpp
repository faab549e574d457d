// Floor 2. Broadphase: which bounding boxes overlap.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/aabb.hpp"

namespace cairn {

/// all_pairs compares every two boxes: best for a few. sweep sorts along the wider axis and compares
/// neighbours.
enum class BroadphaseKind { all_pairs, sweep };

/// Finds overlapping pairs. Holds scratch memory only, so that a steady step allocates nothing.
template <Scalar Real>
class Broadphase {
 public:
  /// Finds pairs in the given way.
  explicit Broadphase(BroadphaseKind kind = BroadphaseKind::all_pairs) : kind_(kind) {}

  /// All (i, j), i < j, whose boxes overlap, in ascending order: the same list for every kind. Pairs for
  /// which both `movable[i]` and `movable[j]` are false are left out.
  const std::vector<std::pair<int, int>>& pairs(std::span<const Aabb<Real>> boxes,
                                                std::span<const char> movable);

 private:
  BroadphaseKind kind_;
  std::vector<int> order_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace cairn
