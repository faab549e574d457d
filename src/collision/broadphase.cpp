// Floor 2. Broadphase: which bounding boxes overlap.
#include "collision/broadphase.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace cairn {
namespace {

/// The axis, 0 or 1, along which the centres of the boxes spread more.
template <Scalar Real>
int wider_axis(std::span<const Aabb<Real>> boxes, const std::vector<int>& order) {
  Vec2<Real> sum = Vec2<Real>::Zero();
  for (const int i : order) {
    const Aabb<Real>& box = boxes[static_cast<std::size_t>(i)];
    sum += (box.lower + box.upper) / 2;
  }
  const Vec2<Real> mean = sum / static_cast<Real>(std::max<std::size_t>(order.size(), 1));
  Vec2<Real> spread = Vec2<Real>::Zero();
  for (const int i : order) {
    const Aabb<Real>& box = boxes[static_cast<std::size_t>(i)];
    spread += ((box.lower + box.upper) / 2 - mean).cwiseAbs();
  }
  return spread.y() > spread.x() ? 1 : 0;
}

/// Sorts the boxes by where they begin along `axis`; ties by index, so that the order is always the same.
template <Scalar Real>
void sort_along(int axis, std::span<const Aabb<Real>> boxes, std::vector<int>& order) {
  const auto begins = [&](int i) { return boxes[static_cast<std::size_t>(i)].lower[axis]; };
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return begins(i) != begins(j) ? begins(i) < begins(j) : i < j; });
}

}  // namespace

template <Scalar Real>
const std::vector<std::pair<int, int>>& Broadphase<Real>::pairs(std::span<const Aabb<Real>> boxes,
                                                                std::span<const char> movable) {
  assert(boxes.size() == movable.size());
  pairs_.clear();
  const auto compare = [&](int i, int j) {
    const std::size_t a = static_cast<std::size_t>(i);
    const std::size_t b = static_cast<std::size_t>(j);
    if ((movable[a] || movable[b]) && boxes[a].overlaps(boxes[b])) pairs_.emplace_back(std::minmax(i, j));
  };
  const int count = static_cast<int>(boxes.size());
  if (kind_ == BroadphaseKind::all_pairs) {
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) compare(i, j);
    }
    return pairs_;
  }

  // A box that is not a number overlaps nothing, and would leave the sort without an order.
  order_.clear();
  for (int i = 0; i < count; ++i) {
    const Aabb<Real>& box = boxes[static_cast<std::size_t>(i)];
    if (!box.lower.hasNaN() && !box.upper.hasNaN()) order_.push_back(i);
  }
  const int axis = wider_axis(boxes, order_);
  sort_along(axis, boxes, order_);
  for (auto first = order_.begin(); first != order_.end(); ++first) {
    const Real end = boxes[static_cast<std::size_t>(*first)].upper[axis];
    for (auto second = first + 1; second != order_.end(); ++second) {
      if (boxes[static_cast<std::size_t>(*second)].lower[axis] > end) break;
      compare(*first, *second);
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

template class Broadphase<float>;
template class Broadphase<double>;
template class Broadphase<long double>;

}  // namespace cairn
