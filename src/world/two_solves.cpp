// Floor 5. Once to go, and once to stay.
#include <cairn/world/two_solves.hpp>

#include <limits>

#include <cairn/constraints/contact_rows.hpp>

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

}  // namespace

/// Of all contacts and joints that are awake: of contacts, which only push, what is positive together.
template <Scalar Real>
const PerBody<Vec3<Real>>& TwoSolves<Real>::find_stiffness(const Parts& parts, ForcesOf when) {
  const StepRecord<Real>& record = parts.record;
  stiffness_.assign(parts.step.state.pose.size(), Vec3<Real>::Zero());
  parts.contacts.add_stiffness(when, record, forces_, stiffness_);
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

/// How many joints are apart.
template <Scalar Real>
int TwoSolves<Real>::write(const Parts& parts, ForcesOf when, bool with_rows) {
  begin(parts, when);
  StepRecord<Real>& record = parts.record;
  VelocityProblem<Real>& problem = record.problem;
  const int apart = write_rows(parts, StabilizationPass::velocity, with_rows, problem);
  problem.number.renew();
  const int rows = problem.rows_in(problem.blocks.size());
  problem.impulse.resize(rows);
  record.is_new.resize(rows);
  parts.joints.start(parts.step, problem, record.is_new);
  parts.contacts.start(parts.step, record);
  if (parts.step.plan.extras.impact_sequence)
    impacts_.begin(parts.step.state.velocity,
                   static_cast<Real>(*parts.step.plan.settings.restitution_threshold), problem, second_rows_);
  if (parts.step.plan.solves_again()) {
    first_velocity_ = problem.velocity;
    first_impulse_ = problem.impulse;
  }
  return apart;
}

/// Over the rows of the substep before, whose memory is used again.
template <Scalar Real>
int TwoSolves<Real>::write_rows(const Parts& parts, StabilizationPass pass, bool with_rows,
                                VelocityProblem<Real>& problem) {
  const Substep<Real>& step = parts.step;
  const SceneSettings& settings = step.plan.settings;
  const bool solves_again = step.plan.solves_again() && pass == StabilizationPass::velocity;
  List<SecondRow<Real>>* const second_rows = solves_again ? &second_rows_ : nullptr;
  second_rows_.clear();
  problem.blocks.clear();
  problem.extra_terms.clear();
  problem.rule = contact_rule(settings.stabilization, pass, step.dt, settings.gravity.norm());
  problem.friction_rows = settings.friction_rows;
  problem.is_second = false;
  if (step.plan.extras.surface_speed) step.kinds.copy_surface_speeds(problem.surface_speed);
  if (step.plan.extras.rolling_resistance) step.kinds.copy_rolling_resistances(problem.rolling_resistance);
  int next = 0;
  const int apart = parts.joints.write(step, pass, problem, next, second_rows);
  problem.rows.resize(next);
  const Real threshold = static_cast<Real>(*settings.restitution_threshold);
  if (step.plan.restitution || problem.rule.has_springs)
    for (Contact<Real>& contact : problem.contacts) meet(contact, step.state.velocity, threshold, problem);
  add_contact_blocks(problem, next);
  if (with_rows) write_contact_rows(problem, second_rows);
  return apart;
}

/// A substep whose forces ask for more mass than bodies took part with is solved again, with that mass.
template <Scalar Real>
const PerBody<Vec3<Real>>& TwoSolves<Real>::solve(const Parts& parts, Solver<Real>& solver,
                                                  SolveObserver<Real>* observer, StepReport& report) {
  const Plan& plan = parts.step.plan;
  VelocityProblem<Real>& problem = parts.record.problem;
  const bool with_rows = observer || !plan.contacts_without_rows() || !solver.takes_contacts();
  report.joints_apart = write(parts, ForcesOf::last_substep, with_rows);
  const int rows = problem.impulse.size();
  report.rows_solved += rows;
  report.solve = solver.solve(problem, observer);
  const auto asks_for_more = [&] {
    return asks_for_more_mass(find_stiffness(parts, ForcesOf::this_substep), problem);
  };
  for (int i = 0; i < most_masses && plan.follows_arcs && asks_for_more(); ++i) {
    report.count_left(report.solve, rows);
    write(parts, ForcesOf::this_substep, with_rows);
    report.solve = solver.solve(problem, observer);
  }
  report.count(report.solve, rows);
  going_ = problem.velocity;
  if (plan.second_solve == SecondSolve::positions) correct_positions(parts, solver, report);
  if (plan.solves_again()) solve_again(parts, solver, report);
  return going_;
}

/// The policies relaxed and soft: solves again from v_1, without what moves the positions, so that its speed
/// does not stay in the velocities.
template <Scalar Real>
void TwoSolves<Real>::solve_again(const Parts& parts, Solver<Real>& solver, StepReport& report) {
  VelocityProblem<Real>& problem = parts.record.problem;
  problem.velocity = first_velocity_;
  if (parts.step.plan.second_solve == SecondSolve::from_start) problem.impulse = first_impulse_;
  problem.is_second = true;
  for (int i = 0; i < problem.row_count(); ++i) {
    problem.rows[i].bias = second_rows_[i].bias;
    problem.rows[i].softness = second_rows_[i].softness;
  }
  report.count(solver.solve(problem), problem.impulse.size());
}

/// The policy split_impulse: adds velocities that take errors back, to go with.
template <Scalar Real>
void TwoSolves<Real>::correct_positions(const Parts& parts, Solver<Real>& solver, StepReport& report) {
  const VelocityProblem<Real>& problem = parts.record.problem;
  second_problem_.contacts = problem.contacts;
  second_problem_.velocity = problem.velocity;
  second_problem_.inverse_mass = problem.inverse_mass;
  second_problem_.dt = problem.dt;
  write_rows(parts, StabilizationPass::position, true, second_problem_);
  for (Vec3<Real>& v : second_problem_.velocity) v.setZero();
  second_problem_.impulse.assign(second_problem_.rows.size(), Real(0));
  report.count(solver.solve(second_problem_), second_problem_.row_count());
  report.rows_solved += second_problem_.row_count();
  for (const BodyId body : going_.indices()) going_[body] += second_problem_.velocity[body];
}

template class TwoSolves<float>;
template class TwoSolves<double>;

}  // namespace cairn
