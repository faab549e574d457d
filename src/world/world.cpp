// Floor 5. The step.
#include "world/world.hpp"
#include "math/deadline.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <cmath>

namespace cairn {

/// Events are done to another world, which takes the place of this one once its step is done.
template <Scalar Real>
StepReport World<Real>::step(Solver<Real>& solver, SolveObserver<Real>* observer) {
  occupation_.refuse("World::step");
  std::optional<World> next = after_events();
  if (!next) return take_step(solver, observer);
  StepReport report;
  {
    const Occupation::Scope scope(occupation_, "World::step");
    report = next->take_step(solver, observer);
  }
  *this = std::move(*next);
  return report;
}

template <Scalar Real>
StepReport World<Real>::take_step(Solver<Real>& solver, SolveObserver<Real>* observer) {
  const Occupation::Scope scope(occupation_, "World::step");
  StepReport report;
  if (sleep_ && hand_) sleep_->wake(hand_->body());
  if (plan_->substeps > 1) first_pose_ = state_.pose, first_velocity_ = state_.velocity;
  try {
    for (int i = 0; i < plan_->substeps && !report.not_finite; ++i) substep(i, solver, observer, report);
  } catch (...) {
    leave_step();
    throw;
  }
  report.awake.bodies = plan_->dynamic_bodies;
  if (sleep_) {
    if (!report.not_finite) sleep_->let_sleep(record_.manifolds, dt_, state_);
    report.awake = sleep_->count();
  }
  time_ += dt_;
  steps_ += 1;
  report.rows = record_.is_new.size();
  for (const Manifold<Real>& manifold : record_.manifolds) report.contacts += manifold.count;
  count_failures(report);
  return report;
}

/// Of a step that is not done: bodies are where it began. What was found on the way is found again, and the
/// solver may have lost what it knows of contacts.
template <Scalar Real>
void World<Real>::leave_step() {
  if (plan_->substeps > 1) state_.pose = first_pose_, state_.velocity = first_velocity_;
  leave_contacts();
  touching_.clear();
  record_ = {};
  has_rows_ = true;
  written_.forget();
}

template <Scalar Real>
void World<Real>::substep(int number, Solver<Real>& solver, SolveObserver<Real>* observer,
                          StepReport& report) {
  Deadline::go_on();
  ContactSolver<Real>* const direct = observer == nullptr ? contact_solver(solver) : nullptr;
  if (number == 0 || !plan_->moves_manifolds) {
    find_contacts(direct);  // 1, 2  poses -> pairs -> manifolds
  } else if (!follow_contacts(direct)) {
    move_manifolds();  //       or those of the step, where they are now
  }
  apply_forces();  // 3     v_1 = v + dt M^-1 f: gravity is in before any constraint is solved
  if (direct != nullptr) {
    solve_contacts(*direct, report);  // 4, 5  manifolds -> impulses, v_2
  } else {
    solve_rows(solver, observer, report);  // 4, 5  joints and manifolds -> rows -> impulses, v_2
  }
  report.not_finite = first_not_finite();
  if (report.not_finite) {  // nothing has moved, and the impulses remembered are those of before
    if (direct != nullptr) take_back_contacts(*direct);
    return;
  }
  state_.velocity.swap(moving_velocity_);
  integrate_positions(state_, substep_length());  // 6  with the new velocities: semi-implicit Euler
  state_.velocity = record_.problem.velocity;
  if (direct != nullptr) {
    remember_contacts(*direct, number);  // 7
  } else {
    remember_impulses();  // 7
  }
}

template <Scalar Real>
void World<Real>::solve_rows(Solver<Real>& solver, SolveObserver<Real>* observer, StepReport& report) {
  has_rows_ = true;
  written_.forget();
  leave_contacts();
  write_rows(StabilizationPass::velocity, record_.problem);
  warm_start();  // with last step's impulses
  if (plan_->relaxes) {
    velocity_before_ = record_.problem.velocity;
    impulse_before_ = record_.problem.impulse;
  }
  report.solve = solver.solve(record_.problem, observer);
  report.count(report.solve);
  moving_velocity_ = record_.problem.velocity;
  if (plan_->corrects_positions) correct_positions(solver, report);
  if (plan_->relaxes) relax(solver, report);
}

/// The policies relaxed and soft: solves again from v_1, without what moves the positions, so that its speed
/// does not stay in the velocities.
template <Scalar Real>
void World<Real>::relax(Solver<Real>& solver, StepReport& report) {
  record_.problem.velocity = velocity_before_;
  if (plan_->second_start == SecondStart::of_first_start) record_.problem.impulse = impulse_before_;
  relax_rows();
  report.count(solver.solve_again(record_.problem));
}

/// The policy split_impulse: adds velocities that take errors back. The velocities of the step come back once
/// positions are integrated.
template <Scalar Real>
void World<Real>::correct_positions(Solver<Real>& solver, StepReport& report) {
  second_problem_.velocity = record_.problem.velocity;
  second_problem_.inverse_mass = record_.problem.inverse_mass;
  second_problem_.dt = record_.problem.dt;
  write_rows(StabilizationPass::position, second_problem_);
  for (Vec3<Real>& v : second_problem_.velocity) v.setZero();
  second_problem_.impulse.assign(second_problem_.rows.size(), Real(0));
  report.count(solver.solve(second_problem_));
  for (const BodyId body : moving_velocity_.indices())
    moving_velocity_[body] += second_problem_.velocity[body];
}

template <Scalar Real>
VelocityProblem<Real> World<Real>::velocity_problem() const {
  World twin = *this;
  twin.do_events();
  twin.find_contacts(nullptr);
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
    apply_gravity(record_.problem.velocity, state_.inverse_mass, kind_, forces_, gravity, dt);
  }
  if (plan_->damping) apply_damping(record_.problem.velocity, state_.inverse_mass, kind_, forces_, dt);
  if (sleep_) sleep_->hold(record_.problem.velocity);
  record_.problem.dt = dt;
  record_.problem.inverse_mass = state_.inverse_mass;
  if (plan_->follows_arcs) stiffen_bodies();
}

/// Bodies take part in the solve with the mass max(M, h^2 K) in each of their freedoms, and with the momentum
/// that they have: the implicit step for the forces of joints that turn with what they hold, of which K, the
/// geometric stiffness, is a bound. Where h^2 K <= M nothing changes. An explicit step is stable for
/// h^2 K <= 4 M at most.
template <Scalar Real>
void World<Real>::stiffen_bodies() {
  VelocityProblem<Real>& problem = record_.problem;
  find_stiffness();
  for (const BodyId body : stiffness_.indices()) {
    for (int k = 0; k < 3; ++k) {
      const Real share = problem.dt * problem.dt * stiffness_[body][k] * problem.inverse_mass[body][k];
      if (!(share > 1)) continue;
      problem.inverse_mass[body][k] /= share;
      problem.velocity[body][k] /= share;
    }
  }
}

/// Of all joints that are awake, under the forces of the last substep.
template <Scalar Real>
void World<Real>::find_stiffness() {
  stiffness_.assign(state_.pose.size(), Vec3<Real>::Zero());
  for (int i = 0; i < tie_count(); ++i) {
    const JointImpulses& before = joint_impulses_[i];
    if (tie_asleep(i) || before.count == 0) continue;
    forces_before_.rows.resize(before.count);
    for (int k = 0; k < before.count; ++k)
      forces_before_.rows[k] = {before.rows[k].part, before.rows[k].impulse / before.dt};
    const bool is_joint = i < scene_->joints().size();
    const Constraint& tie = is_joint ? *scene_->joints()[i] : *hand_;
    tie.add_stiffness(state_.pose, forces_before_, stiffness_);
  }
}

template class World<float>;
template class World<double>;
template class World<long double>;

}  // namespace cairn
