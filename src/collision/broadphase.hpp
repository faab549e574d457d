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
  /// Of one step. The contacts of a pair take about 1 kB, with their rows and what is seen of them: so many
  /// come to 1 GB. 20 000 bodies in a heap are some 60 000 pairs, or 1400 in one place a million.
  static constexpr int max_pairs = 1'000'000;

  /// Finds pairs in the given way.
  explicit Broadphase(BroadphaseKind kind = BroadphaseKind::all_pairs) : kind_(kind) {}

  /// All (i, j), i < j, whose boxes overlap, in ascending order: the same list for every kind. Pairs for
  /// which both `movable[i]` and `movable[j]` are false are left out.
  /// @throws std::length_error for more than max_pairs pairs.
  const List<std::pair<int, int>>& pairs(Span<const Aabb<Real>> boxes, Span<const char> movable);

 private:
  BroadphaseKind kind_;
  List<int> order_;
  List<std::pair<int, int>> pairs_;
};

}  // namespace cairn
