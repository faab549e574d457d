// Floor 5. Contacts that a solver takes as they are: no rows of them are written.
#include <algorithm>
#include <limits>

#include "world/world.hpp"

namespace cairn {

namespace {

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

/// What a solver is told of contacts.
template <Scalar Real>
ContactProblem<Real> World<Real>::contact_problem(const ContactStabilization<Real>& stabilization) {
  const SceneSettings& settings = plan_->settings;
  return {.contacts = contacts_,
          .manifolds = record_.manifolds,
          .poses = &state_.pose,
          .frames = &frames_,
          .margin = static_cast<Real>(*settings.speculative_margin),
          .stabilization = &stabilization,
          .gravity = static_cast<Real>(settings.gravity.norm()),
          .problem = &record_.problem,
          .second_start = plan_->second_start,
          .ticket = ticket_};
}

template <Scalar Real>
void World<Real>::solve_contacts(ContactSolver<Real>& solver, StepReport& report) {
  has_rows_ = false;
  written_.forget();
  VelocityProblem<Real>& problem = record_.problem;
  problem.inverse_mass = state_.inverse_mass;
  problem.dt = substep_length();
  pose_before_ = state_.pose;
  velocity_before_ = problem.velocity;
  if (!follows_) take_contacts();
  const ContactStabilization<Real> stabilization(plan_->settings.stabilization,
                                                 StabilizationPass::velocity, problem.dt);
  ContactProblem<Real> contacts = contact_problem(stabilization);
  report.solve = solver.solve(contacts);
  report.count(report.solve);
  ticket_ = contacts.ticket;
  moving_velocity_ = problem.velocity;
  if (!plan_->relaxes) return;
  problem.velocity = velocity_before_;
  report.count(solver.relax(contacts));
}

/// Whether the solver goes on with the contacts of the substep before, for they have the same points. Where
/// it has them and cannot, slots get what it owes them.
template <Scalar Real>
bool World<Real>::follow_contacts(ContactSolver<Real>* solver) {
  follows_ = false;
  if (solver == nullptr || !may_follow_ || !ticket_.holder) return false;
  locate_bodies();
  const ContactStabilization<Real> stabilization(plan_->settings.stabilization,
                                                 StabilizationPass::velocity, substep_length());
  ContactProblem<Real> contacts = contact_problem(stabilization);
  follows_ = follow_odd_manifolds() && solver->follow(contacts);
  if (follows_) {
    std::fill(record_.is_new.begin(), record_.is_new.end(), char{0});
  } else if (owes_impulses_) {
    take_impulses(*solver, &Contact<Real>::impulse);
  }
  return follows_;
}

/// The same with those of the step before, where every manifold has outlived it: slots have their impulses,
/// and may lie elsewhere in memory.
template <Scalar Real>
bool World<Real>::follow_last_step(ContactSolver<Real>* solver) {
  const bool is_other = found_anew_ || candidates_ != candidates_before_;
  if (!plan_->keeps_manifolds || sleep_ || is_other || record_.problem.dt != substep_length()) return false;
  for (int i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].kept != nullptr) contacts_[i].kept = &graph_.lasting(touching_[i]).manifold;
  }
  return follow_contacts(solver);
}

/// Manifolds that solvers do not move; false where one has other points now.
template <Scalar Real>
bool World<Real>::follow_odd_manifolds() {
  stops_ = {};
  if (!odd_.empty()) look_ahead(substep_length());
  for (const OddContact& odd : odd_) {
    const Manifold<Real> manifold = moved_manifold(odd.slot);
    if (odd.contact == OddContact::none) {
      if (manifold.count > 0) return false;
      continue;
    }
    Manifold<Real>& before = record_.manifolds[odd.contact];
    if (manifold.count != before.count) return false;
    for (int i = 0; i < manifold.count; ++i) {
      if (manifold.points[i].feature != before.points[i].feature) return false;
    }
    before = manifold;
  }
  return !stops_.are_new && !stops_.are_waiting;
}

/// Gives every slot one of the two impulses that its contact has.
template <Scalar Real>
void World<Real>::take_impulses(ContactSolver<Real>& solver, FixedList<Real, 4> Contact<Real>::*impulse) {
  give_contacts(solver);
  owes_impulses_ = false;
  for (int i = 0; i < touching_.size(); ++i) {
    const Contact<Real>& contact = contacts_[i];
    if (has_slots_) {  // of these rows, and of substeps of this length
      FixedList<RowImpulse<Real>, 4>& rows = graph_[touching_[i]].impulses.rows;
      for (int k = 0; k < contact.count; ++k) rows[k].impulse = (contact.*impulse)[k];
      continue;
    }
    remember(graph_[touching_[i]].impulses, contact.count, record_.problem.dt, [&](int k) {
      return RowImpulse<Real>{part_of(record_.manifolds[i], contact, k), (contact.*impulse)[k]};
    });
  }
  has_slots_ = true;
}

/// What the solver has found out about the contacts of the last substep.
template <Scalar Real>
void World<Real>::give_contacts(ContactSolver<Real>& solver) {
  const ContactStabilization<Real> stabilization(plan_->settings.stabilization,
                                                 StabilizationPass::velocity, record_.problem.dt);
  ContactProblem<Real> contacts = contact_problem(stabilization);
  solver.give(contacts);
}

/// Of a substep that is not done: slots go back to what they would have had before it, and the next substep
/// begins from them.
template <Scalar Real>
void World<Real>::take_back_contacts(ContactSolver<Real>& solver) {
  if (owes_impulses_) {
    take_impulses(solver, &Contact<Real>::start);
  } else {
    give_contacts(solver);
  }
  ticket_ = {};
}

/// No solver goes on with contacts of before: where rows are solved, and where a step is not done.
template <Scalar Real>
void World<Real>::leave_contacts() {
  contacts_.clear();
  ticket_ = {};
  may_follow_ = follows_ = owes_impulses_ = has_slots_ = false;
}

/// Gives slots the answers now; or, where the solver may go on in the next substep, once it does not.
template <Scalar Real>
void World<Real>::remember_contacts(ContactSolver<Real>& solver, int number) {
  if (may_follow_ && number + 1 < plan_->substeps) {
    owes_impulses_ = true;
  } else {
    take_impulses(solver, &Contact<Real>::impulse);
  }
}

/// Contacts with last step's impulses, as warm_start() gives them to rows.
template <Scalar Real>
void World<Real>::take_contacts() {
  contacts_.resize(touching_.size());
  has_slots_ = false;
  int rows = 0;
  const Real dt = record_.problem.dt;
  may_follow_ = plan_->moves_manifolds && plan_->warm_start;
  for (int i = 0; i < touching_.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    Contact<Real>& contact = contacts_[i];
    contact.a = slot.a;
    contact.b = slot.b;
    contact.friction = slot.friction;
    contact.slop_limit = slot.slop_limit;
    const KeptManifold<Real>* kept = graph_.lasts() ? &graph_.lasting(touching_[i]).manifold : nullptr;
    contact.kept = kept && kept->is_whole(record_.manifolds[i]) ? kept : nullptr;
    contact.deepest = too_deep(slot);
    const bool still = state_.inverse_mass[slot.a].isZero(0) && state_.inverse_mass[slot.b].isZero(0);
    contact.count = still ? 0 : record_.manifolds[i].count * (slot.friction > 0 ? 2 : 1);
    rows += contact.count;
    if (record_.is_new.size() < rows) record_.is_new.resize(rows);
    const Real scale = slot.impulses.count > 0 ? dt / slot.impulses.dt : Real(1);
    may_follow_ = may_follow_ && scale >= 1;  // or remember() does not keep the whole impulse
    for (int k = 0; k < contact.count; ++k) {
      const RowImpulse<Real>* last = slot.impulses.find(part_of(record_.manifolds[i], contact, k), k);
      record_.is_new[rows - contact.count + k] = last == nullptr;
      contact.start[k] = last && plan_->warm_start ? scale * last->impulse : Real(0);
    }
  }
  record_.is_new.resize(rows);
}

/// Those that the solver has moved, where the bodies are.
template <Scalar Real>
void World<Real>::catch_up_with_manifolds() {
  for (int i = 0; i < touching_.size(); ++i) {
    const ContactSlot<Real>& slot = graph_[touching_[i]];
    const KeptManifold<Real>& kept = graph_.lasting(touching_[i]).manifold;
    Manifold<Real>& manifold = record_.manifolds[i];
    if (!kept.is_whole(manifold)) continue;
    manifold = kept.at(state_.pose[slot.a], state_.pose[slot.b], std::numeric_limits<Real>::infinity());
    manifold.collider_a = slot.collider_a;
    manifold.collider_b = slot.collider_b;
  }
}

/// The record with the rows that the last substep would have had, and with what it gave them.
template <Scalar Real>
StepRecord<Real> World<Real>::with_rows() const {
  World twin = *this;
  twin.state_.pose = pose_before_;
  if (follows_) twin.catch_up_with_manifolds();
  VelocityProblem<Real>& problem = twin.record_.problem;
  problem.velocity = velocity_before_;
  twin.write_rows(StabilizationPass::velocity, problem);
  if (plan_->relaxes) twin.relax_rows();
  problem.velocity = record_.problem.velocity;
  problem.impulse.clear();
  for (const Contact<Real>& contact : contacts_) {
    for (int k = 0; k < contact.count; ++k) problem.impulse.push_back(contact.impulse[k]);
  }
  return std::move(twin.record_);
}

/// Before something changes that rows are written from.
template <Scalar Real>
void World<Real>::keep_rows() {
  if (has_rows_) return;
  record_ = last_step();
  has_rows_ = true;
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
