// Floor 5. Sleeping: bodies at rest are left out of the steps until something wakes them.
#pragma once

#include <utility>

#include <cairn/constraints/row.hpp>
#include <cairn/dynamics/connected_bodies.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What takes part in the steps.
struct AwakeCount {
  int bodies = 0;   // dynamic ones
  int islands = 0;  // of them
};

/// Which bodies of a world sleep.
///
/// An island is a set of dynamic bodies that contacts and joints connect, directly or through each other.
/// What cannot be pushed connects nothing. An island falls asleep as a whole and wakes as a whole: once it is
/// touched or held by an awake body or by a kinematic one that moves, or once it is asked to. While it sleeps
/// its velocities are 0 and no rows are written for it: what they had given stays as it was.
///
/// A body may fall asleep where it is at rest: where it has stayed, for the time that the scene asks for,
/// within two thousandths of its size of one place, and was slower than the speeds of the scene. A small
/// velocity alone says nothing: what is driven keeps it or gains it, and leaves the place, while what rests
/// keeps the place though solves make it tremble. Two things are never at rest, however slow: what a motor
/// turns, and what gravity pulls and nothing unmovable holds.
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
  bool wake_touched(const List<Contact<Real>>& contacts, const PerBody<Vec3<Real>>& velocity);
  /// Wakes the island of a body, and begins to count its time anew.
  void wake(BodyId body);
  /// Takes over which of the first bodies sleep, and since when, from before the scene was edited. What is no
  /// dynamic body any more is awake.
  void carry_over(const SleepState& before);
  /// What forces have done to sleeping bodies is undone: their velocities are 0.
  void hold(PerBody<Vec3<Real>>& velocity) const;
  /// At the end of a step of dt [s], of which this is the state: what falls asleep loses its velocity.
  void let_sleep(const List<Contact<Real>>& contacts, double dt, BodyState<Real>& state);

 private:
  static constexpr BodyId awake = {-1};

  template <typename Visit>
  void for_each_connection(const List<Contact<Real>>& contacts, const Visit& visit) const;
  bool is_dynamic(BodyId body) const { return type_[body] == BodyType::dynamic; }
  bool disturbs(BodyId body, const PerBody<Vec3<Real>>& velocity) const;
  void note_drives(const Scene& scene);
  void count_still_time(double dt, const BodyState<Real>& state);
  bool is_still(BodyId body, const BodyState<Real>& state) const;
  void connect(Span<const BodyId> connected, const PerBody<Vec3<Real>>& velocity);
  void find_restless(double dt);
  void put_to_sleep(PerBody<Vec3<Real>>& velocity);

  Sleeping settings_;
  PerBody<BodyType> type_;
  PerBody<char> sensor_;
  List<BodyId> owner_;         // of each shape
  List<List<BodyId>> joints_;  // the bodies of each joint
  PerBody<BodyId> island_;     // the lowest id in its sleeping island, or `awake`
  PerBody<double> size_;       // [m] the radius of a circle around all shapes, about the centre of mass
  PerBody<char> falls_;        // unless something holds it
  PerBody<char> driven_;       // by a motor
  PerBody<Pose<Real>> place_;  // where it has stayed
  PerBody<double> still_for_;  // [s] how long it has
  AwakeCount count_ = {};

  // Scratch memory.
  ConnectedBodies connected_;
  PerBody<char> held_;      // of each body, and then of each root: by what cannot be pushed
  PerBody<char> restless_;  // of each root: some body of its island may not sleep yet
};

}  // namespace cairn
