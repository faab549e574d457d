// Floor 5. How bodies would move within a step, against each other.
#include "world/look_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

template <Scalar Real>
void LookAhead<Real>::take_room(int bodies, int shapes) {
  alone_.assign(bodies, Vec3<Real>::Zero());
  stopped_ = alone_;
  leeway_.assign(bodies, Real(0));
  boxes_.resize(shapes);
  swept_boxes_.resize(shapes);
  sweeps_.resize(shapes);
  speeds_.resize(shapes);
}

template <Scalar Real>
void LookAhead<Real>::follow_crowd(const List<Collider<Real>>& colliders, const PerBody<Vec3<Real>>& velocity,
                                   Real time) {
  if (colliders.empty()) return;
  for (int axis = 0; axis < 2; ++axis) {
    for (int i = 0; i < colliders.size(); ++i) speeds_[i] = velocity[colliders[i].body][axis];
    const auto middle = speeds_.begin() + speeds_.size() / 2;
    std::nth_element(speeds_.begin(), middle, speeds_.end());
    crowd_speed_[axis] = *middle;
  }
  crowd_way_ += time * crowd_speed_;
}

template <Scalar Real>
PerBody<Vec3<Real>>& LookAhead<Real>::begin(Real time) {
  time_ = time;
  return alone_;
}

template <Scalar Real>
auto LookAhead<Real>::sweep(const Collider<Real>& it) const -> Sweep {
  const Vec3<Real>&alone = alone_[it.body], &stopped = stopped_[it.body];
  const Vec2<Real> one = time_ * alone.template head<2>(), other = time_ * stopped.template head<2>();
  const Real turn = std::max(std::abs(alone.z()), std::abs(stopped.z()));
  const Real around = turn * (it.form->radius - it.form->core_radius) + leeway(it.body);
  return {one.cwiseMin(other), one.cwiseMax(other), time_ * around};
}

/// Boxes that meet overlap in what they sweep over, rounded as it is: both have room for the rounding.
template <Scalar Real>
void LookAhead<Real>::find_boxes(const List<Collider<Real>>& colliders, const PerBody<Frame<Real>>& frames,
                                 Real room) {
  const Vec2<Real> still = Vec2<Real>::Zero(), crowd = time_ * crowd_speed_;
  const Vec2<Real> crowd_far = crowd_way_.cwiseAbs() + crowd.cwiseAbs();
  for (int i = 0; i < colliders.size(); ++i) {
    const Aabb<Real> box = bounding_box(*colliders[i].form->shape, frames[colliders[i].body], room);
    const Sweep way = sweep(colliders[i]);
    const Vec2<Real> far =
        box.lower.cwiseAbs() + box.upper.cwiseAbs() + way.lower.cwiseAbs() + way.upper.cwiseAbs() + crowd_far;
    const Vec2<Real> around =
        (16 * std::numeric_limits<Real>::epsilon() * (far.array() + way.turning) + way.turning).matrix();
    boxes_[i] = box;
    sweeps_[i] = way;
    swept_boxes_[i] = {box.lower - crowd_way_ + still.cwiseMin(way.lower - crowd) - around,
                       box.upper - crowd_way_ + still.cwiseMax(way.upper - crowd) + around};
  }
}

template <Scalar Real>
bool LookAhead<Real>::meet(int i, int j) const {
  const Sweep &a = sweeps_[i], &b = sweeps_[j];
  const Vec2<Real> still = Vec2<Real>::Zero();
  const Real turning = a.turning + b.turning;
  const Aabb<Real> swept = {(boxes_[j].lower + still.cwiseMin(b.lower - a.upper)).array() - turning,
                            (boxes_[j].upper + still.cwiseMax(b.upper - a.lower)).array() + turning};
  return boxes_[i].overlaps(swept);
}

template <Scalar Real>
Real LookAhead<Real>::travel(const Collider<Real>& a, const Collider<Real>& b, const Places& places) const {
  Real most = 0;  // [m/s]
  for_each_course(a, b, places, [&most](const Course<Real>& one, const Course<Real>& other) {
    const Vec2<Real> way = (other.velocity - one.velocity).template head<2>();
    const Real turn_one = one.velocity.z(), turn_other = other.velocity.z();
    Real speed = way.norm() + std::abs(turn_one) * one.radius + std::abs(turn_other) * other.radius;
    if (turn_one != 0 || turn_other != 0) {
      const Real turn = std::abs(turn_other - turn_one);
      const Vec2<Real> arm = other.pose.position - one.pose.position;
      speed = std::min({speed, (way - cross<Real>(turn_one, arm)).norm() + turn * other.radius,
                        (way - cross<Real>(turn_other, arm)).norm() + turn * one.radius});
    }
    most = std::max(most, speed);
  });
  return time_ * (most + leeway(a.body) + leeway(b.body));
}

template class LookAhead<float>;
template class LookAhead<double>;

}  // namespace cairn
