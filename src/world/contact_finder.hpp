// Floor 5. One search for contacts: from poses to contacts.
#pragma once

#include "world/contact_cache.hpp"

namespace cairn {

/// Finds the contacts of a substep with what the cache knows of those before.
template <Scalar Real>
class ContactFinder {
 public:
  /// Its contacts go into the record.
  ContactFinder(const Substep<Real>& step, ContactCache<Real>& cache, StepRecord<Real>& record)
      : step_(step), cache_(cache), record_(record) {}

  /// As ContactCache.
  void find();
  /// As ContactCache.
  void move();

 private:
  using Collider = cairn::Collider<Real>;

  /// What contacts that are looked for do to bodies that go on.
  struct Stops {
    bool of_movable_wait = true;  // those of two bodies of which neither is stopped yet
    bool are_new = false;         // some are
    bool are_waiting = false;     // some do
  };

  void find_manifolds();
  void put_manifolds();
  void meet_all(int since);
  bool looks_again(BodyId a, BodyId b, int slot, int since) const;
  void choose_candidates();
  template <typename Find>
  void find_with_others(const Find& find);
  void locate_bodies();
  void look_ahead(Real time);
  typename LookAhead<Real>::Places places() const { return {step_.state.pose, cache_.frames_}; }
  Real travel(const ContactSlot<Real>& slot) const;
  Real slow_way(const ContactSlot<Real>& slot) const;
  bool is_slow(const ContactSlot<Real>& slot, Real travel) const;
  Real nearness(const ContactSlot<Real>& slot) const;
  Real margin_for(const ContactSlot<Real>& slot, Real travel) const;
  bool is_news(const ContactSlot<Real>& slot, int number);
  void stop(int slot);
  void meet(NearSlot& near);
  void meet_for_step(int slot);
  void sort_contacts();
  void keep_sight(int slot, const Manifold<Real>& manifold);
  void touch(int slot, const Manifold<Real>& manifold);
  void touch_ahead(int slot);
  Manifold<Real> moved_manifold(int slot);
  Real leeway_of(const ContactSlot<Real>& slot) const;
  bool stay_apart(const ContactSlot<Real>& slot, const Vec2<Real>& direction) const;
  Manifold<Real> manifold_ahead(int slot, Real travel);
  Manifold<Real> manifold_of_touch(const ContactSlot<Real>& slot, const Course<Real>& a,
                                   const Course<Real>& b, Real room, Real margin, Vec2<Real>& apart) const;
  Manifold<Real> collide_slot(const ContactSlot<Real>& slot, const Frame<Real>& frame_a,
                              const Frame<Real>& frame_b, Real margin) const;
  Pose<Real> relative_pose(const ContactSlot<Real>& slot, bool a_moves) const;
  bool has_lasting_manifold(int slot) const;
  void find_lasting_manifold(int slot);

  const Substep<Real>& step_;
  ContactCache<Real>& cache_;
  StepRecord<Real>& record_;
  Stops stops_ = {};
};

}  // namespace cairn
