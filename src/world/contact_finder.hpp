// Floor 5. One search for contacts: from poses to contacts.
#pragma once

#include <cairn/world/contact_cache.hpp>

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
  bool is_one_way(int shape, int other) const;
  bool pass(int a, int b) const;
  void find_sides();
  void see_side(int one_way, int other);
  bool looks_again(BodyId a, BodyId b, int number, int since) const;
  void choose_candidates();
  template <typename Find>
  void find_with_others(const Find& find);
  void locate_bodies();
  void look_ahead(Real time);
  typename LookAhead<Real>::Places places() const { return {step_.state.pose, cache_.frames_}; }
  Real travel(const CachedContact<Real>& cached) const;
  Real slow_travel(const CachedContact<Real>& cached) const;
  bool is_slow(const CachedContact<Real>& cached, Real travel) const;
  Real nearness(const CachedContact<Real>& cached) const;
  Real margin_for(const CachedContact<Real>& cached, Real travel) const;
  bool is_news(const CachedContact<Real>& cached, int number);
  void stop(int number);
  void meet(NearPair& near);
  void meet_for_step(int number);
  void sort_contacts();
  void keep_sight(int number, const Manifold<Real>& manifold);
  void touch(int number, const Manifold<Real>& manifold);
  void touch_ahead(int number);
  Manifold<Real> moved_manifold(int number);
  Real leeway_of(const CachedContact<Real>& cached) const;
  bool stay_apart(const CachedContact<Real>& cached, const Vec2<Real>& direction) const;
  Manifold<Real> manifold_ahead(int number, Real travel);
  Manifold<Real> manifold_of_touch(const CachedContact<Real>& cached, const Course<Real>& a,
                                   const Course<Real>& b, Real room, Real margin, Vec2<Real>& apart) const;
  Manifold<Real> collide_pair(const CachedContact<Real>& cached, const Frame<Real>& frame_a,
                              const Frame<Real>& frame_b, Real margin) const;
  Pose<Real> relative_pose(const CachedContact<Real>& cached, bool a_moves) const;
  bool has_cached_manifold(int number) const;
  void find_cached_manifold(int number);

  const Substep<Real>& step_;
  ContactCache<Real>& cache_;
  StepRecord<Real>& record_;
  Stops stops_ = {};
};

}  // namespace cairn
