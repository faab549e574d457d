// A box on feet as a problem by hand, and what theory says of it.
#include "lesson.hpp"

#include <numeric>

namespace cairn::everybody {

namespace {

double foot_at(int foot, int feet) { return -outermost + 2 * outermost * foot / (feet - 1.0); }

VelocityProblem<double> feet_problem(int feet) {
  VelocityProblem<double> problem;
  problem.dt = time_step;
  problem.inverse_mass = {{0, 0, 0}, {1 / box_mass, 1 / box_mass, 1}};  // the ground and the box
  problem.velocity = {{0, 0, 0}, {0, -gravity * time_step, 0}};
  for (int i = 0; i < feet; ++i) {
    ConstraintRow<double> row;
    row.a = ground;
    row.b = {1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, foot_at(i, feet)};
    row.bounds = Bounds<double>::unilateral();
    row.key = {.source = static_cast<std::uint64_t>(i)};
    problem.blocks.push_back({i, 1});
    problem.rows.push_back(row);
    problem.impulse.push_back(0);
  }
  return problem;
}

Snapshot picture_of(int feet) {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.62}, .mass = box_mass});
  for (int i = 0; i < feet; ++i) {
    scene.add(
        {.type = BodyType::static_body, .shapes = {box(0.03, 0.12)}, .position = {foot_at(i, feet), 0.06}});
  }
  return snapshot(scene);
}

}  // namespace

SweepRecorder<double> solved(Method method, double omega, int sweeps, VelocityProblem<double>& problem) {
  SweepRecorder<double> recorder;
  SolverSettings settings{.iterations = sweeps};
  if (method == Method::sequential) {
    SequentialImpulse<double>(settings).solve(problem, &recorder);
    return recorder;
  }
  if (method == Method::damped) settings.relaxation = omega;
  const Splitting splitting = method == Method::split ? Splitting::mass : Splitting::none;
  Jacobi<double>(settings, splitting).solve(problem, &recorder);
  return recorder;
}

FeetRun box_on_feet(const FeetSettings& settings) {
  FeetRun run{.settings = settings, .problem = feet_problem(settings.feet)};
  for (const ConstraintRow<double>& row : run.problem.rows) {
    run.share.push_back(1 / (box_mass * inverse_effective_mass(run.problem, row)));
  }
  run.answer = together(run.share);
  run.snapshot = picture_of(settings.feet);
  return run;
}

const FeetHistory& history_of(const FeetRun& run, Method method) {
  return run.histories[static_cast<int>(method)];
}

double together(const List<double>& lambda) { return std::accumulate(lambda.begin(), lambda.end(), 0.0); }

double taken_at_once(const FeetRun& run, Method method) {
  if (method == Method::damped) return run.settings.omega * run.answer;
  // All rows act on the box: splitting its mass in n parts divides what each gives by n.
  if (method == Method::split) return run.answer / run.settings.feet;
  return run.answer;
}

double speed_by_formula(const FeetRun& run, Method method, int sweep) {
  const double left = 1 - taken_at_once(run, method);
  const double falling = -gravity * time_step;
  if (std::abs(left) > 1) return falling * (sweep % 2 == 1 ? left : 1);
  return falling * std::pow(left, sweep);
}

}  // namespace cairn::everybody
