// Floor 2. Which bounding boxes are near each other: a list that outlives the step.
#include <cairn/collision/near_pairs.hpp>

#include <algorithm>
#include <cassert>

namespace cairn {
namespace {

// Of the longer side of a box: how far its proxy reaches beyond it, and how far at most, once the box has
// become smaller, or has gone to one end of it.
constexpr double proxy_share = 0.1;
constexpr double most_share = 0.4;

/// False also for a box that is not a number: it gets a new proxy in every step, which overlaps nothing.
template <Scalar Real>
bool lies_in(const Aabb<Real>& box, const Aabb<Real>& proxy) {
  return (box.lower.array() >= proxy.lower.array()).all() && (box.upper.array() <= proxy.upper.array()).all();
}

template <Scalar Real>
Aabb<Real> grown(const Aabb<Real>& box, double share) {
  const Real room = static_cast<Real>(share) * (box.upper - box.lower).maxCoeff();
  return {box.lower.array() - room, box.upper.array() + room};
}

}  // namespace

template <Scalar Real>
NearPairs<Real>::NearPairs(BroadphaseKind kind, List<char> movable)
    : proxies_(kind), movable_(std::move(movable)), is_moved_(movable_.size(), 0) {
  proxies_.reset(movable_.size());
  for (List<std::pair<int, int>>* pairs : {&pairs_, &found_, &next_}) pairs->reserve(movable_.size());
  moved_.reserve(movable_.size());
}

template <Scalar Real>
bool NearPairs<Real>::update(Span<const Aabb<Real>> boxes) {
  assert(boxes.size() == movable_.size());
  moved_.clear();
  for (int i = 0; i < boxes.size(); ++i) {
    const Aabb<Real>& proxy = proxies_.box(i);
    if (is_current_ && lies_in(boxes[i], proxy) && lies_in(proxy, grown(boxes[i], most_share))) continue;
    proxies_.put(i, is_current_ ? grown(boxes[i], proxy_share) : boxes[i]);
    moved_.push_back(i);
  }
  if (moved_.empty()) return false;
  is_current_ = false;  // should there be too many pairs
  find_pairs_of_moved();
  is_current_ = true;
  if (next_ == pairs_) return false;
  pairs_.swap(next_);
  return true;
}

/// Into next_: the pairs of the list without a moved box, and all pairs with one, in order.
template <Scalar Real>
void NearPairs<Real>::find_pairs_of_moved() {
  for (const int i : moved_) is_moved_[i] = 1;
  found_.clear();
  for (const int i : moved_) {
    for (const int j : proxies_.overlapping(i)) {
      const bool is_seen_from_j = is_moved_[j] && j < i;
      if (!is_seen_from_j && (movable_[i] || movable_[j])) found_.push_back(std::minmax(i, j));
    }
    Broadphase<Real>::require_few(found_.size());
  }
  std::sort(found_.begin(), found_.end());
  // Room for as many more, so that boxes that move about without meeting others take no memory.
  const int most = pairs_.size() + found_.size();
  if (static_cast<int>(next_.as_vector().capacity()) < most) next_.reserve(most + movable_.size());
  next_.clear();
  auto found = found_.begin();
  for (const auto& pair : pairs_) {
    if (is_moved_[pair.first] || is_moved_[pair.second]) continue;  // found again, if it is near
    for (; found != found_.end() && *found < pair; ++found) next_.push_back(*found);
    next_.push_back(pair);
  }
  next_.insert(next_.end(), found, found_.end());
  for (const int i : moved_) is_moved_[i] = 0;
  Broadphase<Real>::require_few(next_.size());
}

template class NearPairs<float>;
template class NearPairs<double>;

}  // namespace cairn
