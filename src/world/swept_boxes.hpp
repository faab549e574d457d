// Floor 5. The boxes around shapes, and what they sweep over within a step.
#pragma once

#include <cairn/geometry/aabb.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/look_ahead.hpp>

namespace cairn {

/// What only looks like a way because all bodies go it is told apart: boxes are as the crowd sees them, which
/// has the median of all velocities.
template <Scalar Real>
class SweptBoxes {
 public:
  /// Of so many shapes.
  explicit SweptBoxes(int shapes) : boxes_(shapes), swept_(shapes), sweeps_(shapes), speeds_(shapes) {}

  /// The crowd has come along for `time` [s] with the velocities of now.
  void follow_crowd(const List<Collider<Real>>& colliders, const PerBody<Vec3<Real>>& velocity, Real time);
  /// Finds where shapes are, in boxes that are `room` [m] larger on every side, and what these sweep over:
  /// of those whose bodies have changed since so many changes of the outlook, and below 0 of all.
  void find(const List<Collider<Real>>& colliders, const PerBody<Frame<Real>>& frames, Real room,
            const LookAhead<Real>& outlook, int since);
  /// What each box sweeps over, as the crowd sees it. Two shapes that may meet overlap here.
  const List<Aabb<Real>>& boxes() const { return swept_; }
  /// Whether the boxes of shapes i and j come together as one goes by the other.
  bool meet(int i, int j) const;

 private:
  /// [m] The least and the most that a shape moves by, and what turning and leeway add on every side.
  struct Sweep {
    Vec2<Real> lower = Vec2<Real>::Zero();
    Vec2<Real> upper = Vec2<Real>::Zero();
    Real turning = 0;
  };

  static Sweep sweep(const Collider<Real>& it, const LookAhead<Real>& outlook);

  Vec2<Real> crowd_way_ = Vec2<Real>::Zero();    // [m] since the beginning
  Vec2<Real> crowd_speed_ = Vec2<Real>::Zero();  // [m/s]
  List<Aabb<Real>> boxes_, swept_;
  List<Sweep> sweeps_;  // of boxes_
  List<Real> speeds_;   // scratch
};

}  // namespace cairn
