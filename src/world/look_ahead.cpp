// Floor 5. How bodies would move within a step, against each other.
#include "world/look_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace cairn {

template <Scalar Real>
void LookAhead<Real>::begin(Real time, const PerBody<Vec3<Real>>& velocity) {
  time_ = time;
  alone_ = velocity;
  stopped_ = velocity;
  leeway_.assign(velocity.size(), Real(0));
  last_change_.assign(velocity.size(), 0);
  changes_ = 0;
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
template class LookAhead<long double>;

}  // namespace cairn
