// Floor 2. Broadphase: which bounding boxes overlap.
#pragma once

#include <cstdint>
#include <utility>

#include "geometry/aabb.hpp"
#include "math/list.hpp"

namespace cairn {

/// all_pairs compares every two boxes: best for a few. grid compares boxes of neighbouring cells: its cost
/// grows as the number of boxes does, wherever they lie.
enum class BroadphaseKind { all_pairs, grid };

/// Finds overlapping pairs. Holds scratch memory only, so that a steady step allocates nothing.
///
/// The grid has a level for each power of two: a box lies in the cell of its lower corner, on the level whose
/// cells are just larger than it is. What it may overlap on a level as coarse as its own, or coarser, then
/// has its lower corner at most one cell before the box. Cells are found by a hash of their level and place
/// (M. Teschner and others, 2003; C. Ericson, Real-Time Collision Detection, 2005, 7.2).
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

  /// @throws std::length_error for more than max_pairs pairs.
  static void require_few(int pairs);

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    int level = 0;  // cells of 2^level m
    bool operator==(const Cell&) const = default;
  };
  struct Entry {
    Aabb<Real> box = {};
    Cell cell = {};
    int index = 0;
    char movable = 0;
  };

  static Cell cell_at(const Vec2<Real>& point, int level);
  int bucket(const Cell& cell) const;
  void compare_all(Span<const Aabb<Real>> boxes, Span<const char> movable);
  void fill_cells(Span<const Aabb<Real>> boxes, Span<const char> movable);
  void put_in_buckets();
  void look_ahead(int place);
  void look_around(const Entry& entry, int level);
  void look_into(const Cell& cell, const Entry& entry);
  void compare(const Entry& entry, const Entry& other);
  void sort_pairs(int count);

  BroadphaseKind kind_;
  List<std::pair<int, int>> pairs_;
  // Of the grid.
  List<Entry> entries_;    // by index
  List<Entry> ordered_;    // by bucket
  List<int> first_;        // of each bucket, in ordered_; at the end their number
  List<int> levels_;       // in use, ascending
  List<Entry> boundless_;  // boxes that no cell holds: compared with all others
  List<std::pair<int, int>> unsorted_;
};

}  // namespace cairn
