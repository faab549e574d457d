// Floor 2. Which bounding boxes are near each other: a list that outlives the step.
#include "collision/near_pairs.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace cairn {
namespace {

// Of the longer side of a box: how far its proxy reaches beyond it.
constexpr double proxy_share = 0.1;

// To compare one box with all others takes about a hundredth of the time that all pairs take anew.
constexpr int few_moved = 64;

/// False also for a box that is not a number: it gets a new proxy in every step, which overlaps nothing.
template <Scalar Real>
bool lies_in(const Aabb<Real>& box, const Aabb<Real>& proxy) {
  return (box.lower.array() >= proxy.lower.array()).all() && (box.upper.array() <= proxy.upper.array()).all();
}

template <Scalar Real>
Aabb<Real> proxy_of(const Aabb<Real>& box) {
  const Real room = static_cast<Real>(proxy_share) * (box.upper - box.lower).maxCoeff();
  return {box.lower.array() - room, box.upper.array() + room};
}

}  // namespace

template <Scalar Real>
NearPairs<Real>::NearPairs(BroadphaseKind kind, List<char> movable)
    : broadphase_(kind), movable_(std::move(movable)), is_moved_(movable_.size(), 0) {
  moved_.reserve(movable_.size());
}

template <Scalar Real>
bool NearPairs<Real>::update(Span<const Aabb<Real>> boxes) {
  assert(boxes.size() == movable_.size());
  proxies_.resize(boxes.size());
  moved_.clear();
  for (int i = 0; i < boxes.size(); ++i) {
    if (is_current_ && lies_in(boxes[i], proxies_[i])) continue;
    proxies_[i] = proxy_of(boxes[i]);
    moved_.push_back(i);
  }
  if (moved_.empty()) return false;
  const bool all_anew = !is_current_ || moved_.size() > few_moved;
  is_current_ = false;  // should there be too many pairs
  if (all_anew) {
    const List<std::pair<int, int>>& all = broadphase_.pairs(proxies_, movable_);
    // Room for as many more, so that boxes that move about without meeting others take no memory.
    for (List<std::pair<int, int>>* list : {&next_, &pairs_, &unmoved_pairs_, &found_}) {
      list->reserve(all.size() + boxes.size());
    }
    next_.assign(all.begin(), all.end());
  } else {
    find_pairs_of_moved();
  }
  is_current_ = true;
  if (next_ == pairs_) return false;
  pairs_.swap(next_);
  return true;
}

/// Into next_: the pairs of the list without a moved box, and all pairs with one.
template <Scalar Real>
void NearPairs<Real>::find_pairs_of_moved() {
  for (const int i : moved_) is_moved_[i] = 1;
  found_.clear();
  for (const int i : moved_) {
    for (int j = 0; j < proxies_.size(); ++j) {
      const bool is_seen_from_j = is_moved_[j] && j <= i;
      if (is_seen_from_j || !(movable_[i] || movable_[j]) || !proxies_[i].overlaps(proxies_[j])) continue;
      found_.push_back(std::minmax(i, j));
    }
  }
  std::sort(found_.begin(), found_.end());
  unmoved_pairs_.clear();
  for (const auto& pair : pairs_) {
    if (!is_moved_[pair.first] && !is_moved_[pair.second]) unmoved_pairs_.push_back(pair);
  }
  for (const int i : moved_) is_moved_[i] = 0;
  next_.clear();
  std::merge(unmoved_pairs_.begin(), unmoved_pairs_.end(), found_.begin(), found_.end(),
             std::back_inserter(next_));
  Broadphase<Real>::require_few(next_.size());
}

template class NearPairs<float>;
template class NearPairs<double>;
template class NearPairs<long double>;

}  // namespace cairn
