// Floor 5. The step.
#include "world/world.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

// Row sources: joints by number, then contacts by their two colliders.
constexpr std::uint64_t contact_source_bit = std::uint64_t{1} << 63;

std::uint64_t contact_source(int collider_a, int collider_b) {
  return contact_source_bit | static_cast<std::uint64_t>(collider_a) << 31 |
         static_cast<std::uint64_t>(collider_b);
}

/// Finds the impulses of rows, asked for in the order of their sources, which is also that of the list: one
/// pass over both.
template <Scalar Real>
class ImpulseFinder {
 public:
  explicit ImpulseFinder(const List<std::pair<RowKey, Real>>& impulses)
      : next_(impulses.begin()), end_(impulses.end()) {}

  /// Null where the row has none.
  const Real* find(const RowKey& key) {
    while (next_ != end_ && next_->first.source < key.source) ++next_;
    for (auto entry = next_; entry != end_ && entry->first.source == key.source; ++entry) {
      if (entry->first.part == key.part) return &entry->second;
    }
    return nullptr;
  }

 private:
  typename List<std::pair<RowKey, Real>>::const_iterator next_, end_;
};

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
StepReport World<Real>::step(Solver<Real>& solver, SolveObserver<Real>* observer) {
  StepReport report;
  for (int i = 0; i < scene_->settings().substeps && !report.not_finite; ++i) {
    substep(solver, observer, report);
  }
  report.awake.bodies = plan_->dynamic_bodies;
  if (sleep_) {
    if (!report.not_finite) sleep_->let_sleep(record_.manifolds, record_.problem, dt_, state_.velocity);
    report.awake = sleep_->count();
  }
  time_ += dt_;
  steps_ += 1;
  report.rows = record_.problem.row_count();
  for (const Manifold<Real>& manifold : record_.manifolds) report.contacts += manifold.count;
  return report;
}

template <Scalar Real>
void World<Real>::substep(Solver<Real>& solver, SolveObserver<Real>* observer, StepReport& report) {
  find_contacts();  // 1, 2  poses -> pairs -> manifolds
  apply_forces();   // 3     v_1 = v + dt M^-1 f: gravity is in before any constraint is solved
  write_rows(StabilizationPass::velocity, record_.problem);  // 4  joints and manifolds -> rows,
  warm_start();                                              //    with last step's impulses
  if (plan_->guarded) guard_warm_start(report);
  if (plan_->relaxes) {
    second_problem_.velocity = record_.problem.velocity;
    write_rows(StabilizationPass::relax, second_problem_);
  }
  report.solve = solver.solve(record_.problem, observer);  // 5  -> impulses, v_2
  report.sweeps += report.solve.iterations;
  if (plan_->guarded) guard_solve(report);

  moving_velocity_ = record_.problem.velocity;
  if (plan_->corrects_positions) correct_positions(solver, report);
  if (plan_->relaxes) relax(solver, report);
  if (plan_->guarded) keep_apart(report);
  report.not_finite = first_not_finite();
  if (report.not_finite) return;  // nothing has moved, and the impulses remembered are those of before
  state_.velocity.swap(moving_velocity_);
  integrate_positions(state_, substep_length());  // 6  with the new velocities: semi-implicit Euler
  state_.velocity = record_.problem.velocity;
  remember_impulses();  // 7
}

/// The policy soft: solves again from v_1, without the springs that move the positions, so that their
/// speed does not stay in the velocities.
template <Scalar Real>
void World<Real>::relax(Solver<Real>& solver, StepReport& report) {
  second_problem_.impulse = record_.problem.impulse;
  report.sweeps += solver.solve(second_problem_).iterations;
  std::swap(record_.problem, second_problem_);
  if (plan_->guarded) guard_solve(report);
}

/// The policy split_impulse: adds velocities that take errors back. The velocities of the step come back once
/// positions are integrated.
template <Scalar Real>
void World<Real>::correct_positions(Solver<Real>& solver, StepReport& report) {
  second_problem_.velocity = record_.problem.velocity;
  write_rows(StabilizationPass::position, second_problem_);
  for (Vec3<Real>& v : second_problem_.velocity) v.setZero();
  second_problem_.impulse.assign(second_problem_.rows.size(), Real(0));
  report.sweeps += solver.solve(second_problem_).iterations;
  for (const BodyId body : moving_velocity_.indices())
    moving_velocity_[body] += second_problem_.velocity[body];
}

template <Scalar Real>
VelocityProblem<Real> World<Real>::velocity_problem() const {
  World twin = *this;
  twin.find_contacts();
  twin.apply_forces();
  twin.write_rows(StabilizationPass::velocity, twin.record_.problem);
  twin.warm_start();
  return twin.record_.problem;
}

template <Scalar Real>
void World<Real>::apply_forces() {
  const Real dt = substep_length();
  record_.problem.velocity = state_.velocity;
  if (plan_->gravity) {
    const Vec2<Real> gravity = scene_->settings().gravity.template cast<Real>();
    apply_gravity(record_.problem.velocity, state_.inverse_mass, forces_, gravity, dt);
  }
  if (plan_->damping) apply_damping(record_.problem.velocity, state_.inverse_mass, forces_, dt);
  if (sleep_) sleep_->hold(record_.problem.velocity);
}

template <Scalar Real>
void World<Real>::write_rows(StabilizationPass pass, VelocityProblem<Real>& problem) {
  problem.rows.clear();
  problem.blocks.clear();
  problem.extra_terms.clear();
  problem.inverse_mass = state_.inverse_mass;
  problem.dt = substep_length();
  for (int i = 0; i < scene_->joints().size(); ++i) {
    specs_.clear();
    const bool asleep = sleep_ && sleep_->joint_asleep(i);
    if (!asleep) scene_->joints()[i]->append_rows(state_.pose, problem.velocity, specs_);
    append_block(pass, static_cast<std::uint64_t>(i), problem);
  }
  for (const Manifold<Real>& manifold : record_.manifolds) {
    const BodyId a = (*colliders_)[manifold.collider_a].body;
    const BodyId b = (*colliders_)[manifold.collider_b].body;
    specs_.clear();
    append_contact_rows(manifold, a, b, material(a, b), state_.pose, state_.velocity, specs_);
    append_block(pass, contact_source(manifold.collider_a, manifold.collider_b), problem);
  }
}

template <Scalar Real>
void World<Real>::append_block(StabilizationPass pass, std::uint64_t source, VelocityProblem<Real>& problem) {
  const int first = problem.row_count();
  for (const RowSpec<Real>& spec : specs_) {
    if (moves_nothing(spec, problem.inverse_mass)) continue;
    problem.rows.push_back(
        stabilized_row(spec, scene_->settings().stabilization, pass, problem, source, first));
  }
  problem.blocks.push_back({first, problem.row_count() - first});
}

/// Gives every row the impulse that the row of the same name had in the last step, or 0 (paper 2.3). An
/// impulse grows with dt, so it is scaled when dt has changed; the paper's lambda, a force, would stay as it
/// is.
template <Scalar Real>
void World<Real>::warm_start() {
  VelocityProblem<Real>& problem = record_.problem;
  const Real scale = previous_dt_ > 0 ? substep_length() / static_cast<Real>(previous_dt_) : Real(1);
  problem.impulse.assign(problem.rows.size(), Real(0));
  record_.is_new.assign(problem.rows.size(), 1);
  ImpulseFinder<Real> last(impulses_);
  for (int i = 0; i < problem.row_count(); ++i) {
    const Real* impulse = last.find(problem.rows[i].key);
    if (!impulse) continue;
    record_.is_new[i] = 0;
    if (plan_->warm_start) problem.impulse[i] = scale * *impulse;
  }
}

/// Rows that have vanished are forgotten. What a step has added to an impulse made good for errors of the
/// velocities, which do not grow with dt as forces do. After a shorter step than the last one, only a share
/// of it is kept: as much as it will be again when it is scaled for a longer one.
template <Scalar Real>
void World<Real>::remember_impulses() {
  const Real share = previous_dt_ > 0 ? substep_length() / static_cast<Real>(previous_dt_) : Real(1);
  List<std::pair<RowKey, Real>> before;
  if (share < 1) before.swap(impulses_);
  impulses_.clear();
  for (int i = 0; i < record_.problem.row_count(); ++i) {
    impulses_.emplace_back(record_.problem.rows[i].key, record_.problem.impulse[i]);
  }
  ImpulseFinder<Real> last(before);
  for (auto& [key, impulse] : impulses_) {
    const Real* old = last.find(key);
    if (old) impulse = share * (*old + impulse - share * *old);
  }
  previous_dt_ = static_cast<double>(substep_length());
}

template <Scalar Real>
ContactMaterial<Real> World<Real>::material(BodyId a, BodyId b) const {
  const BodySpec& spec_a = scene_->bodies()[a].spec;
  const BodySpec& spec_b = scene_->bodies()[b].spec;
  return {.friction = static_cast<Real>(friction_root_[a] * friction_root_[b]),
          .restitution = static_cast<Real>(std::max(spec_a.restitution, spec_b.restitution)),
          .restitution_threshold = static_cast<Real>(scene_->settings().restitution_threshold),
          .friction_rows = scene_->settings().friction_rows,
          .slop_limit = std::min(slop_limit_[a], slop_limit_[b]),
          .gravity = static_cast<Real>(scene_->settings().gravity.norm())};
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
