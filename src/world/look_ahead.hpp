// Floor 5. How bodies would move within a step, against each other, should nothing be in their way.
#pragma once

#include <cairn/collision/approach.hpp>
#include <cairn/dynamics/body.hpp>
#include <cairn/world/collider.hpp>

namespace cairn {

/// The courses of all bodies over the same time, on two accounts: as they go on, and as the contacts that
/// were found leave them. Changes of the second are numbered, so that what was seen before one of a body is
/// looked at again, and nothing else.
template <Scalar Real>
class LookAhead {
 public:
  /// Where bodies are now.
  struct Places {
    const PerBody<Pose<Real>>& poses;    // of all
    const PerBody<Frame<Real>>& frames;  // of these poses
  };

  /// Bodies go on for `time` [s] with these velocities. Contacts stop nobody yet.
  void begin(Real time, const PerBody<Vec3<Real>>& velocity);

  /// [s] For how long.
  Real time() const { return time_; }
  /// A velocity as the contacts that were found leave it.
  const Vec3<Real>& stopped(BodyId body) const { return stopped_[body]; }
  /// Whether some contact stops it.
  bool is_stopped(BodyId body) const { return last_change_[body] > 0; }
  /// Changes a velocity by what a contact does.
  void stop(BodyId body, const Vec3<Real>& change) {
    stopped_[body] += change;
    leeway_[body] = 0;
    last_change_[body] = ++changes_;
  }
  /// [m/s] By how much others may change the velocity of a body that is stopped.
  Real leeway(BodyId body) const { return leeway_[body]; }
  /// Gives a body that is stopped its leeway.
  void set_leeway(BodyId body, Real leeway) { leeway_[body] = leeway; }
  /// How many changes there were.
  int changes() const { return changes_; }
  /// Whether some came after so many.
  bool has_changed(BodyId body, int since) const { return last_change_[body] > since; }

  /// [m] How far a point of one surface may come beside the other: as seen by who does not turn, or by who
  /// turns with one of the two. What turns together does not come any closer. Of ways up to `enough` [m], one
  /// that is no shorter will do.
  Real travel(const Collider<Real>& a, const Collider<Real>& b, const PerBody<Pose<Real>>& poses,
              Real enough = 0) const;
  /// Calls visit(velocity) for what a body may do: going on, and as it is stopped.
  template <typename Visit>
  void for_each_velocity(BodyId body, const Visit& visit) const {
    visit(alone_[body]);
    if (is_stopped(body)) visit(stopped_[body]);
  }
  /// Calls visit(course_a, course_b) for what two shapes may do: each going on, and each as it is stopped.
  template <typename Visit>
  void for_each_course(const Collider<Real>& a, const Collider<Real>& b, const Places& places,
                       const Visit& visit) const {
    for_each_velocity(a.body, [&](const Vec3<Real>& of_a) {
      for_each_velocity(
          b.body, [&](const Vec3<Real>& of_b) { visit(course(a, places, of_a), course(b, places, of_b)); });
    });
  }

 private:
  /// What turning moves of a shape lies in the circle around its core.
  static Course<Real> course(const Collider<Real>& it, const Places& places, const Vec3<Real>& velocity) {
    return {places.poses[it.body], velocity, it.form->radius - it.form->core_radius, &places.frames[it.body]};
  }

  Real time_ = 0;
  PerBody<Vec3<Real>> alone_, stopped_;
  PerBody<Real> leeway_;
  PerBody<int> last_change_;  // its number, counted from 1; 0: none
  int changes_ = 0;
};

}  // namespace cairn
