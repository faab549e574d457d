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

/// Keeps what the rows of a block have given: row(k) is the k-th. Rows that have vanished are forgotten. What
/// a step has added to an impulse made good for errors of the velocities, which do not grow with dt as forces
/// do. After a shorter step than the last one, only a share of it is kept: as much as it will be again when
/// it is scaled for a longer one.
template <typename Impulses, Scalar Real, typename Row>
void remember(Impulses& impulses, int count, Real dt, const Row& row) {
  const Real share = impulses.count > 0 ? dt / impulses.dt : Real(1);
  Impulses before;
  if (share < 1) before = impulses;
  impulses.count = count;
  impulses.dt = dt;
  if constexpr (requires { impulses.rows.resize(0); }) impulses.rows.resize(count);
  for (int k = 0; k < count; ++k) {
    RowImpulse<Real> now = row(k);
    const RowImpulse<Real>* old = before.find(now.part, k);
    if (old) now.impulse = share * (old->impulse + now.impulse - share * old->impulse);
    impulses.rows[k] = now;
  }
}

/// RowKey::part of the k-th row that a contact has, or would have.
template <Scalar Real>
std::uint64_t part_of(const Manifold<Real>& manifold, const Contact<Real>& contact, int k) {
  if (!(contact.friction > 0)) return normal_part(manifold.points[k].feature);
  const std::uint32_t feature = manifold.points[k / 2].feature;
  return k % 2 == 0 ? normal_part(feature) : friction_part(feature);
}

}  // namespace

/// The solver, where it takes contacts as they are and there is nothing else to solve.
template <Scalar Real>
ContactSolver<Real>* World<Real>::contact_solver(Solver<Real>& solver) const {
  return plan_->contacts_alone && !hand_ ? solver.for_contacts() : nullptr;
}

template <Scalar Real>
void World<Real>::solve_contacts(ContactSolver<Real>& solver, StepReport& report) {
  has_rows_ = false;
  VelocityProblem<Real>& problem = record_.problem;
  problem.inverse_mass = state_.inverse_mass;
  problem.dt = substep_length();
  pose_before_ = state_.pose;
  velocity_before_ = problem.velocity;
  const ContactStabilization<Real> stabilization(scene_->settings().stabilization,
                                                 StabilizationPass::velocity, problem.dt);
  take_contacts();
  ContactProblem<Real> contacts{.contacts = contacts_,
                                .manifolds = record_.manifolds,
                                .poses = &pose_before_,
                                .stabilization = &stabilization,
                                .gravity = static_cast<Real>(scene_->settings().gravity.norm()),
                                .problem = &problem};
  report.solve = solver.solve(contacts);
  report.sweeps += report.solve.iterations;
  moving_velocity_ = problem.velocity;
  if (!plan_->relaxes) return;
  problem.velocity = velocity_before_;
  report.sweeps += solver.relax(contacts).iterations;
}

/// Contacts with last step's impulses, as warm_start() gives them to rows.
template <Scalar Real>
void World<Real>::take_contacts() {
  contacts_.resize(touching_.size());
  int rows = 0;
  const Real dt = record_.problem.dt;
  for (int i = 0; i < touching_.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    Contact<Real>& contact = contacts_[i];
    contact.a = slot.a;
    contact.b = slot.b;
    contact.friction = slot.friction;
    contact.slop_limit = slot.slop_limit;
    const bool still = state_.inverse_mass[slot.a].isZero(0) && state_.inverse_mass[slot.b].isZero(0);
    contact.count = still ? 0 : record_.manifolds[i].count * (slot.friction > 0 ? 2 : 1);
    rows += contact.count;
    if (record_.is_new.size() < rows) record_.is_new.resize(rows);
    const Real scale = slot.impulses.count > 0 ? dt / slot.impulses.dt : Real(1);
    for (int k = 0; k < contact.count; ++k) {
      const RowImpulse<Real>* last = slot.impulses.find(part_of(record_.manifolds[i], contact, k), k);
      record_.is_new[rows - contact.count + k] = last == nullptr;
      contact.impulse[k] = last && plan_->warm_start ? scale * last->impulse : Real(0);
    }
  }
  record_.is_new.resize(rows);
}

/// The rows that the last substep would have had, with what it gave them.
template <Scalar Real>
void World<Real>::write_record() const {
  World twin = *this;
  twin.has_rows_ = true;
  twin.state_.pose = pose_before_;
  VelocityProblem<Real>& problem = twin.record_.problem;
  problem.velocity = velocity_before_;
  twin.write_rows(StabilizationPass::velocity, problem);
  if (plan_->relaxes) {
    twin.write_relaxing_rows();
    std::swap(problem, twin.second_problem_);
  }
  problem.velocity = record_.problem.velocity;
  problem.impulse.clear();
  for (const Contact<Real>& contact : contacts_) {
    for (int k = 0; k < contact.count; ++k) problem.impulse.push_back(contact.impulse[k]);
  }
  record_ = std::move(twin.record_);
  has_rows_ = true;
}

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
  if (!has_rows_) {
    for (int i = 0; i < touching_.size(); ++i) {
      const Contact<Real>& contact = contacts_[i];
      remember(graph_[touching_[i]].impulses, contact.count, problem.dt, [&](int k) {
        return RowImpulse<Real>{part_of(record_.manifolds[i], contact, k), contact.impulse[k]};
      });
    }
    return;
  }
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
