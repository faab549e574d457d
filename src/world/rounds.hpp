// Floor 5. What a search for contacts has seen of each pair.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/world/contact_graph.hpp>

namespace cairn {

/// Of a contact, when it was looked at last.
template <Scalar Real>
struct Sight {
  int collider_a = -1;   // of the pair that had the contact then
  int collider_b = -1;   // likewise
  int search = -1;       // the number of the search
  int changes = -1;      // how many there had been of how bodies go on; below 0: it is to be looked at
  int contact = -1;      // the number of its contact; below 0: none
  bool is_slow = false;  // ContactFinder::is_slow()
  bool waits = false;    // two that can both be moved, until others have stopped whom they can
  /// Along which a search found the two apart, be it one before: unit, from a to b, or zero.
  Vec2<Real> apart = Vec2<Real>::Zero();
};

/// A search looks at all pairs, and then, round by round, at those of which a body goes on in another way
/// than before.
template <Scalar Real>
class Rounds {
 public:
  /// Nothing has been seen.
  void begin() { ++search_; }
  /// What has been seen of the pair of a contact, with that number.
  Sight<Real>& of(const CachedContact<Real>& cached, int number) {
    if (number >= sights_.size()) sights_.resize(number + 1);
    Sight<Real>& sight = sights_[number];
    const bool is_same = sight.collider_a == cached.collider_a && sight.collider_b == cached.collider_b;
    if (sight.search != search_ || !is_same) {
      const Vec2<Real> apart = is_same ? sight.apart : Vec2<Real>::Zero();
      sight = {.collider_a = cached.collider_a,
               .collider_b = cached.collider_b,
               .search = search_,
               .apart = apart};
    }
    return sight;
  }
  /// The same, if the contact was looked at; else null.
  const Sight<Real>* seen(int number) const {
    const bool is_known = number != NearPair::none && number < sights_.size();
    return is_known && sights_[number].search == search_ ? &sights_[number] : nullptr;
  }

 private:
  int search_ = 0;
  List<Sight<Real>> sights_;  // of each contact
};

}  // namespace cairn
