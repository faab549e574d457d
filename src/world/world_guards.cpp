// Floor 5. What looks after solves that fail: before the solve, behind it, and before anything moves.
#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/impulse_energy.hpp"
#include "world/last_word.hpp"
#include "world/world.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

/// Not angles alone.
template <Scalar Real>
bool holds_points(const Vec3<Real>& jacobian_a, const Vec3<Real>& jacobian_b) {
  return !jacobian_a.template head<2>().isZero(0) || !jacobian_b.template head<2>().isZero(0);
}

/// A joint that has come apart by more than a quarter of the smaller of its bodies has failed, unless it is a
/// spring: what is further is taken back no faster, for Baumgarte would give the bodies beta C / dt of an
/// error C without end.
template <Scalar Real, typename FailedError>
void limit_joint_bias(int joints, Real rate, const FailedError& failed_error,
                      VelocityProblem<Real>& problem) {
  if (!(rate > 0)) return;
  for (int i = 0; i < joints; ++i) {
    const RowBlock& block = problem.blocks[i];
    for (int k = block.first; k < block.first + block.count; ++k) {
      ConstraintRow<Real>& row = problem.rows[k];
      const bool is_rigid = row.bounds.is_equality() && !(row.softness > 0);
      if (!is_rigid || !holds_points(row.jacobian_a, row.jacobian_b)) continue;
      const Real most = rate * std::min(failed_error(row.a), failed_error(row.b));
      row.bias = std::clamp(row.bias, -most, most);
    }
  }
}

}  // namespace

/// Begins from no more of last step's impulses than does good, and never from such as nothing in the scene
/// explains; and asks no joint that has failed for speeds without end.
template <Scalar Real>
void World<Real>::guard_warm_start(StepReport& report) {
  const Stabilization& stabilization = scene_->settings().stabilization;
  limit_impulses(record_.problem);
  if (stabilization.policy == StabilizationPolicy::baumgarte ||
      stabilization.policy == StabilizationPolicy::relaxed)
    limit_joint_bias(
        scene_->joints().size(), static_cast<Real>(stabilization.baumgarte) / substep_length(),
        [this](BodyId body) { return traits(body).failed_error; }, record_.problem);
  const Real share = limit_warm_start(record_.problem, energy_);
  report.warm_share = std::min(report.warm_share, static_cast<double>(share));
}

/// Sweeps that were too few, or in which rows quarrel, may leave more energy than any row asks for; so may
/// those that end at a wide tolerance.
template <Scalar Real>
void World<Real>::guard_solve(StepReport& report) {
  const Real share = limit_solved(record_.problem, energy_);
  report.solved_share = std::min(report.solved_share, static_cast<double>(share));
}

/// Where the solve has left bodies going through each other, they are stopped: in how they move and in what
/// they keep. In every other step this changes nothing.
template <Scalar Real>
void World<Real>::keep_apart(StepReport& report) {
  const VelocityProblem<Real>& problem = record_.problem;
  int block = record_.first_contact_block;
  const auto limits_of = [&](const Manifold<Real>& manifold, const auto& visit) {
    const BodyId a = (*colliders_)[manifold.collider_a].body, b = (*colliders_)[manifold.collider_b].body;
    const Real depth = std::min(traits(a).failed_error, traits(b).failed_error);
    int row = problem.blocks[block++].first;
    for (int i = 0; i < manifold.count; ++i, ++row) {
      while (!problem.rows[row].bounds.is_unilateral()) ++row;
      visit(ContactLimit<Real>{row, manifold.points[i].separation, depth});
    }
  };
  bool any = false;
  for (const Manifold<Real>& manifold : record_.manifolds)
    limits_of(manifold, [&](const ContactLimit<Real>& limit) {
      any = any || goes_too_deep(problem, limit, moving_velocity_);
    });
  if (!any) return;
  report.kept_apart += 1;
  List<ContactLimit<Real>> limits;
  block = record_.first_contact_block;
  for (const Manifold<Real>& manifold : record_.manifolds)
    limits_of(manifold, [&](const ContactLimit<Real>& limit) { limits.push_back(limit); });
  keep_bodies_apart(problem, limits, moving_velocity_);
  keep_bodies_apart(problem, limits, record_.problem.velocity);
}

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

/// [J]
template <Scalar Real>
Real World<Real>::kinetic_energy(const PerBody<Vec3<Real>>& velocity) const {
  Real twice = 0;
  for (const BodyId body : velocity.indices()) {
    for (int k = 0; k < 3; ++k) {
      const Real inverse = state_.inverse_mass[body][k];
      if (inverse > 0) twice += velocity[body][k] * velocity[body][k] / inverse;
    }
  }
  return twice / 2;
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
