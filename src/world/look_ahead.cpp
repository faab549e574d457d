// Floor 5. How bodies would move within a step, against each other.
#include <cairn/world/look_ahead.hpp>

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
Real LookAhead<Real>::travel(const Collider<Real>& a, const Collider<Real>& b,
                             const PerBody<Pose<Real>>& poses, Real enough) const {
  const Real radius_a = a.form->radius - a.form->core_radius, radius_b = b.form->radius - b.form->core_radius;
  const auto way_at = [&](Real speed) { return time_ * (speed + leeway(a.body) + leeway(b.body)); };
  Real most = 0;  // [m/s]
  for_each_velocity(a.body, [&](const Vec3<Real>& of_a) {
    for_each_velocity(b.body, [&](const Vec3<Real>& of_b) {
      const Vec2<Real> way = (of_b - of_a).template head<2>();
      Real speed = way.norm() + std::abs(of_a.z()) * radius_a + std::abs(of_b.z()) * radius_b;
      if ((of_a.z() != 0 || of_b.z() != 0) && way_at(speed) > enough) {
        const Real turn = std::abs(of_b.z() - of_a.z());
        const Vec2<Real> arm = poses[b.body].position - poses[a.body].position;
        speed = std::min({speed, (way - cross<Real>(of_a.z(), arm)).norm() + turn * radius_b,
                          (way - cross<Real>(of_b.z(), arm)).norm() + turn * radius_a});
      }
      most = std::max(most, speed);
    });
  });
  return way_at(most);
}

template class LookAhead<float>;
template class LookAhead<double>;

}  // namespace cairn
