// Floor 5. The boxes around shapes, and what they sweep over within a step.
#include <cairn/world/swept_boxes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

template <Scalar Real>
void SweptBoxes<Real>::follow_crowd(const List<Collider<Real>>& colliders,
                                    const PerBody<Vec3<Real>>& velocity, Real time) {
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
auto SweptBoxes<Real>::sweep(const Collider<Real>& it, const LookAhead<Real>& outlook) -> Sweep {
  const Real time = outlook.time(), infinity = std::numeric_limits<Real>::infinity();
  Sweep way = {Vec2<Real>::Constant(infinity), Vec2<Real>::Constant(-infinity)};
  Real turn = 0;
  outlook.for_each_velocity(it.body, [&](const Vec3<Real>& velocity) {
    way.lower = way.lower.cwiseMin(time * velocity.template head<2>());
    way.upper = way.upper.cwiseMax(time * velocity.template head<2>());
    turn = std::max(turn, std::abs(velocity.z()));
  });
  way.turning = time * (turn * (it.form->radius - it.form->core_radius) + outlook.leeway(it.body));
  return way;
}

/// Boxes that meet overlap in what they sweep over, rounded as it is: both have room for the rounding.
template <Scalar Real>
void SweptBoxes<Real>::find(const List<Collider<Real>>& colliders, const PerBody<Frame<Real>>& frames,
                            Real room, const LookAhead<Real>& outlook, int since) {
  const Vec2<Real> still = Vec2<Real>::Zero(), crowd = outlook.time() * crowd_speed_;
  const Vec2<Real> crowd_far = crowd_way_.cwiseAbs() + crowd.cwiseAbs();
  for (int i = 0; i < colliders.size(); ++i) {
    if (!outlook.has_changed(colliders[i].body, since)) continue;
    const Aabb<Real> box = bounding_box(*colliders[i].form->shape, frames[colliders[i].body], room);
    const Sweep way = sweep(colliders[i], outlook);
    const Vec2<Real> far =
        box.lower.cwiseAbs() + box.upper.cwiseAbs() + way.lower.cwiseAbs() + way.upper.cwiseAbs() + crowd_far;
    const Vec2<Real> around =
        (16 * std::numeric_limits<Real>::epsilon() * (far.array() + way.turning) + way.turning).matrix();
    boxes_[i] = box;
    sweeps_[i] = way;
    swept_[i] = {box.lower - crowd_way_ + still.cwiseMin(way.lower - crowd) - around,
                 box.upper - crowd_way_ + still.cwiseMax(way.upper - crowd) + around};
  }
}

template <Scalar Real>
bool SweptBoxes<Real>::meet(int i, int j) const {
  const Sweep &a = sweeps_[i], &b = sweeps_[j];
  const Vec2<Real> still = Vec2<Real>::Zero();
  const Real turning = a.turning + b.turning;
  const Aabb<Real> swept = {(boxes_[j].lower + still.cwiseMin(b.lower - a.upper)).array() - turning,
                            (boxes_[j].upper + still.cwiseMax(b.upper - a.lower)).array() + turning};
  return boxes_[i].overlaps(swept);
}

template class SweptBoxes<float>;
template class SweptBoxes<double>;

}  // namespace cairn
