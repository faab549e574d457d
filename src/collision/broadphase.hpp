// Floor 2. Broadphase: which bounding boxes overlap.
#pragma once

#include <cstdint>
#include <utility>

#include <cairn/geometry/aabb.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// all_pairs compares every two boxes: best for a few. grid compares boxes of neighbouring cells: its cost
/// grows as the number of boxes does, wherever they lie.
enum class BroadphaseKind { all_pairs, grid };

/// Boxes that may be moved one by one, and what overlaps each. Takes no memory but where their number
/// changes.
///
/// The grid has a level for each power of two: a box lies in the cell of its lower corner, on the level whose
/// cells are just larger than it is. What it may overlap on a level then has its lower corner at most one
/// cell before the box. Cells are found by a hash of their level and place
/// (M. Teschner and others, 2003; C. Ericson, Real-Time Collision Detection, 2005, 7.2).
template <Scalar Real>
class Broadphase {
 public:
  /// Of one step. The contacts of a pair take about 1 kB, with their rows and what is seen of them: so many
  /// come to 1 GB. 20 000 bodies in a heap are some 60 000 pairs, or 1400 in one place a million.
  static constexpr int max_pairs = 1'000'000;

  /// Finds pairs in the given way.
  explicit Broadphase(BroadphaseKind kind = BroadphaseKind::all_pairs) : kind_(kind) {}

  /// So many boxes, all of which are then to be put somewhere.
  void reset(int count);
  /// Puts box number i there.
  void put(int i, const Aabb<Real>& box);
  /// Where box i is.
  const Aabb<Real>& box(int i) const { return places_[i].box; }
  /// The other boxes that overlap box i, in no order: until this is called again.
  const List<int>& overlapping(int i);

  /// All (i, j), i < j, whose boxes overlap, in ascending order: the same list for every kind. Pairs for
  /// which both `movable[i]` and `movable[j]` are false are left out.
  /// @throws std::length_error for more than max_pairs pairs.
  const List<std::pair<int, int>>& pairs(Span<const Aabb<Real>> boxes, Span<const char> movable);

  /// @throws std::length_error for more than max_pairs pairs.
  static void require_few(int pairs);

 private:
  static constexpr int nowhere = -1;  // no box, no level

  struct Place {
    Aabb<Real> box = {};
    std::uint64_t cell = 0;  // the hash of its cell
    int next = nowhere;      // another box with a cell in the same bucket
    int level = nowhere;     // in levels_
  };
  /// Cells of one size; the first level is of boxes that no cell holds.
  struct Level {
    int exponent = 0;    // cells of 2^exponent m
    Real size = 0;       // [m]
    Real per_metre = 0;  // cells
    int count = 0;       // of boxes
  };
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };

  static Cell cell_at(const Vec2<Real>& point, const Level& level);
  std::uint64_t hash(std::int64_t x, std::int64_t y, int level) const;
  int& bucket(std::uint64_t cell);
  int level_of(const Aabb<Real>& box);
  void take_out(int i);
  void look_around(int i, int level);
  void look_at(int i, int other);

  BroadphaseKind kind_;
  List<Place> places_;
  List<int> buckets_;  // the first box of each
  List<Level> levels_;
  List<int> found_;
  List<std::pair<int, int>> pairs_;
};

}  // namespace cairn
