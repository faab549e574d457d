// Floor 5. Sleeping: bodies at rest are left out of the steps until something wakes them.
#pragma once

#include <utility>

#include "collision/manifold.hpp"
#include "constraints/row.hpp"
#include "world/scene.hpp"
#include "math/list.hpp"

namespace cairn {

/// What takes part in the steps.
struct AwakeCount {
  int bodies = 0;   // dynamic ones
  int islands = 0;  // of them
};

/// Which bodies of a world sleep, and what they need to wake up warm.
///
/// An island is a set of dynamic bodies that manifolds and joints connect, directly or through each other.
/// What cannot be pushed connects nothing. An island falls asleep as a whole and wakes as a whole: once it is
/// touched or held by an awake body or by a kinematic one that moves, or once it is asked to. While it sleeps
/// its velocities are 0, no rows are written for it, and what they had given is kept.
///
/// Everything goes by ids, lowest first, so that the same steps give the same bits.
template <Scalar Real>
class SleepState {
 public:
  /// Nothing sleeps at first. The scene must have SceneSettings::sleeping.
  explicit SleepState(const Scene& scene);

  /// Whether the body sleeps.
  bool asleep(BodyId body) const { return island_[body] != awake; }
  /// Whether it writes no rows: all of its bodies sleep, or cannot be moved.
  bool joint_asleep(int joint) const;
  /// When the last step ended.
  const AwakeCount& count() const { return count_; }

  /// For each shape, whether it may meet what is not movable: shapes of awake and of moving bodies, and
  /// sensors, which see sleepers too.
  void mark_movable(const PerBody<Vec3<Real>>& velocity, List<char>& movable) const;
  /// Wakes every island that something awake, or kinematic and moving, touches or holds. Whether any was.
  bool wake_touched(const List<Manifold<Real>>& manifolds, const PerBody<Vec3<Real>>& velocity);
  /// Wakes the island of a body, and begins to count its time anew.
  void wake(BodyId body);
  /// Gives the impulses of woken rows back, as those of a step of dt [s]; keeps the list sorted.
  void give_back(List<std::pair<RowKey, Real>>& impulses, double dt);
  /// What forces have done to sleeping bodies is undone: their velocities are 0.
  void hold(PerBody<Vec3<Real>>& velocity) const;
  /// At the end of a step of dt [s], of which `problem` is the last solve, in substeps of problem.dt.
  void let_sleep(const List<Manifold<Real>>& manifolds, const VelocityProblem<Real>& problem, double dt,
                 PerBody<Vec3<Real>>& velocity);

 private:
  static constexpr BodyId awake = {-1};

  /// What a row had given when its island fell asleep.
  struct KeptImpulse {
    RowKey key = {};
    Real impulse = 0;  // [N s]
    double dt = 0;     // [s] of the substep it belongs to
    BodyId island = {};
  };

  template <typename Visit>
  void for_each_tie(const List<Manifold<Real>>& manifolds, const Visit& visit) const;
  bool is_dynamic(BodyId body) const { return type_[body] == BodyType::dynamic; }
  bool disturbs(BodyId body, const PerBody<Vec3<Real>>& velocity) const;
  void count_still_time(double dt, const PerBody<Vec3<Real>>& velocity);
  void connect(Span<const BodyId> tied, const PerBody<Vec3<Real>>& velocity);
  BodyId root_of(BodyId body);
  bool put_to_sleep(double dt, PerBody<Vec3<Real>>& velocity);
  void keep_impulses(const VelocityProblem<Real>& problem);

  Sleeping settings_;
  PerBody<BodyType> type_;
  PerBody<char> sensor_;
  List<BodyId> owner_;         // of each shape
  List<List<BodyId>> joints_;  // the bodies of each joint
  PerBody<BodyId> island_;     // the lowest id in its sleeping island, or `awake`
  PerBody<double> still_for_;  // [s] how long it has been slow
  List<KeptImpulse> kept_;
  bool has_woken_ = false;  // some of kept_ are to be given back
  AwakeCount count_ = {};

  // Scratch memory.
  PerBody<BodyId> parent_;  // in the forest of islands: never a higher id
  PerBody<char> restless_;  // of each root: some body of its island may not sleep yet
};

}  // namespace cairn
