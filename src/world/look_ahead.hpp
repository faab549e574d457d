// Floor 5. How bodies would move within a step, against each other, should nothing be in their way.
#pragma once

#include "collision/approach.hpp"
#include "dynamics/body.hpp"
#include "geometry/aabb.hpp"
#include "math/list.hpp"
#include "world/collider.hpp"

namespace cairn {

/// The courses of all bodies over the same time, on two accounts: as they go on, and as the contacts that
/// were found leave them. What only looks so, because all bodies go the same way, is told apart: boxes are as
/// the crowd sees them, which has the median of all velocities.
template <Scalar Real>
class LookAhead {
 public:
  /// For so many bodies and shapes.
  void take_room(int bodies, int shapes);
  /// Where bodies are now.
  struct Places {
    const PerBody<Pose<Real>>& poses;    // of all
    const PerBody<Frame<Real>>& frames;  // of these poses
  };

  /// The crowd has come along for `time` [s] with the velocities of now.
  void follow_crowd(const List<Collider<Real>>& colliders, const PerBody<Vec3<Real>>& velocity, Real time);
  /// Bodies go on for `time` [s] with the velocities that are written here; nothing stops them.
  PerBody<Vec3<Real>>& begin(Real time);
  /// Contacts that are found stop nobody yet.
  void stop_nobody() {
    stopped_ = alone_;
    stops_any_ = false;
  }

  /// [s] For how long.
  Real time() const { return time_; }
  /// A velocity as the contacts that were found leave it.
  const Vec3<Real>& stopped(BodyId body) const { return stopped_[body]; }
  /// Whether some contact stops it.
  bool is_stopped(BodyId body) const { return stops_any_ && stopped_[body] != alone_[body]; }
  /// Changes a velocity by what a contact does.
  void stop(BodyId body, const Vec3<Real>& change) {
    stopped_[body] += change;
    leeway_[body] = 0;
    stops_any_ = true;
  }
  /// [m/s] By how much others may change the velocity of a body that is stopped.
  Real leeway(BodyId body) const { return is_stopped(body) ? leeway_[body] : Real(0); }
  /// Gives a body that is stopped its leeway.
  void set_leeway(BodyId body, Real leeway) { leeway_[body] = leeway; }

  /// Finds where shapes are, in boxes that are `room` [m] larger on every side, and what these sweep over.
  void find_boxes(const List<Collider<Real>>& colliders, const PerBody<Frame<Real>>& frames, Real room);
  /// What each box sweeps over, as the crowd sees it. Two shapes that may meet overlap here.
  const List<Aabb<Real>>& swept_boxes() const { return swept_boxes_; }
  /// Whether the boxes of shapes i and j come together as one goes by the other.
  bool meet(int i, int j) const;

  /// [m] How far a point of one surface may come beside the other: as seen by who does not turn, or by who
  /// turns with one of the two. What turns together does not come any closer.
  Real travel(const Collider<Real>& a, const Collider<Real>& b, const Places& places) const;
  /// Calls visit(course_a, course_b) for what two shapes may do: each going on, and each as it is stopped.
  template <typename Visit>
  void for_each_course(const Collider<Real>& a, const Collider<Real>& b, const Places& places,
                       const Visit& visit) const {
    for (const PerBody<Vec3<Real>>* of_a : {&alone_, &stopped_}) {
      if (of_a == &stopped_ && !is_stopped(a.body)) continue;
      for (const PerBody<Vec3<Real>>* of_b : {&alone_, &stopped_}) {
        if (of_b == &stopped_ && !is_stopped(b.body)) continue;
        visit(course(a, places, *of_a), course(b, places, *of_b));
      }
    }
  }

 private:
  /// [m] The least and the most that a shape moves by, and what turning and leeway add on every side.
  struct Sweep {
    Vec2<Real> lower = Vec2<Real>::Zero();
    Vec2<Real> upper = Vec2<Real>::Zero();
    Real turning = 0;
  };

  /// What turning moves of a shape lies in the circle around its core.
  static Course<Real> course(const Collider<Real>& it, const Places& places,
                             const PerBody<Vec3<Real>>& velocity) {
    return {places.poses[it.body], velocity[it.body], it.form->radius - it.form->core_radius,
            &places.frames[it.body]};
  }
  Sweep sweep(const Collider<Real>& it) const;

  Real time_ = 0;
  PerBody<Vec3<Real>> alone_, stopped_;
  PerBody<Real> leeway_;  // of those that are stopped
  bool stops_any_ = false;
  Vec2<Real> crowd_way_ = Vec2<Real>::Zero();    // [m] since the beginning
  Vec2<Real> crowd_speed_ = Vec2<Real>::Zero();  // [m/s]
  List<Aabb<Real>> boxes_, swept_boxes_;
  List<Sweep> sweeps_;  // of boxes_
  List<Real> speeds_;   // scratch
};

}  // namespace cairn
