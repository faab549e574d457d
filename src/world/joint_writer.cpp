// Floor 5. Rows of joints: written where bodies are, and given the impulses of before.
#include "world/joint_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

namespace {

// Of the length of a scene, and of 1 rad, in a substep: the arc of a shorter way, the square of this, is lost
// in rounding.
constexpr double still_way = 1e-9;

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

/// Not angles alone.
template <Scalar Real>
bool holds_points(const Vec3<Real>& jacobian_a, const Vec3<Real>& jacobian_b) {
  return !jacobian_a.template head<2>().isZero(0) || !jacobian_b.template head<2>().isZero(0);
}

}  // namespace

template <Scalar Real>
JointWriter<Real>::JointWriter(const Scene& scene) : pins_(std::make_shared<const Pins>(find_pins(scene))) {
  impulses_.resize(scene.joints().size() + 1);
}

template <Scalar Real>
void JointWriter<Real>::add_stiffness(const Substep<Real>& step, ForcesOf when,
                                      const VelocityProblem<Real>& problem, RowForces<Real>& forces,
                                      PerBody<Vec3<Real>>& stiffness) const {
  for (int i = 0; i < step.joint_count(); ++i) {
    if (step.asleep(i)) continue;
    take_forces(when, impulses_[i], problem, i, forces);
    if (!forces.rows.empty()) step.joint(i).add_stiffness(step.state.pose, forces, stiffness);
  }
}

template <Scalar Real>
int JointWriter<Real>::write(const Substep<Real>& step, StabilizationPass pass,
                             VelocityProblem<Real>& problem, int& next, List<RelaxedRow<Real>>* relaxed) {
  Stabilization stabilization = step.plan.settings.stabilization;
  if (step.plan.follows_arcs) look_along_arcs(step);
  locate_pins(step);
  PinRules<Real> rules = pin_rules(step, stabilization, pass);
  const auto has_mass = [&](const Pin& pin) {
    return problem.inverse_mass[pin.a].x() + problem.inverse_mass[pin.b].x() > 0;
  };
  int apart = 0;
  for (int i = 0; i < step.joint_count(); ++i) {
    const int first = next;
    if (!step.is_hand(i) && !(stabilization.joint_soft == step.scene.joint_soft(i))) {
      stabilization.joint_soft = step.scene.joint_soft(i);  // the hand has a spring of its own
      rules = pin_rules(step, stabilization, pass);
    }
    if (!step.asleep(i)) {
      const std::optional<Pin>* const pin = step.is_hand(i) ? nullptr : &pins_->of_joint[i];
      apart += pin && *pin && has_mass(**pin) ? write_pin(step, **pin, rules, problem, next, relaxed)
                                              : write_joint(step, i, rules, problem, next, relaxed);
    }
    problem.blocks.push_back({first, next - first});
  }
  return apart;
}

/// The rows of any joint, or of the hand; whether they hold points that are too far apart.
template <Scalar Real>
bool JointWriter<Real>::write_joint(const Substep<Real>& step, int number, const PinRules<Real>& rules,
                                    VelocityProblem<Real>& problem, int& next,
                                    List<RelaxedRow<Real>>* relaxed) {
  specs_.clear();
  step.joint(number).append_rows(step.state.pose, problem.velocity, specs_);
  const bool apart = is_apart(step);
  if (step.plan.follows_arcs) follow_arcs(step, number);
  const int first = next;
  for (const RowSpec<Real>& spec : specs_) {
    if (moves_nothing(spec, problem.inverse_mass)) continue;
    if (next == problem.row_count()) problem.rows.emplace_back();
    ConstraintRow<Real>& row = problem.rows[next++];
    stabilize_row(spec, rules.now, step.state, problem, step.source(number), first, row);
    if (!relaxed) continue;
    if (spec.softness) {
      relaxed->push_back({row.bias, row.softness});
    } else {
      relaxed->push_back({bias_velocity(spec, rules.again, problem.velocity), 0});
    }
  }
  return apart;
}

template <Scalar Real>
void JointWriter<Real>::look_along_arcs(const Substep<Real>& step) {
  poses_ahead_ = step.state.pose;
  goes_along_arc_.resize(poses_ahead_.size());
  const Real length = static_cast<Real>(step.plan.length), still = static_cast<Real>(still_way);
  for (const BodyId body : poses_ahead_.indices()) {
    const Vec3<Real> way = step.dt * step.state.velocity[body];
    poses_ahead_[body].position += way.template head<2>();
    poses_ahead_[body].angle += way.z();
    goes_along_arc_[body] = !(way.template head<2>().squaredNorm() < still * still * length * length &&
                              std::abs(way.z()) < still);
  }
}

/// Asks the rows of a joint, in specs_, to hold where the substep ends: those that hold now, which of one
/// side that only pushes is known by what it gave. Where bodies are all but still, there is no arc.
template <Scalar Real>
void JointWriter<Real>::follow_arcs(const Substep<Real>& step, int number) {
  const auto goes = [this](const RowSpec<Real>& spec) {
    return spec.extra_count > 0 || goes_along_arc_[spec.a] || goes_along_arc_[spec.b];
  };
  if (std::none_of(specs_.begin(), specs_.end(), goes)) return;
  specs_ahead_.clear();
  step.joint(number).append_rows(poses_ahead_, step.state.velocity, specs_ahead_);
  for (int i = 0; i < specs_.size(); ++i) {
    RowSpec<Real>& spec = specs_[i];
    if (spec.softness || spec.max_force) continue;
    if (!spec.bounds.is_equality()) {
      const RowImpulse<Real>* last = impulses_[number].find(spec.part, i);
      if (spec.error > 0 && !(last && last->impulse > 0)) continue;
    }
    for (const RowSpec<Real>& ahead : specs_ahead_) {
      if (ahead.part != spec.part) continue;
      spec.speed -= left_out_by_jacobian(spec, ahead, step.dt, step.state.velocity) / step.dt;
    }
  }
}

/// Whether specs_ hold points that are farther apart than the circle around the smaller body reaches.
template <Scalar Real>
bool JointWriter<Real>::is_apart(const Substep<Real>& step) const {
  Real squared = 0, most = std::numeric_limits<Real>::infinity();
  for (const RowSpec<Real>& spec : specs_) {
    const bool is_rigid = spec.bounds.is_equality() && !spec.softness && !spec.max_force;
    if (!is_rigid || !holds_points(spec.jacobian_a, spec.jacobian_b)) continue;
    squared += spec.error * spec.error;
    for (const BodyId body : {spec.a, spec.b})
      if (step.kinds[body].radius > 0) most = std::min(most, step.kinds[body].radius);
  }
  return squared > most * most;
}

template <Scalar Real>
void JointWriter<Real>::start(const Substep<Real>& step, VelocityProblem<Real>& problem,
                              PerRow<char>& is_new) const {
  for (int i = 0; i < step.joint_count(); ++i)
    start_rows(impulses_[i], problem.blocks[i], step.plan.warm_start, problem, is_new);
}

template <Scalar Real>
void JointWriter<Real>::remember(const Substep<Real>& step, const VelocityProblem<Real>& problem) {
  for (int i = 0; i < step.joint_count(); ++i)
    if (!step.asleep(i)) remember_rows(impulses_[i], problem.blocks[i], problem);
}

template <Scalar Real>
void JointWriter<Real>::carry_over(const JointWriter& before, const Scene& then, const Substep<Real>& step) {
  int joint = 0;  // of those before; ids ascend
  for (int i = 0; i < step.scene.joints().size(); ++i) {
    while (joint < then.joints().size() && then.joint_id(joint) < step.scene.joint_id(i)) ++joint;
    const bool is_old = joint < then.joints().size() && then.joint_id(joint) == step.scene.joint_id(i);
    if (is_old) impulses_[i] = before.impulses_[joint];
  }
  if (step.hand) impulses_.back() = before.impulses_.back();
}

template class JointWriter<float>;
template class JointWriter<double>;
template class JointWriter<long double>;

}  // namespace cairn
