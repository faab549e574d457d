// Floor 2. Broadphase: which bounding boxes overlap.
#include <cairn/collision/broadphase.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cairn {
namespace {

constexpr int finest_exponent = -40;    // smaller boxes share its cells
constexpr int coarsest_exponent = 120;  // larger boxes lie in no cell
constexpr int boundless = 0;            // the level of boxes that no cell holds

/// Of the cells that are larger than the box, and at most twice as large.
template <Scalar Real>
int exponent_of(const Aabb<Real>& box) {
  const Real side = (box.upper - box.lower).maxCoeff();
  return side > 0 ? std::clamp(std::ilogb(side), finest_exponent - 1, coarsest_exponent) + 1
                  : finest_exponent;
}

/// Whether a box lies so far out that Real cannot tell a sixteenth of its cell apart.
template <Scalar Real>
bool is_far_out(const Aabb<Real>& box, Real cells_per_metre) {
  const Real reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  return !(reach * cells_per_metre < 1 / (16 * std::numeric_limits<Real>::epsilon()));
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
void Broadphase<Real>::reset(int count) {
  places_.assign(count, {});
  if (kind_ == BroadphaseKind::all_pairs) return;
  buckets_.assign(std::bit_ceil(static_cast<unsigned>(2 * count + 1)), nowhere);
  levels_.assign(1, {.exponent = coarsest_exponent + 1});
}

template <Scalar Real>
auto Broadphase<Real>::cell_at(const Vec2<Real>& point, const Level& level) -> Cell {
  const auto number = [&level](Real x) {
    const auto toward_zero = static_cast<std::int64_t>(x * level.per_metre);
    return toward_zero - (x * level.per_metre < static_cast<Real>(toward_zero) ? 1 : 0);
  };
  return {number(point.x()), number(point.y())};
}

/// Neighbours in x lie in neighbouring buckets, so that they are near in memory too.
template <Scalar Real>
std::uint64_t Broadphase<Real>::hash(std::int64_t x, std::int64_t y, int level) const {
  return static_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(y) * 0x9E3779B97F4A7C15u +
         static_cast<std::uint64_t>(levels_[level].exponent) * 0xC2B2AE3D27D4EB4Fu;
}

template <Scalar Real>
int& Broadphase<Real>::bucket(std::uint64_t cell) {
  return buckets_[static_cast<int>(cell & static_cast<std::uint64_t>(buckets_.size() - 1))];
}

/// Its number in levels_; a new one, or that of an empty one, where there is none.
template <Scalar Real>
int Broadphase<Real>::level_of(const Aabb<Real>& box) {
  const int exponent = exponent_of(box);
  const Real size = std::ldexp(Real(1), exponent);
  if (exponent > coarsest_exponent || is_far_out(box, 1 / size)) return boundless;
  int free = levels_.size();
  for (int i = levels_.size() - 1; i > boundless; --i) {
    if (levels_[i].exponent == exponent) return i;
    if (levels_[i].count == 0) free = i;
  }
  if (free == levels_.size()) levels_.emplace_back();
  levels_[free] = {.exponent = exponent, .size = size, .per_metre = 1 / size};
  return free;
}

template <Scalar Real>
void Broadphase<Real>::put(int i, const Aabb<Real>& box) {
  Place& place = places_[i];
  if (place.level != nowhere) take_out(i);
  place = {.box = box};
  if (kind_ == BroadphaseKind::all_pairs || !is_number(box)) return;
  place.level = level_of(box);
  const Level& level = levels_[place.level];
  const Cell cell = place.level == boundless ? Cell() : cell_at(box.lower, level);
  place.cell = hash(cell.x, cell.y, place.level);
  place.next = std::exchange(bucket(place.cell), i);
  ++levels_[place.level].count;
}

template <Scalar Real>
void Broadphase<Real>::take_out(int i) {
  --levels_[places_[i].level].count;
  int* link = &bucket(places_[i].cell);
  while (*link != i) link = &places_[*link].next;
  *link = places_[i].next;
}

template <Scalar Real>
const List<int>& Broadphase<Real>::overlapping(int i) {
  found_.clear();
  if (kind_ == BroadphaseKind::all_pairs || places_[i].level == boundless) {
    for (int j = 0; j < places_.size(); ++j) look_at(i, j);
  } else if (places_[i].level != nowhere) {
    for (int level = 0; level < levels_.size(); ++level) {
      if (levels_[level].count > 0) look_around(i, level);
    }
  }
  return found_;
}

/// What it overlaps on that level: in the cells that it may lie in; or among all boxes, where they are fewer.
template <Scalar Real>
void Broadphase<Real>::look_around(int i, int number) {
  const Level& level = levels_[number];
  const Aabb<Real>& box = places_[i].box;
  const Vec2<Real> cells = (box.upper - box.lower) * level.per_metre;
  const bool are_few = (cells.x() + 3) * (cells.y() + 3) < static_cast<Real>(places_.size() + 9);
  if (!are_few || is_far_out(box, level.per_metre)) {
    for (int j = 0; j < places_.size(); ++j) {
      if (places_[j].level == number) look_at(i, j);
    }
    return;
  }
  Cell from, to;
  if (number != boundless) {
    // What rounding may take from the difference, and from the side that the level was chosen by.
    const Vec2<Real> slack =
        4 * std::numeric_limits<Real>::epsilon() * (box.lower.array().abs() + level.size).matrix();
    from = cell_at(box.lower - slack - Vec2<Real>(level.size, level.size), level);
    to = cell_at(box.upper, level);
  }
  for (std::int64_t y = from.y; y <= to.y; ++y) {
    for (std::int64_t x = from.x; x <= to.x; ++x) {
      const std::uint64_t cell = hash(x, y, number);
      for (int j = bucket(cell); j != nowhere; j = places_[j].next) {
        if (places_[j].cell == cell) look_at(i, j);
      }
    }
  }
}

template <Scalar Real>
void Broadphase<Real>::look_at(int i, int other) {
  if (other != i && places_[i].box.overlaps(places_[other].box)) found_.push_back(other);
}

template <Scalar Real>
const List<std::pair<int, int>>& Broadphase<Real>::pairs(Span<const Aabb<Real>> boxes,
                                                         Span<const char> movable) {
  assert(boxes.size() == movable.size());
  reset(boxes.size());
  for (int i = 0; i < boxes.size(); ++i) put(i, boxes[i]);
  pairs_.clear();
  for (int i = 0; i < boxes.size(); ++i) {
    const int first = pairs_.size();
    for (const int j : overlapping(i)) {
      if (i < j && (movable[i] || movable[j])) pairs_.push_back({i, j});
    }
    require_few(pairs_.size());
    std::sort(pairs_.begin() + first, pairs_.end());
  }
  return pairs_;
}

template class Broadphase<float>;
template class Broadphase<double>;

}  // namespace cairn
