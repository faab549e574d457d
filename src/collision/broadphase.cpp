// Floor 2. Broadphase: which bounding boxes overlap.
#include "collision/broadphase.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace cairn {
namespace {

/// The axis, 0 or 1, along which the centres of the boxes spread more.
template <Scalar Real>
int wider_axis(Span<const Aabb<Real>> boxes, const List<int>& order) {
  Vec2<Real> sum = Vec2<Real>::Zero();
  for (const int i : order) {
    const Aabb<Real>& box = boxes[i];
    sum += (box.lower + box.upper) / 2;
  }
  const Vec2<Real> mean = sum / static_cast<Real>(std::max<int>(order.size(), 1));
  Vec2<Real> spread = Vec2<Real>::Zero();
  for (const int i : order) {
    const Aabb<Real>& box = boxes[i];
    spread += ((box.lower + box.upper) / 2 - mean).cwiseAbs();
  }
  return spread.y() > spread.x() ? 1 : 0;
}

/// Sorts the boxes by where they begin along `axis`; ties by index, so that the order is always the same.
template <Scalar Real>
void sort_along(int axis, Span<const Aabb<Real>> boxes, List<int>& order) {
  const auto begins = [&](int i) { return boxes[i].lower[axis]; };
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return begins(i) != begins(j) ? begins(i) < begins(j) : i < j; });
}

void require_few(int pairs, int most) {
  if (pairs < most) return;
  throw std::length_error("Broadphase: more than " + std::to_string(most) +
                          " pairs of shapes that overlap or are near are above the limit of a step; put "
                          "bodies farther apart");
}

}  // namespace

template <Scalar Real>
const List<std::pair<int, int>>& Broadphase<Real>::pairs(Span<const Aabb<Real>> boxes,
                                                         Span<const char> movable) {
  assert(boxes.size() == movable.size());
  pairs_.clear();
  const auto compare = [&](int i, int j) {
    const int a = i;
    const int b = j;
    if (!(movable[a] || movable[b]) || !boxes[a].overlaps(boxes[b])) return;
    require_few(pairs_.size(), max_pairs);
    pairs_.emplace_back(std::minmax(i, j));
  };
  const int count = boxes.size();
  if (kind_ == BroadphaseKind::all_pairs) {
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) compare(i, j);
    }
    return pairs_;
  }

  // A box that is not a number overlaps nothing, and would leave the sort without an order.
  order_.clear();
  for (int i = 0; i < count; ++i) {
    const Aabb<Real>& box = boxes[i];
    if (!box.lower.hasNaN() && !box.upper.hasNaN()) order_.push_back(i);
  }
  const int axis = wider_axis(boxes, order_);
  sort_along(axis, boxes, order_);
  for (auto first = order_.begin(); first != order_.end(); ++first) {
    const Real end = boxes[*first].upper[axis];
    for (auto second = first + 1; second != order_.end(); ++second) {
      if (boxes[*second].lower[axis] > end) break;
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
