// Floor 2. Broadphase: which bounding boxes overlap.
#pragma once

#include <utility>

#include "geometry/aabb.hpp"
#include "math/list.hpp"

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
  const List<std::pair<int, int>>& pairs(Span<const Aabb<Real>> boxes, Span<const char> movable);

 private:
  BroadphaseKind kind_;
  List<int> order_;
  List<std::pair<int, int>> pairs_;
};

}  // namespace cairn
