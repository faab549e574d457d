// Floor 5. What is known of contacts from step to step: of each pair of shapes that are near.
#pragma once

#include <cstdint>
#include <utility>

#include <cairn/collision/kept_manifold.hpp>
#include <cairn/collision/near_pairs.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/row_impulses.hpp>

namespace cairn {

/// Two shapes that may touch, for the boxes around them do.
template <Scalar Real>
struct CachedContact {
  int collider_a = 0;    // the lower one
  int collider_b = 0;    // the higher one
  BodyId a = {};         // whose shape collider_a is
  BodyId b = {};         // whose shape collider_b is
  bool sensed = false;   // one is a sensor: they are seen to touch, and no more
  bool slides = false;   // or sticks: for PlanExtras::static_friction
  Real friction = 0;     // mu
  Real restitution = 0;  // e
  Real slop_limit = 0;   // [m]
  BlockImpulses<FixedList<RowImpulse<Real>, 4>, Real> impulses = {};  // of its rows
};

/// What is known of the two shapes of a contact where manifolds last longer than a substep.
template <Scalar Real>
struct CachedManifold {
  KeptManifold<Real> manifold = {};          // in the frames of both bodies
  Vec2<Real> position = Vec2<Real>::Zero();  // [m] of what moves, beside the other, when it was found
  Real angle = 0;                            // [rad] likewise
  Real radius = 0;                           // [m] of what moves, about its centre of mass
  bool a_moves = false;   // motion is that of a beside b, because a is smaller; else that of b beside a
  bool is_found = false;  // there is a manifold, or it is known that they do not touch
};

/// A pair that is near, and its contact.
struct NearPair {
  static constexpr int none = -1;  // in place of a contact: nothing is known of a touch

  std::pair<int, int> shapes = {};  // the lower one first
  int contact = none;               // its number
};

/// All pairs that are near, in the order of their shapes: an order that depends on who is near whom now, and
/// not on since when. Some have contacts.
template <Scalar Real>
class ContactGraph {
 public:
  /// As NearPairs, with room for as many pairs as shapes. Contacts have cached manifolds only if asked for.
  ContactGraph(BroadphaseKind kind, const List<char>& movable, bool with_manifolds)
      : near_(kind, movable), keeps_manifolds_(with_manifolds) {
    order_.reserve(movable.size());
    next_.reserve(movable.size());
    contacts_.reserve(movable.size());
    free_.reserve(movable.size());
    if (keeps_manifolds_) manifolds_.reserve(movable.size());
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
      for (; old != order_.end() && old->shapes < pair; ++old) remove_contact(*old);
      if (old != order_.end() && old->shapes == pair) {
        next_.push_back(*old++);
      } else if (may_meet(pair.first, pair.second)) {
        next_.push_back({.shapes = pair});
      }
    }
    for (; old != order_.end(); ++old) remove_contact(*old);
    order_.swap(next_);
    next_.reserve(order_.size());  // now, not when a shape next leaves its proxy
  }

  /// Gives a pair without a contact that one.
  void add_contact(NearPair& near, const CachedContact<Real>& cached) {
    ++added_;
    if (free_.empty()) {
      near.contact = contacts_.size();
      make_room(contacts_, near.contact + 1);
      contacts_.push_back(cached);
      if (keeps_manifolds_) {
        make_room(manifolds_, near.contact + 1);
        manifolds_.push_back({});
      }
      free_.reserve(static_cast<int>(contacts_.as_vector().capacity()));  // now, not when a pair goes apart
      return;
    }
    near.contact = free_.back();
    free_.pop_back();
    contacts_[near.contact] = cached;
    if (keeps_manifolds_) manifolds_[near.contact] = {};
  }
  /// Of a pair of which nothing is known any more.
  void remove_contact(NearPair& near) {
    if (near.contact != NearPair::none) free_.push_back(std::exchange(near.contact, NearPair::none));
  }

  /// Gives contacts other numbers: a step goes through all of them several times, which is fastest where they
  /// lie one behind the other. It does nothing unless many were added.
  void sort_contacts() {
    if (added_ <= few_added + contacts_.size() / 4) return;
    List<CachedContact<Real>> sorted;
    List<CachedManifold<Real>> manifolds;
    sorted.reserve(contacts_.size());
    manifolds.reserve(manifolds_.size());
    for (NearPair& near : order_) {
      if (near.contact == NearPair::none) continue;
      sorted.push_back(contacts_[near.contact]);
      if (keeps_manifolds_) manifolds.push_back(manifolds_[near.contact]);
      near.contact = sorted.size() - 1;
    }
    contacts_.swap(sorted);
    manifolds_.swap(manifolds);
    free_.clear();
    added_ = 0;
  }

  /// Begins with contacts of another graph, in the order of their shapes, and their cached manifolds, if they
  /// had any.
  void begin_with(List<CachedContact<Real>> contacts, List<CachedManifold<Real>> manifolds) {
    contacts_ = std::move(contacts);
    manifolds_ = std::move(manifolds);
    keeps_manifolds_ = keeps_manifolds_ || !manifolds_.empty();
    if (keeps_manifolds_) manifolds_.resize(contacts_.size());
    order_.clear();
    free_.clear();
    added_ = 0;
    List<std::pair<int, int>> pairs;
    for (int i = 0; i < contacts_.size(); ++i) {
      pairs.push_back({contacts_[i].collider_a, contacts_[i].collider_b});
      order_.push_back({.shapes = pairs.back(), .contact = i});
    }
    near_.begin_with(std::move(pairs));
  }

  /// All pairs that are near, in order.
  List<NearPair>& order() { return order_; }
  /// All pairs that are near, in order.
  const List<NearPair>& order() const { return order_; }
  /// The contact of that number.
  CachedContact<Real>& operator[](int number) { return contacts_[number]; }
  /// The contact of that number.
  const CachedContact<Real>& operator[](int number) const { return contacts_[number]; }
  /// Whether contacts have them.
  bool keeps_manifolds() const { return keeps_manifolds_; }
  /// That of a contact, if contacts have them.
  CachedManifold<Real>& manifold(int number) { return manifolds_[number]; }
  /// That of a contact, if contacts have them.
  const CachedManifold<Real>& manifold(int number) const { return manifolds_[number]; }

 private:
  static constexpr int few_added = 256;  // as many fit into the nearest memory in any order

  NearPairs<Real> near_;
  List<CachedContact<Real>> contacts_;    // mostly in the order of their pairs
  List<CachedManifold<Real>> manifolds_;  // of contacts_, or none
  List<NearPair> order_;
  List<int> free_;
  bool keeps_manifolds_ = false;  // contacts have manifolds
  int added_ = 0;                 // contacts, since they were in order
  List<NearPair> next_;           // scratch
};

}  // namespace cairn
