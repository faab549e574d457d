// Floor 5. What is known of contacts from step to step: a slot for each pair of shapes that are near.
#pragma once

#include <cstdint>
#include <utility>

#include "collision/kept_manifold.hpp"
#include "collision/near_pairs.hpp"
#include "math/list.hpp"
#include "world/row_impulses.hpp"

namespace cairn {

/// Two shapes that may touch, for the boxes around them do.
template <Scalar Real>
struct ContactSlot {
  int collider_a = 0;    // the lower one
  int collider_b = 0;    // the higher one
  BodyId a = {};         // whose shape collider_a is
  BodyId b = {};         // whose shape collider_b is
  bool sensed = false;   // one is a sensor: they are seen to touch, and no more
  Real friction = 0;     // mu
  Real restitution = 0;  // e
  Real slop_limit = 0;   // [m]
  BlockImpulses<FixedList<RowImpulse<Real>, 4>, Real> impulses = {};  // of its rows
};

/// What is known of the two shapes of a slot where manifolds last longer than a substep.
template <Scalar Real>
struct LastingManifold {
  KeptManifold<Real> manifold = {};          // in the frames of both bodies
  Vec2<Real> position = Vec2<Real>::Zero();  // [m] of what moves, beside the other, when it was found
  Real angle = 0;                            // [rad] likewise
  Real radius = 0;                           // [m] of what moves, about its centre of mass
  bool a_moves = false;   // motion is that of a beside b, because a is smaller; else that of b beside a
  bool is_found = false;  // there is a manifold, or it is known that they do not touch
};

/// A pair that is near, and its slot.
struct NearSlot {
  static constexpr int none = -1;  // in place of a slot: nothing is known of a touch

  std::pair<int, int> shapes = {};  // the lower one first
  int slot = none;                  // its number
};

/// All pairs that are near, in the order of their shapes: an order that depends on who is near whom now, and
/// not on since when. Some have slots.
template <Scalar Real>
class ContactGraph {
 public:
  /// Of no shapes.
  ContactGraph() = default;
  /// As NearPairs, with room for as many pairs as shapes. Slots have lasting manifolds only if asked for.
  ContactGraph(BroadphaseKind kind, const List<char>& movable, bool lasts)
      : near_(kind, movable), lasts_(lasts) {
    order_.reserve(movable.size());
    next_.reserve(movable.size());
    slots_.reserve(movable.size());
    free_.reserve(movable.size());
    if (lasts_) lasting_.reserve(movable.size());
  }

  /// Takes in where the shapes are. Pairs for which may_meet(i, j) is false are left out: it is asked of
  /// every pair that has come near.
  /// @throws std::length_error as NearPairs.
  template <typename MayMeet>
  void update(Span<const Aabb<Real>> boxes, const MayMeet& may_meet) {
    if (!near_.update(boxes)) return;
    next_.clear();
    make_room(next_, near_.pairs().size());
    auto old = order_.begin();
    for (const std::pair<int, int>& pair : near_.pairs()) {
      for (; old != order_.end() && old->shapes < pair; ++old) remove_slot(*old);
      if (old != order_.end() && old->shapes == pair) {
        next_.push_back(*old++);
      } else if (may_meet(pair.first, pair.second)) {
        next_.push_back({.shapes = pair});
      }
    }
    for (; old != order_.end(); ++old) remove_slot(*old);
    order_.swap(next_);
    next_.reserve(order_.size());  // now, not when a shape next leaves its proxy
  }

  /// Gives a pair without a slot that one.
  void add_slot(NearSlot& near, const ContactSlot<Real>& slot) {
    ++added_;
    if (free_.empty()) {
      near.slot = slots_.size();
      make_room(slots_, near.slot + 1);
      slots_.push_back(slot);
      if (lasts_) {
        make_room(lasting_, near.slot + 1);
        lasting_.push_back({});
      }
      free_.reserve(static_cast<int>(slots_.as_vector().capacity()));  // now, not when a pair goes apart
      return;
    }
    near.slot = free_.back();
    free_.pop_back();
    slots_[near.slot] = slot;
    if (lasts_) lasting_[near.slot] = {};
  }
  /// Of a pair of which nothing is known any more.
  void remove_slot(NearSlot& near) {
    if (near.slot != NearSlot::none) free_.push_back(std::exchange(near.slot, NearSlot::none));
  }

  /// Gives slots other numbers: a step goes through all of them several times, which is fastest where they
  /// lie one behind the other. It does nothing unless many were added.
  void sort_slots() {
    if (added_ <= few_added + slots_.size() / 4) return;
    List<ContactSlot<Real>> sorted;
    List<LastingManifold<Real>> lasting;
    sorted.reserve(slots_.size());
    lasting.reserve(lasting_.size());
    for (NearSlot& near : order_) {
      if (near.slot == NearSlot::none) continue;
      sorted.push_back(slots_[near.slot]);
      if (lasts_) lasting.push_back(lasting_[near.slot]);
      near.slot = sorted.size() - 1;
    }
    slots_.swap(sorted);
    lasting_.swap(lasting);
    free_.clear();
    added_ = 0;
  }

  /// Begins with slots of another graph, in the order of their shapes, and their lasting manifolds, if they
  /// had any.
  void begin_with(List<ContactSlot<Real>> slots, List<LastingManifold<Real>> lasting) {
    slots_ = std::move(slots);
    lasting_ = std::move(lasting);
    lasts_ = lasts_ || !lasting_.empty();
    if (lasts_) lasting_.resize(slots_.size());
    order_.clear();
    free_.clear();
    added_ = 0;
    List<std::pair<int, int>> pairs;
    for (int i = 0; i < slots_.size(); ++i) {
      pairs.push_back({slots_[i].collider_a, slots_[i].collider_b});
      order_.push_back({.shapes = pairs.back(), .slot = i});
    }
    near_.begin_with(std::move(pairs));
  }

  /// All pairs that are near, in order.
  List<NearSlot>& order() { return order_; }
  /// All pairs that are near, in order.
  const List<NearSlot>& order() const { return order_; }
  /// The slot of that number.
  ContactSlot<Real>& operator[](int slot) { return slots_[slot]; }
  /// The slot of that number.
  const ContactSlot<Real>& operator[](int slot) const { return slots_[slot]; }
  /// Whether slots have them.
  bool lasts() const { return lasts_; }
  /// That of a slot, if slots have them.
  LastingManifold<Real>& lasting(int slot) { return lasting_[slot]; }
  /// That of a slot, if slots have them.
  const LastingManifold<Real>& lasting(int slot) const { return lasting_[slot]; }

 private:
  static constexpr int few_added = 256;  // as many fit into the nearest memory in any order

  NearPairs<Real> near_;
  List<ContactSlot<Real>> slots_;        // mostly in the order of their pairs
  List<LastingManifold<Real>> lasting_;  // of slots_, or none
  List<NearSlot> order_;
  List<int> free_;
  bool lasts_ = false;   // lasting_ is kept
  int added_ = 0;        // slots, since they were in order
  List<NearSlot> next_;  // scratch
};

}  // namespace cairn
