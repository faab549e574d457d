// Floor 5. Rows of a substep: written from joints and manifolds, and given the impulses of before.
#include <algorithm>
#include <cmath>

#include "world/world.hpp"

namespace cairn {

namespace {

// Row sources: joints by their ids, then the hand, then contacts.
constexpr std::uint64_t hand_source = std::uint64_t{1} << 62;
constexpr std::uint64_t contact_source_bit = std::uint64_t{1} << 63;
// Of the length of a scene, and of 1 rad, in a substep: the arc of a shorter way, the square of this, is lost
// in rounding.
constexpr double still_way = 1e-9;

template <Scalar Real>
std::uint64_t contact_source(const ContactSlot<Real>& slot) {
  return contact_source_bit | static_cast<std::uint64_t>(slot.collider_a) << 31 |
         static_cast<std::uint64_t>(slot.collider_b);
}

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

/// Over the rows of the substep before, whose memory is used again.
template <Scalar Real>
void World<Real>::write_rows(StabilizationPass pass, VelocityProblem<Real>& problem) {
  problem.blocks.clear();
  problem.extra_terms.clear();
  int next = 0;
  write_joint_rows(pass, problem, next);
  record_.first_contact_block = problem.blocks.size();
  const ContactStabilization<Real> stabilization(plan_->settings.stabilization, pass, problem.dt);
  int most = next;
  for (const Manifold<Real>& manifold : record_.manifolds) most += 2 * manifold.count;
  make_room(problem.rows, most);
  const bool solves_again = plan_->relaxes && pass == StabilizationPass::velocity;
  List<RelaxedRow<Real>>* const relaxed = solves_again ? &relaxed_rows_ : nullptr;
  for (int i = 0; i < touching_.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    const int first = next;
    write_contact_rows(record_.manifolds[i], slot.a, slot.b, material(slot), state_.pose, state_.velocity,
                       stabilization, contact_source(slot), problem, next, relaxed);
    problem.blocks.push_back({first, next - first});
  }
  problem.rows.resize(next);
}

/// For the second solve: without what takes errors back.
template <Scalar Real>
void World<Real>::relax_rows() {
  VelocityProblem<Real>& problem = record_.problem;
  for (int i = 0; i < problem.row_count(); ++i) {
    problem.rows[i].bias = relaxed_rows_[i].bias;
    problem.rows[i].softness = relaxed_rows_[i].softness;
  }
}

template <Scalar Real>
ContactMaterial<Real> World<Real>::material(const ContactSlot<Real>& slot) const {
  const SceneSettings& settings = plan_->settings;
  return {.friction = slot.friction,
          .restitution = slot.restitution,
          .restitution_threshold = static_cast<Real>(*settings.restitution_threshold),
          .friction_rows = settings.friction_rows,
          .slop_limit = slot.slop_limit,
          .gravity = static_cast<Real>(settings.gravity.norm())};
}

/// Calls visit(block, impulses) for every block of the problem and what its rows gave before. What sleeps is
/// left out: it keeps what it gave.
template <Scalar Real>
template <typename Visit>
void World<Real>::for_each_block(const Visit& visit) {
  const List<RowBlock>& blocks = record_.problem.blocks;
  const int ties = tie_count();
  for (int i = 0; i < ties; ++i) {
    if (!tie_asleep(i)) visit(blocks[i], joint_impulses_[i]);
  }
  for (int i = 0; i < touching_.size(); ++i) visit(blocks[ties + i], graph_[touching_[i]].impulses);
}

/// Gives every row the impulse that the row of the same name had in the last step, or 0 (paper 2.3). An
/// impulse grows with dt, so it is scaled when dt has changed; the paper's lambda, a force, would stay as it
/// is.
template <Scalar Real>
void World<Real>::warm_start() {
  VelocityProblem<Real>& problem = record_.problem;
  problem.impulse.resize(problem.rows.size());
  record_.is_new.resize(problem.rows.size());
  for_each_block([&](const RowBlock& block, const auto& before) {
    const Real scale = before.count > 0 ? problem.dt / before.dt : Real(1);
    for (int k = 0; k < block.count; ++k) {
      const int row = block.first + k;
      const RowImpulse<Real>* last = before.find(problem.rows[row].key.part, k);
      record_.is_new[row] = last == nullptr;
      problem.impulse[row] = last && plan_->warm_start ? scale * last->impulse : Real(0);
    }
  });
}

template <Scalar Real>
void World<Real>::remember_impulses() {
  const VelocityProblem<Real>& problem = record_.problem;
  for_each_block([&](const RowBlock& block, auto& impulses) {
    remember(impulses, block.count, problem.dt, [&](int k) {
      return RowImpulse<Real>{problem.rows[block.first + k].key.part, problem.impulse[block.first + k]};
    });
  });
}

template <Scalar Real>
void World<Real>::look_along_arcs() {
  poses_ahead_ = state_.pose;
  goes_along_arc_.resize(state_.pose.size());
  const Real length = static_cast<Real>(plan_->length), still = static_cast<Real>(still_way);
  for (const BodyId body : poses_ahead_.indices()) {
    const Vec3<Real> way = substep_length() * state_.velocity[body];
    poses_ahead_[body].position += way.template head<2>();
    poses_ahead_[body].angle += way.z();
    goes_along_arc_[body] = !(way.template head<2>().squaredNorm() < still * still * length * length &&
                              std::abs(way.z()) < still);
  }
}

/// Asks the rows of a joint, in specs_, to hold where the substep ends: those that hold now, which of one
/// side that only pushes is known by what it gave. Where bodies are all but still, there is no arc.
template <Scalar Real>
void World<Real>::follow_arcs(const Constraint& joint, const JointImpulses& impulses) {
  const auto goes = [this](const RowSpec<Real>& spec) {
    return spec.extra_count > 0 || goes_along_arc_[spec.a] || goes_along_arc_[spec.b];
  };
  if (std::none_of(specs_.begin(), specs_.end(), goes)) return;
  specs_ahead_.clear();
  joint.append_rows(poses_ahead_, state_.velocity, specs_ahead_);
  for (int i = 0; i < specs_.size(); ++i) {
    RowSpec<Real>& spec = specs_[i];
    if (spec.softness || spec.max_force) continue;
    if (!spec.bounds.is_equality()) {
      const RowImpulse<Real>* last = impulses.find(spec.part, i);
      if (spec.error > 0 && !(last && last->impulse > 0)) continue;
    }
    for (const RowSpec<Real>& ahead : specs_ahead_) {
      if (ahead.part != spec.part) continue;
      spec.speed -= left_out_by_jacobian(spec, ahead, substep_length(), state_.velocity) / substep_length();
    }
  }
}

template <Scalar Real>
void World<Real>::write_joint_rows(StabilizationPass pass, VelocityProblem<Real>& problem, int& next) {
  Stabilization stabilization = plan_->settings.stabilization;
  const int joints = scene_->joints().size();
  if (plan_->follows_arcs) look_along_arcs();
  locate_pins();
  PinRules<Real> rules = pin_rules(stabilization, pass);
  const auto has_mass = [&](const Pin& pin) {
    return problem.inverse_mass[pin.a].x() + problem.inverse_mass[pin.b].x() > 0;
  };
  if (pass == StabilizationPass::velocity) joints_apart_ = 0;
  relaxed_rows_.clear();
  for (int i = 0; i < tie_count(); ++i) {
    const int first = next;
    if (i < joints && !(stabilization.joint_soft == scene_->joint_soft(i))) {
      stabilization.joint_soft = scene_->joint_soft(i);  // the hand has a spring of its own
      rules = pin_rules(stabilization, pass);
    }
    if (!tie_asleep(i)) {
      const std::optional<Pin>* const pin = i < joints ? &pins_->of_joint[i] : nullptr;
      const bool is_apart = pin && *pin && has_mass(**pin) ? write_pin(**pin, rules, problem, next)
                                                           : write_tie(i, stabilization, pass, problem, next);
      joints_apart_ += pass == StabilizationPass::velocity && is_apart;
    }
    problem.blocks.push_back({first, next - first});
  }
}

/// The rows of any joint, or of the hand; whether they hold points that are too far apart.
template <Scalar Real>
bool World<Real>::write_tie(int number, const Stabilization& stabilization, StabilizationPass pass,
                            VelocityProblem<Real>& problem, int& next) {
  const bool is_joint = number < scene_->joints().size();
  const Constraint& tie = is_joint ? *scene_->joints()[number] : *hand_;
  specs_.clear();
  tie.append_rows(state_.pose, problem.velocity, specs_);
  const bool apart = is_apart(specs_);
  if (plan_->follows_arcs) follow_arcs(tie, joint_impulses_[number]);
  const auto source = is_joint ? static_cast<std::uint64_t>(scene_->joint_id(number).index) : hand_source;
  const int first = next;
  for (const RowSpec<Real>& spec : specs_) {
    if (moves_nothing(spec, problem.inverse_mass)) continue;
    if (next == problem.row_count()) problem.rows.emplace_back();
    ConstraintRow<Real>& row = problem.rows[next++];
    stabilize_row(spec, stabilization, pass, state_, problem, source, first, row);
    if (!plan_->relaxes || pass != StabilizationPass::velocity) continue;
    if (spec.softness) {
      relaxed_rows_.push_back({row.bias, row.softness});
    } else {
      const auto relaxed = StabilizationPass::relax;
      relaxed_rows_.push_back({bias_velocity(spec, stabilization, relaxed, problem.dt, problem.velocity), 0});
    }
  }
  return apart;
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
