// Floor 2. Broadphase: which bounding boxes overlap.
#include "collision/broadphase.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cairn {
namespace {

constexpr int finest_level = -40;    // smaller boxes share its cells
constexpr int coarsest_level = 120;  // larger boxes lie in no cell

/// The level whose cells are larger than the box, and at most twice as large; one more than the coarsest
/// where there is none.
template <Scalar Real>
int level_of(const Aabb<Real>& box) {
  const Real side = (box.upper - box.lower).maxCoeff();
  return side > 0 ? std::clamp(std::ilogb(side), finest_level - 1, coarsest_level) + 1 : finest_level;
}

/// Whether a box lies so far out that Real cannot tell a sixteenth of its cell apart.
template <Scalar Real>
bool is_far_out(const Aabb<Real>& box, int level) {
  const Real reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  return !(reach * std::ldexp(Real(1), -level) < 1 / (16 * std::numeric_limits<Real>::epsilon()));
}

/// A box that is not a number overlaps nothing.
template <Scalar Real>
bool is_number(const Aabb<Real>& box) {
  return !box.lower.hasNaN() && !box.upper.hasNaN();
}

}  // namespace

template <Scalar Real>
void Broadphase<Real>::require_few(int pairs) {
  if (pairs <= max_pairs) return;
  throw std::length_error("Broadphase: more than " + std::to_string(max_pairs) +
                          " pairs of shapes that overlap or are near are above the limit of a step; put "
                          "bodies farther apart");
}

template <Scalar Real>
auto Broadphase<Real>::cell_at(const Vec2<Real>& point, int level) -> Cell {
  const Real scale = std::ldexp(Real(1), -level);
  const auto number = [scale](Real x) {
    const auto toward_zero = static_cast<std::int64_t>(x * scale);
    return toward_zero - (x * scale < static_cast<Real>(toward_zero) ? 1 : 0);
  };
  return {number(point.x()), number(point.y()), level};
}

/// Neighbours in x lie in neighbouring buckets, so that they are near in memory too.
template <Scalar Real>
int Broadphase<Real>::bucket(const Cell& cell) const {
  const auto mixed = static_cast<std::uint64_t>(cell.x) +
                     static_cast<std::uint64_t>(cell.y) * 0x9E3779B97F4A7C15u +
                     static_cast<std::uint64_t>(cell.level) * 0xC2B2AE3D27D4EB4Fu;
  return static_cast<int>(mixed & static_cast<std::uint64_t>(first_.size() - 2));
}

template <Scalar Real>
const List<std::pair<int, int>>& Broadphase<Real>::pairs(Span<const Aabb<Real>> boxes,
                                                         Span<const char> movable) {
  assert(boxes.size() == movable.size());
  pairs_.clear();
  if (kind_ == BroadphaseKind::all_pairs) {
    compare_all(boxes, movable);
    return pairs_;
  }
  fill_cells(boxes, movable);
  put_in_buckets();
  for (int i = 0; i < ordered_.size(); ++i) {
    look_ahead(i);
    for (const int level : levels_) {
      if (level > ordered_[i].cell.level) look_around(ordered_[i], level);
    }
  }
  for (int i = 0; i < boundless_.size(); ++i) {
    for (const Entry& other : ordered_) compare(boundless_[i], other);
    for (int j = i + 1; j < boundless_.size(); ++j) compare(boundless_[i], boundless_[j]);
  }
  sort_pairs(boxes.size());
  return pairs_;
}

template <Scalar Real>
void Broadphase<Real>::compare_all(Span<const Aabb<Real>> boxes, Span<const char> movable) {
  for (int i = 0; i < boxes.size(); ++i) {
    for (int j = i + 1; j < boxes.size(); ++j) {
      if (!(movable[i] || movable[j]) || !boxes[i].overlaps(boxes[j])) continue;
      require_few(pairs_.size() + 1);
      pairs_.push_back({i, j});
    }
  }
}

template <Scalar Real>
void Broadphase<Real>::fill_cells(Span<const Aabb<Real>> boxes, Span<const char> movable) {
  entries_.clear();
  boundless_.clear();
  levels_.clear();
  for (int i = 0; i < boxes.size(); ++i) {
    const Aabb<Real>& box = boxes[i];
    if (!is_number(box)) continue;
    const int level = level_of(box);
    if (level > coarsest_level || is_far_out(box, level)) {
      boundless_.push_back({box, {}, i, movable[i]});
      continue;
    }
    entries_.push_back({box, cell_at(box.lower, level), i, movable[i]});
    const auto place = std::lower_bound(levels_.begin(), levels_.end(), level);
    if (place == levels_.end() || *place != level) levels_.insert(place, level);
  }
}

/// Boxes by their bucket, those of one bucket by their index.
template <Scalar Real>
void Broadphase<Real>::put_in_buckets() {
  const auto buckets = std::bit_ceil(static_cast<unsigned>(2 * entries_.size() + 2));
  first_.assign(static_cast<int>(buckets) + 1, 0);
  for (const Entry& entry : entries_) ++first_[bucket(entry.cell)];
  int end = 0;
  for (int& first : first_) end += std::exchange(first, end);
  ordered_.resize(entries_.size());
  for (const Entry& entry : entries_) ordered_[first_[bucket(entry.cell)]++] = entry;
  std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
  first_[0] = 0;
}

template <Scalar Real>
void Broadphase<Real>::compare(const Entry& entry, const Entry& other) {
  if (!(entry.movable || other.movable) || !entry.box.overlaps(other.box)) return;
  require_few(pairs_.size() + 1);
  pairs_.push_back(std::minmax(entry.index, other.index));
}

/// What a box overlaps on its own level: of the neighbouring cells only those that come after its own, as the
/// others look at this one, and only as far as the box reaches.
template <Scalar Real>
void Broadphase<Real>::look_ahead(int place) {
  const Entry& entry = ordered_[place];
  const Cell& own = entry.cell;
  const Cell reached = cell_at(entry.box.upper, own.level);
  for (int k = place + 1; k < first_[bucket(own) + 1]; ++k) {
    if (ordered_[k].cell == own) compare(entry, ordered_[k]);
  }
  if (reached.x > own.x) look_into({own.x + 1, own.y, own.level}, entry);
  if (reached.y == own.y) return;
  for (std::int64_t x = own.x - 1; x <= reached.x; ++x) look_into({x, own.y + 1, own.level}, entry);
}

/// What it overlaps on a coarser level.
template <Scalar Real>
void Broadphase<Real>::look_around(const Entry& entry, int level) {
  // What rounding may take from the difference, and from the side that the level was chosen by.
  const Real size = std::ldexp(Real(1), level);
  const Vec2<Real> slack =
      4 * std::numeric_limits<Real>::epsilon() * (entry.box.lower.array().abs() + size).matrix();
  const Cell from = cell_at(entry.box.lower - slack - Vec2<Real>(size, size), level);
  const Cell to = cell_at(entry.box.upper, level);
  for (std::int64_t y = from.y; y <= to.y; ++y) {
    for (std::int64_t x = from.x; x <= to.x; ++x) look_into({x, y, level}, entry);
  }
}

template <Scalar Real>
void Broadphase<Real>::look_into(const Cell& cell, const Entry& entry) {
  const int number = bucket(cell);
  for (int k = first_[number]; k < first_[number + 1]; ++k) {
    if (ordered_[k].cell == cell) compare(entry, ordered_[k]);
  }
}

/// By the first of each pair in one pass, then each run by the second: runs are short.
template <Scalar Real>
void Broadphase<Real>::sort_pairs(int count) {
  first_.assign(count + 1, 0);
  for (const auto& [i, j] : pairs_) ++first_[i];
  int end = 0;
  for (int& first : first_) end += std::exchange(first, end);
  unsorted_.swap(pairs_);
  pairs_.resize(unsorted_.size());
  for (const auto& pair : unsorted_) pairs_[first_[pair.first]++] = pair;
  int begin = 0;
  for (int i = 0; i < count; ++i) {
    std::sort(pairs_.begin() + begin, pairs_.begin() + first_[i]);
    begin = first_[i];
  }
}

template class Broadphase<float>;
template class Broadphase<double>;
template class Broadphase<long double>;

}  // namespace cairn
