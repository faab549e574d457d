// Floor 5. Rows of the joints and of the hand.
#include <algorithm>
#include <cmath>

#include "world/world.hpp"

namespace cairn {

namespace {

// Row sources: joints by their ids, then the hand; those of contacts are above (world_rows.cpp).
constexpr std::uint64_t hand_source = std::uint64_t{1} << 62;

/// Whether no impulse of a row could change a velocity, as that of a row for the angle between the ground and
/// a body that never turns: A_ii is 0, so it is not written. No row names one like it for its bounds.
template <Scalar Real>
bool moves_nothing(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& inverse_mass) {
  const auto is_still = [&](BodyId body, const Vec3<Real>& jacobian) {
    return inverse_mass[body].cwiseProduct(jacobian).isZero(0);
  };
  bool still = is_still(spec.a, spec.jacobian_a) && is_still(spec.b, spec.jacobian_b);
  for (int k = 0; k < spec.extra_count; ++k) {
    const RowTerm<Real>& term = spec.extra[k];
    still = still && is_still(term.body, term.jacobian);
  }
  return still;
}

}  // namespace

template <Scalar Real>
void World<Real>::look_along_arcs() {
  poses_ahead_ = state_.pose;
  for (const BodyId body : poses_ahead_.indices()) {
    const Vec3<Real> way = substep_length() * state_.velocity[body];
    poses_ahead_[body].position += way.template head<2>();
    poses_ahead_[body].angle += way.z();
  }
}

/// Asks the rows of a joint, in specs_, to hold where the substep ends. Not where its bodies leave the
/// tangents of their arcs by so much that the joint would have failed: such a substep is too long to follow
/// them.
template <Scalar Real>
void World<Real>::follow_arcs(const Constraint& joint) {
  const Real dt = substep_length();
  specs_ahead_.clear();
  joint.append_rows(poses_ahead_, state_.velocity, specs_ahead_);
  for (RowSpec<Real>& spec : specs_) {
    if (!spec.bounds.is_equality() || spec.softness || spec.max_force) continue;
    for (const RowSpec<Real>& ahead : specs_ahead_) {
      if (ahead.part != spec.part) continue;
      const Real left_out = left_out_by_jacobian(spec, ahead, dt, state_.velocity);
      if (std::abs(left_out) <= std::min(failed_error_[spec.a], failed_error_[spec.b]))
        spec.speed -= left_out / dt;
    }
  }
}

template <Scalar Real>
void World<Real>::write_joint_rows(StabilizationPass pass, VelocityProblem<Real>& problem, int& next) {
  Stabilization stabilization = scene_->settings().stabilization;
  const int joints = scene_->joints().size();
  if (plan_->follows_arcs) look_along_arcs();
  if (pass == StabilizationPass::velocity) joints_apart_ = 0;
  for (int i = 0; i < tie_count(); ++i) {
    specs_.clear();
    const Constraint& tie = i < joints ? *scene_->joints()[i] : *hand_;
    if (!tie_asleep(i)) {
      tie.append_rows(state_.pose, problem.velocity, specs_);
      joints_apart_ += pass == StabilizationPass::velocity && is_apart(specs_);
      if (plan_->follows_arcs) follow_arcs(tie);
    }
    if (i < joints) stabilization.joint_soft = scene_->joint_soft(i);  // the hand has a spring of its own
    const auto source = i < joints ? static_cast<std::uint64_t>(scene_->joint_id(i).index) : hand_source;
    const int first = next;
    for (const RowSpec<Real>& spec : specs_) {
      if (moves_nothing(spec, problem.inverse_mass)) continue;
      if (next == problem.row_count()) problem.rows.emplace_back();
      problem.rows[next++] = stabilized_row(spec, stabilization, pass, problem, source, first);
    }
    problem.blocks.push_back({first, next - first});
  }
}

/// A joint whose bodies sleep; the hand holds none that does.
template <Scalar Real>
bool World<Real>::tie_asleep(int tie) const {
  return sleep_ && tie < scene_->joints().size() && sleep_->joint_asleep(tie);
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
