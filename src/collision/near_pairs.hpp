// Floor 2. Which bounding boxes are near each other: a list that outlives the step.
#pragma once

#include <utility>

#include <cairn/collision/broadphase.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps the pairs of boxes that are near each other while the boxes move.
///
/// Each box lies in a proxy, a box that is larger by a tenth of its longer side all around; or no larger, as
/// long as the box has not moved: scenery may be so long that a tenth of it holds everything. The pairs are
/// those whose proxies overlap, so that the list stays as it is until a box leaves its proxy, or needs far
/// less of it: a new proxy is put around that box, and its pairs are found anew. Every two boxes that overlap
/// are in the list; which others are depends on where the boxes were before. Source: the fat boxes of E.
/// Catto's Box2D (2007).
template <Scalar Real>
class NearPairs {
 public:
  /// Of no boxes.
  NearPairs() = default;
  /// Pairs for which both `movable[i]` and `movable[j]` are false are never in the list.
  NearPairs(BroadphaseKind kind, List<char> movable);

  /// Takes in where the boxes are now, one for each entry of `movable`. True where the list has changed.
  /// @throws std::length_error for more than Broadphase::max_pairs pairs.
  bool update(Span<const Aabb<Real>> boxes);
  /// Begins with a list that was made by another, ascending; the next update finds all pairs anew.
  void begin_with(List<std::pair<int, int>> pairs) {
    pairs_ = std::move(pairs);
    is_current_ = false;
  }
  /// All (i, j), i < j, that are near, in ascending order.
  const List<std::pair<int, int>>& pairs() const { return pairs_; }

 private:
  void find_pairs_of_moved();

  Broadphase<Real> proxies_;
  List<char> movable_;
  List<std::pair<int, int>> pairs_;
  bool is_current_ = false;  // pairs_ are those of proxies_

  // Scratch memory.
  List<int> moved_;      // boxes that have left their proxies, ascending
  List<char> is_moved_;  // of each box
  List<std::pair<int, int>> found_, next_;
};

}  // namespace cairn
