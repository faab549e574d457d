// Floor 5. What a step tells of what has failed.
#include <algorithm>
#include <cmath>
#include <limits>

#include "math/list.hpp"
#include "world/world.hpp"

namespace cairn {

namespace {

/// Not angles alone.
template <Scalar Real>
bool holds_points(const Vec3<Real>& jacobian_a, const Vec3<Real>& jacobian_b) {
  return !jacobian_a.template head<2>().isZero(0) || !jacobian_b.template head<2>().isZero(0);
}

}  // namespace

/// Whether rows hold points that are farther apart than the circle around the smaller body reaches.
template <Scalar Real>
bool World<Real>::is_apart(const RowSpecs<Real>& specs) const {
  Real squared = 0, most = std::numeric_limits<Real>::infinity();
  for (const RowSpec<Real>& spec : specs) {
    const bool is_rigid = spec.bounds.is_equality() && !spec.softness && !spec.max_force;
    if (!is_rigid || !holds_points(spec.jacobian_a, spec.jacobian_b)) continue;
    squared += spec.error * spec.error;
    for (const BodyId body : {spec.a, spec.b})
      if (traits(body).radius > 0) most = std::min(most, traits(body).radius);
  }
  return squared > most * most;
}

template <Scalar Real>
void World<Real>::count_failures(StepReport& report) const {
  report.joints_apart = plan_->joints > 0 ? joints_apart_ : 0;
  if (follows_) {  // no other has been followed
    for (const OddContact& odd : odd_) {
      report.too_deep += odd.contact != OddContact::none && is_too_deep(odd.contact);
    }
  } else {
    for (int i = 0; i < record_.manifolds.size(); ++i) report.too_deep += is_too_deep(i);
  }
}

/// [m] Overlap of two shapes by half of the thinner body.
template <Scalar Real>
Real World<Real>::too_deep(const ContactSlot<Real>& slot) const {
  return 2 * std::min(traits(slot.a).failed_error, traits(slot.b).failed_error);  // each is a quarter
}

template <Scalar Real>
bool World<Real>::is_too_deep(int contact) const {
  const Manifold<Real>& manifold = record_.manifolds[contact];
  const Real most = too_deep(graph_[touching_[contact]]);
  const auto is_deep = [most](const auto& point) { return point.separation < -most; };
  return std::any_of(manifold.points.begin(), manifold.points.begin() + manifold.count, is_deep);
}

/// Of the bodies as the substep would leave them, the first that can be moved: what solves lose, they hand on
/// to whatever immovable body the row holds.
template <Scalar Real>
std::optional<BodyId> World<Real>::first_not_finite() const {
  const Real dt = substep_length();
  std::optional<BodyId> first;
  for (const BodyId body : state_.pose.indices()) {
    const Pose<Real>& pose = state_.pose[body];
    const Vec3<Real>& v = moving_velocity_[body];
    const bool finite = std::isfinite(pose.position.x() + dt * v.x()) &&
                        std::isfinite(pose.position.y() + dt * v.y()) &&
                        std::isfinite(pose.angle + dt * v.z()) && record_.problem.velocity[body].allFinite();
    if (finite) continue;
    if (state_.inverse_mass[body].x() > 0) return body;
    if (!first) first = body;
  }
  return first;
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
