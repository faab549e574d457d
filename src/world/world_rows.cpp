// Floor 5. Rows of a substep: written from joints and manifolds, and given the impulses of before.
#include <algorithm>

#include "world/world.hpp"

namespace cairn {

namespace {

// Rows of joints have sources below this (world_joints.cpp).
constexpr std::uint64_t contact_source_bit = std::uint64_t{1} << 63;

template <Scalar Real>
std::uint64_t contact_source(const ContactSlot<Real>& slot) {
  return contact_source_bit | static_cast<std::uint64_t>(slot.collider_a) << 31 |
         static_cast<std::uint64_t>(slot.collider_b);
}

}  // namespace

/// Over the rows of the substep before, whose memory is used again.
template <Scalar Real>
void World<Real>::write_rows(StabilizationPass pass, VelocityProblem<Real>& problem) {
  problem.blocks.clear();
  problem.extra_terms.clear();
  problem.inverse_mass = state_.inverse_mass;
  problem.dt = substep_length();
  int next = 0;
  write_joint_rows(pass, problem, next);
  record_.first_contact_block = problem.blocks.size();
  const ContactStabilization<Real> stabilization(scene_->settings().stabilization, pass, problem.dt);
  for (int i = 0; i < touching_.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    const int first = next;
    write_contact_rows(record_.manifolds[i], slot.a, slot.b, material(slot), state_.pose, state_.velocity,
                       stabilization, contact_source(slot), problem, next);
    problem.blocks.push_back({first, next - first});
  }
  problem.rows.resize(next);
}

/// The rows of record_.problem for the relaxing solve: contacts are those of the velocities, without their
/// springs and what these ask for.
template <Scalar Real>
void World<Real>::write_relaxing_rows() {
  const VelocityProblem<Real>& problem = record_.problem;
  second_problem_.velocity = problem.velocity;
  second_problem_.inverse_mass = problem.inverse_mass;
  second_problem_.dt = problem.dt;
  second_problem_.blocks.clear();
  second_problem_.extra_terms.clear();
  int next = 0;
  write_joint_rows(StabilizationPass::relax, second_problem_, next);
  second_problem_.blocks = problem.blocks;
  second_problem_.rows.resize(problem.rows.size());
  for (int i = next; i < problem.row_count(); ++i) {
    ConstraintRow<Real>& row = second_problem_.rows[i];
    row = problem.rows[i];
    if (row.softness > 0) row.bias = row.softness = 0;
  }
}

template <Scalar Real>
ContactMaterial<Real> World<Real>::material(const ContactSlot<Real>& slot) const {
  const SceneSettings& settings = scene_->settings();
  return {.friction = slot.friction,
          .restitution = slot.restitution,
          .restitution_threshold = static_cast<Real>(settings.restitution_threshold),
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

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
