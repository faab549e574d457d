// What is done with the rod, and other accounts of it.
#include "lesson.hpp"

namespace cairn::sweeps {

namespace {

VelocityProblem<double> without_bounds(VelocityProblem<double> problem) {
  for (ConstraintRow<double>& row : problem.rows) row.bounds = Bounds<double>::equality();
  return problem;
}

/// The rod on two wedges, and half a second of what it does: for pictures.
void move_rod(const SweepSettings& settings, RodRun& run) {
  Scene scene(
      {.gravity = {0, -gravity}, .dt = 0.01, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground({.height = -0.6});
  // A little inside the end of the rod: two corners that meet have no normal.
  for (const double x : {0.02, settings.support}) {
    scene.add({.type = BodyType::static_body,
               .shapes = {polygon({{x - 0.16, -0.6}, {x + 0.16, -0.6}, {x, 0}})},
               .material = {.friction = 1}});
  }
  scene.add({.shapes = {box(rod_length, 0.1)},
             .position = {rod_length / 2, 0.05},
             .mass = rod_mass,
             .inertia = rod_inertia,
             .material = {.friction = 1}});
  World world(scene);
  SequentialImpulse solver({.iterations = 100});
  run.snapshot = snapshot(world);
  run.motion.push_back(run.snapshot);
  for (int step = 1; step <= 50; ++step) {
    world.step(solver);
    if (step % 10 == 0) run.motion.push_back(snapshot(world));
  }
}

RodRun run_rod(const SweepSettings& settings) {
  const VelocityProblem<double> problem = rod_problem(settings);
  RodRun run{.system = system_matrices(problem)};
  const Matrix<double>& A = run.system.A;
  run.rate = A(0, 1) * A(0, 1) / (A(0, 0) * A(1, 1));
  run.bounded = swept(problem, settings.sweeps);
  // Until rounding: the error begins at no more than 1000 N, and 1e-17 of that is below every digit.
  const int enough = run.rate > 0 ? 3 + static_cast<int>(std::ceil(std::log(1e-17) / std::log(run.rate))) : 3;
  run.unbounded = swept(without_bounds(problem), std::max(enough, settings.sweeps));
  run.settled = swept(problem, enough);
  for (int i = 0; i < 2; ++i) {
    run.arm[i] = problem.rows[i].jacobian_b.z();
    const PerRow<double>& lambda = run.settled.after.back();
    run.leaving[i] = A(i, 0) * lambda[0] + A(i, 1) * lambda[1] - run.system.b(i);
  }
  // Forces and moments about the left end balance.
  const double weight = rod_mass * gravity;
  run.statics[1] = weight * rod_length / 2 / settings.support;
  run.statics[0] = weight - run.statics[1];
  // A rod that tips is held at one point only, by what stops that point: b_2 / A_22 (22).
  const double arm = settings.support - rod_length / 2;
  run.formula = run.statics;
  if (run.tips()) run.formula = {0, gravity / (1 / rod_mass + arm * arm / rod_inertia)};
  move_rod(settings, run);
  return run;
}

}  // namespace

Swept recorded(const SweepRecorder<double>& recorder, double dt) {
  Swept result;
  PerRow<double> lambda(recorder.sweeps().at(0).impulse.size(), 0.0);
  for (const RowRecord& record : recorder.rows()) {
    lambda[record.update.row] = record.update.impulse_after / dt;
    result.updates.push_back(record.update);
    result.after.push_back(lambda);
  }
  for (const SweepRecord& record : recorder.sweeps()) {
    result.by_sweep.push_back(record.impulse);
    for (double& value : result.by_sweep.back()) value /= dt;
  }
  return result;
}

SweepRun run_sweeps(const SweepSettings& settings) {
  return {.settings = settings, .rod = run_rod(settings)};
}

List<Interval> kinds_of_rows() {
  // The normal row of the friction has given 10 N s, and mu is 0.6.
  return {
      {"contact, rope", "a contact only pushes, a rope only pulls", "0", "∞", Bounds<double>::unilateral()},
      {"rod, pin, weld", "holds in both directions", "−∞", "∞", Bounds<double>::equality()},
      {"motor", "up to its strength, in both directions", "−F Δt", "F Δt", Bounds<double>::at_most(6)},
      {"friction", "up to μ times the normal impulse", "−μ λ_{n} Δt", "μ λ_{n} Δt",
       Bounds<double>::coulomb(0.6, 0)}};
}

}  // namespace cairn::sweeps
