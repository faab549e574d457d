// Floor 5. Once to go, and once to stay.
#include "world/two_solves.hpp"

#include <limits>

namespace cairn {

namespace {

// h^2 K / M up to which a step from rest ends no farther from its balance than it began: 1 - h^2 K / M times
// as far. From twice as much on, an explicit step is unstable.
constexpr int overshooting = 2;
// That a substep is solved with: a jerk mostly takes two or three.
constexpr int most_masses = 8;

/// Bodies take part in the solve with the mass max(M, h^2 K) in each of their freedoms, and with the momentum
/// that they have: the implicit step for forces that turn with what they hold, of which K is the geometric
/// stiffness. Where h^2 K <= M nothing changes.
template <Scalar Real>
void stiffen(const PerBody<Vec3<Real>>& stiffness, VelocityProblem<Real>& problem) {
  for (const BodyId body : stiffness.indices()) {
    for (int k = 0; k < 3; ++k) {
      const Real share = problem.dt * problem.dt * stiffness[body][k] * problem.inverse_mass[body][k];
      if (!(share > 1)) continue;
      problem.inverse_mass[body][k] /= share;
      problem.velocity[body][k] /= share;
    }
  }
}

/// Whether forces are too much for the mass that a body took part with. That mass is for those of the substep
/// before: where a rope gets tight or a fall ends, they are others.
template <Scalar Real>
bool asks_for_more_mass(const PerBody<Vec3<Real>>& stiffness, const VelocityProblem<Real>& problem) {
  for (const BodyId body : stiffness.indices()) {
    const Vec3<Real> shares = stiffness[body].cwiseProduct(problem.inverse_mass[body]);
    if (problem.dt * problem.dt * shares.maxCoeff() > overshooting) return true;
  }
  return false;
}

/// For the second solve: without what takes errors back.
template <Scalar Real>
void relax_rows(const List<RelaxedRow<Real>>& relaxed, VelocityProblem<Real>& problem) {
  for (int i = 0; i < problem.row_count(); ++i) {
    problem.rows[i].bias = relaxed[i].bias;
    problem.rows[i].softness = relaxed[i].softness;
  }
}

}  // namespace

/// Of all contacts and joints that are awake: of contacts, which only push, what is positive together.
template <Scalar Real>
const PerBody<Vec3<Real>>& TwoSolves<Real>::find_stiffness(const Parts& parts, ForcesOf when) {
  const StepRecord<Real>& record = parts.record;
  stiffness_.assign(parts.step.state.pose.size(), Vec3<Real>::Zero());
  parts.contacts.add_stiffness(parts.step, when, record, forces_, stiffness_);
  for (Vec3<Real>& stiffness : stiffness_) stiffness = stiffness.cwiseMax(Real(0));
  parts.joints.add_stiffness(parts.step, when, record.problem, forces_, stiffness_);
  return stiffness_;
}

/// v_1 = v + dt M^-1 f, and masses. What has no energy that a normal number could hold rests: processors take
/// many times as long over the others.
template <Scalar Real>
void TwoSolves<Real>::begin(const Parts& parts, ForcesOf when) {
  VelocityProblem<Real>& problem = parts.record.problem;
  problem.velocity = parts.step.state.velocity;
  for (Vec3<Real>& v : problem.velocity)
    if (v.squaredNorm() < std::numeric_limits<Real>::min()) v.setZero();
  parts.step.add_forces(problem.velocity, parts.step.dt);
  problem.dt = parts.step.dt;
  problem.inverse_mass = parts.step.state.inverse_mass;
  if (parts.step.plan.follows_arcs) stiffen(find_stiffness(parts, when), problem);
}

template <Scalar Real>
int TwoSolves<Real>::write(const Parts& parts) {
  return write(parts, ForcesOf::last_substep);
}

template <Scalar Real>
int TwoSolves<Real>::write(const Parts& parts, ForcesOf when) {
  begin(parts, when);
  StepRecord<Real>& record = parts.record;
  VelocityProblem<Real>& problem = record.problem;
  record.has_rows = true;
  record.contacts.clear();
  const int apart = write_rows(parts, StabilizationPass::velocity, problem);
  problem.impulse.resize(problem.rows.size());
  record.is_new.resize(problem.rows.size());
  parts.joints.start(parts.step, problem, record.is_new);
  parts.contacts.start(parts.step, record.first_contact_block, problem, record.is_new);
  if (parts.step.plan.relaxes) {
    first_velocity_ = problem.velocity;
    first_impulse_ = problem.impulse;
  }
  return apart;
}

/// Over the rows of the substep before, whose memory is used again.
template <Scalar Real>
int TwoSolves<Real>::write_rows(const Parts& parts, StabilizationPass pass, VelocityProblem<Real>& problem) {
  const bool solves_again = parts.step.plan.relaxes && pass == StabilizationPass::velocity;
  List<RelaxedRow<Real>>* const relaxed = solves_again ? &relaxed_rows_ : nullptr;
  relaxed_rows_.clear();
  problem.blocks.clear();
  problem.extra_terms.clear();
  int next = 0;
  const int apart = parts.joints.write(parts.step, pass, problem, next, relaxed);
  parts.record.first_contact_block = problem.blocks.size();
  parts.contacts.write(parts.step, parts.record.manifolds, pass, problem, next, relaxed);
  problem.rows.resize(next);
  return apart;
}

template <Scalar Real>
const PerBody<Vec3<Real>>& TwoSolves<Real>::solve(const Parts& parts, Solver<Real>& solver,
                                                  SolveObserver<Real>* observer, StepReport& report) {
  const bool may_take = parts.step.plan.contacts_without_rows && observer == nullptr;
  if (ContactSolver<Real>* const direct = may_take ? solver.for_contacts() : nullptr) {
    solve_contacts(parts, *direct, report);
  } else {
    solve_rows(parts, solver, observer, report);
  }
  return going_;
}

/// A substep whose forces ask for more mass than bodies took part with is solved again, with that mass.
template <Scalar Real>
void TwoSolves<Real>::solve_rows(const Parts& parts, Solver<Real>& solver, SolveObserver<Real>* observer,
                                 StepReport& report) {
  const VelocityProblem<Real>& problem = parts.record.problem;
  report.joints_apart = write(parts);
  report.rows_solved += problem.row_count();
  report.solve = solver.solve(parts.record.problem, observer);
  const auto asks_for_more = [&] {
    return asks_for_more_mass(find_stiffness(parts, ForcesOf::this_substep), problem);
  };
  for (int i = 0; i < most_masses && parts.step.plan.follows_arcs && asks_for_more(); ++i) {
    report.count_left(report.solve, problem.row_count());
    write(parts, ForcesOf::this_substep);
    report.solve = solver.solve(parts.record.problem, observer);
  }
  report.count(report.solve, problem.row_count());
  going_ = problem.velocity;
  if (parts.step.plan.corrects_positions) correct_positions(parts, solver, report);
  if (parts.step.plan.relaxes) relax(parts, solver, report);
}

/// The policies relaxed and soft: solves again from v_1, without what moves the positions, so that its speed
/// does not stay in the velocities.
template <Scalar Real>
void TwoSolves<Real>::relax(const Parts& parts, Solver<Real>& solver, StepReport& report) {
  VelocityProblem<Real>& problem = parts.record.problem;
  problem.velocity = first_velocity_;
  if (parts.step.plan.second_start == SecondStart::of_first_start) problem.impulse = first_impulse_;
  relax_rows(relaxed_rows_, problem);
  report.count(solver.solve_again(problem), problem.row_count());
}

/// The policy split_impulse: adds velocities that take errors back, to go with.
template <Scalar Real>
void TwoSolves<Real>::correct_positions(const Parts& parts, Solver<Real>& solver, StepReport& report) {
  const VelocityProblem<Real>& problem = parts.record.problem;
  second_problem_.velocity = problem.velocity;
  second_problem_.inverse_mass = problem.inverse_mass;
  second_problem_.dt = problem.dt;
  write_rows(parts, StabilizationPass::position, second_problem_);
  for (Vec3<Real>& v : second_problem_.velocity) v.setZero();
  second_problem_.impulse.assign(second_problem_.rows.size(), Real(0));
  report.count(solver.solve(second_problem_), second_problem_.row_count());
  report.rows_solved += second_problem_.row_count();
  for (const BodyId body : going_.indices()) going_[body] += second_problem_.velocity[body];
}

/// The problem with rows of joints, and of those contacts that need them.
template <Scalar Real>
int TwoSolves<Real>::take(const Parts& parts, ForcesOf when) {
  begin(parts, when);
  StepRecord<Real>& record = parts.record;
  VelocityProblem<Real>& problem = record.problem;
  List<RelaxedRow<Real>>* const relaxed = parts.step.plan.relaxes ? &relaxed_rows_ : nullptr;
  record.has_rows = false;
  record.pose_before = parts.step.state.pose;
  record.velocity_before = parts.step.state.velocity;
  record.free_velocity = problem.velocity;
  relaxed_rows_.clear();
  problem.blocks.clear();
  problem.extra_terms.clear();
  int next = 0;
  const int apart = parts.joints.write(parts.step, StabilizationPass::velocity, problem, next, relaxed);
  record.first_contact_block = problem.blocks.size();
  problem.impulse.resize(next);
  record.is_new.resize(next);
  parts.joints.start(parts.step, problem, record.is_new);
  parts.contacts.take(parts.step, record, next, relaxed);
  first_impulse_ = problem.impulse;
  return apart;
}

template <Scalar Real>
void TwoSolves<Real>::solve_contacts(const Parts& parts, ContactSolver<Real>& solver, StepReport& report) {
  StepRecord<Real>& record = parts.record;
  VelocityProblem<Real>& problem = record.problem;
  const Plan& plan = parts.step.plan;
  ContactProblem<Real> contacts = {
      .poses = &record.pose_before,
      .rule = contact_rule(plan.settings.stabilization, StabilizationPass::velocity, parts.step.dt,
                           plan.settings.gravity.norm()),
      .problem = &problem,
      .second_start = plan.second_start};
  const auto take_and_solve = [&](ForcesOf when) {
    report.joints_apart = take(parts, when);
    contacts.contacts = record.contacts;
    contacts.manifolds = record.manifolds;
    contacts.joints = record.first_contact_block;
    contacts.rows = problem.row_count();
    report.solve = solver.solve(contacts);
    solver.give(contacts);
  };
  const auto asks_for_more = [&] {
    return asks_for_more_mass(find_stiffness(parts, ForcesOf::this_substep), problem);
  };
  take_and_solve(ForcesOf::last_substep);
  const int rows = record.is_new.size();
  report.rows_solved += rows;
  for (int i = 0; i < most_masses && plan.follows_arcs && asks_for_more(); ++i) {
    report.count_left(report.solve, rows);
    take_and_solve(ForcesOf::this_substep);
  }
  report.count(report.solve, rows);
  going_ = problem.velocity;
  if (!plan.relaxes) return;
  problem.velocity = record.free_velocity;
  for (int i = 0; i < contacts.rows; ++i) {
    problem.rows[i].bias = relaxed_rows_[i].bias;
    problem.rows[i].softness = relaxed_rows_[i].softness;
    if (plan.second_start == SecondStart::of_first_start) problem.impulse[i] = first_impulse_[i];
  }
  report.count(solver.relax(contacts), rows);
  solver.give(contacts);
}

template class TwoSolves<float>;
template class TwoSolves<double>;
template class TwoSolves<long double>;

}  // namespace cairn
