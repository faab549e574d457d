// Floor 5. What a search for contacts has seen of each pair.
#pragma once

#include "math/list.hpp"
#include "world/contact_graph.hpp"

namespace cairn {

/// Of a slot, when it was looked at last.
struct Sight {
  int collider_a = -1;   // of the pair that had the slot then
  int collider_b = -1;   // likewise
  int search = -1;       // the number of the search
  int changes = -1;      // how many there had been of how bodies go on; below 0: it is to be looked at
  int manifold = -1;     // the number of its manifold; below 0: none
  bool is_slow = false;  // ContactFinder::is_slow()
  bool waits = false;    // two that can both be moved, until others have stopped whom they can
};

/// A search looks at all pairs, and then, round by round, at those of which a body goes on in another way
/// than before.
class Rounds {
 public:
  /// Nothing has been seen.
  void begin() { ++search_; }
  /// What has been seen of the pair of a slot, with that number.
  template <Scalar Real>
  Sight& of(const ContactSlot<Real>& slot, int number) {
    if (number >= sights_.size()) sights_.resize(number + 1);
    Sight& sight = sights_[number];
    if (sight.search != search_ || sight.collider_a != slot.collider_a || sight.collider_b != slot.collider_b)
      sight = {.collider_a = slot.collider_a, .collider_b = slot.collider_b, .search = search_};
    return sight;
  }
  /// The same, if the slot was looked at; else null.
  const Sight* seen(int number) const {
    const bool is_known = number != NearSlot::none && number < sights_.size();
    return is_known && sights_[number].search == search_ ? &sights_[number] : nullptr;
  }

 private:
  int search_ = 0;
  List<Sight> sights_;  // of each slot
};

}  // namespace cairn
