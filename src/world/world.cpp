// Floor 5. The step.
#include <cairn/world/world.hpp>
#include <cairn/math/deadline.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

/// Of the bodies as a substep of dt [s] would leave them, the first that can be moved: what solves lose, they
/// hand on to whatever immovable body the row holds.
template <Scalar Real>
std::optional<BodyId> first_not_finite(const BodyState<Real>& state, const PerBody<Vec3<Real>>& going,
                                       const PerBody<Vec3<Real>>& staying, Real dt) {
  std::optional<BodyId> first;
  for (const BodyId body : state.pose.indices()) {
    const Pose<Real>& pose = state.pose[body];
    const Vec3<Real>& v = going[body];
    const bool finite = std::isfinite(pose.position.x() + dt * v.x()) &&
                        std::isfinite(pose.position.y() + dt * v.y()) &&
                        std::isfinite(pose.angle + dt * v.z()) && staying[body].allFinite();
    if (finite) continue;
    if (state.inverse_mass[body].x() > 0) return body;
    if (!first) first = body;
  }
  return first;
}

/// Deeper than half of the thinner body.
template <Scalar Real>
bool is_too_deep(const Contact<Real>& contact, const BodyKinds<Real>& kinds) {
  // Each of the two is a quarter.
  const Real most = 2 * std::min(kinds[contact.a].failed_error, kinds[contact.b].failed_error);
  const auto& points = contact.manifold.points;
  return std::any_of(points.begin(), points.begin() + contact.manifold.count,
                     [most](const ManifoldPoint<Real>& point) { return point.separation < -most; });
}

/// Bodies on paths go where these lead, and what forces begin to act on wakes.
template <Scalar Real>
void follow(const Substep<Real>& step, BodyState<Real>& state) {
  if (!step.acting) return;
  step.acting->lead(step.when, state);
  if (step.sleep) step.acting->find_changes(step.when, [&](BodyId body) { step.sleep->wake(body); });
}

}  // namespace

/// Events are done to another world, which takes the place of this one once its step is done.
template <Scalar Real>
StepReport World<Real>::step(Solver<Real>& solver, const StepWatch<Real>& watch) {
  occupation_.refuse("World::step");
  if (watch.impulses != nullptr) watch.impulses->clear();
  std::optional<World> next = after_events();
  if (!next) return take_step(solver, watch);
  StepReport report;
  {
    const Occupation::Scope scope(occupation_, "World::step");
    report = next->take_step(solver, watch);
  }
  *this = std::move(*next);
  return report;
}

template <Scalar Real>
StepReport World<Real>::take_step(Solver<Real>& solver, const StepWatch<Real>& watch) {
  const Occupation::Scope scope(occupation_, "World::step");
  StepReport report;
  begin_step();
  try {
    for (int i = 0; i < model_.plan->settings.substeps && !report.not_finite; ++i)
      substep(i, solver, watch, report);
  } catch (...) {
    leave_step();
    throw;
  }
  report.awake.bodies = model_.plan->size.dynamic_bodies;
  if (sleep_) {
    if (!report.not_finite) sleep_->let_sleep(record_.problem.contacts, clock_.dt, state_);
    report.awake = sleep_->count();
  }
  clock_.time += clock_.dt;
  clock_.steps += 1;
  end_step();
  report.rows = record_.is_new.size();
  for (const Contact<Real>& contact : record_.problem.contacts) {
    report.contacts += contact.manifold.count;
    report.too_deep += is_too_deep(contact, *model_.kinds);
  }
  return report;
}

template <Scalar Real>
void World<Real>::substep(int number, Solver<Real>& solver, const StepWatch<Real>& watch,
                          StepReport& report) {
  Deadline::go_on();
  const Substep<Real> step = now(number);
  follow(step, state_);
  if (number == 0 || !step.plan.moves_manifolds) {
    contacts_.find(step, record_);  // 1, 2  poses -> pairs -> contacts
  } else {
    contacts_.move(step, record_);  //       or those of the step, where they are now
  }
  // 3     v_1 = v + dt M^-1 f: gravity is in before any constraint is solved
  // 4, 5  joints and contacts -> rows -> impulses, v_2
  const PerBody<Vec3<Real>>& going =
      solves_.solve({step, joints_, contacts_, record_}, solver, watch.solves, report);
  const PerBody<Vec3<Real>>& staying = record_.problem.velocity;
  report.not_finite = first_not_finite(state_, going, staying, step.dt);
  if (report.not_finite) return;  // nothing has moved, and the impulses remembered are those of before
  if (step.plan.watches()) watch_.see(step, record_);
  state_.velocity = going;
  integrate_positions(state_, step.dt);  // 6  with the new velocities: semi-implicit Euler
  state_.velocity = staying;
  joints_.remember(step, record_.problem);  // 7
  contacts_.remember(step.plan, record_);
  if (watch.impulses) watch.impulses->add(record_);
}

template <Scalar Real>
VelocityProblem<Real> World<Real>::velocity_problem() const {
  World twin = *this;
  do_events(twin);
  const Substep<Real> step = twin.now();
  follow(step, twin.state_);
  twin.contacts_.find(step, twin.record_);
  twin.solves_.write({step, twin.joints_, twin.contacts_, twin.record_});
  return twin.record_.problem;
}

template class World<float>;
template class World<double>;

}  // namespace cairn
