// Lesson 14. Pulley: a row may touch as many bodies as it likes.
//
// A rope over wheels holds as many bodies as hang on it. Its row of J has a block for each of them, and both
// j v and j M^-1 j^T are sums over these blocks: that is all that changes. The joint is this lesson's own and
// stands in rope.hpp; here it is put into a scene, its equation (22) is worked out by hand, and seven solvers
// that know nothing of it find the same lambda.
#include "lesson.hpp"

#include "rope.hpp"

namespace cairn::pulley {

Scene pulley_scene(const PulleySettings& settings) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const FixedList<double, 3> x = {-3 * wheel_radius, 0, 3 * wheel_radius};
  const FixedList<double, 3> y = {2, 2, 4};
  FixedList<RopeOverWheels::End, 3> ends;
  double length = 0;
  for (int i = 0; i < 3; ++i) {
    const BodyId body =
        scene.add({.shapes = {box(0.6, 0.6)}, .position = {x[i], y[i]}, .mass = settings.masses[i]});
    ends[i] = {.body = body, .parts = parts[i], .top = wheel_height};
    length += parts[i] * (wheel_height - y[i]);
  }
  scene.join(std::make_shared<const RopeOverWheels>(ends, length));
  return scene;
}

double tension_by_hand(const PulleySettings& settings) {
  // [lambda]
  double jv = 0;       // [m/s] after one step of falling
  double inverse = 0;  // [1/kg] j M^-1 j^T
  for (int i = 0; i < 3; ++i) {
    const double r = parts[i];  // of the rope at body i: its block of j is (0, r, 0)
    jv += r * (-gravity * settings.dt);
    inverse += r * r / settings.masses[i];
  }
  const double lambda = (0 - jv) / (inverse * settings.dt);  // (22), zeta = 0
  // [/lambda]
  return lambda;
}

PulleyRun run_one(const PulleySettings& settings, Solver<double>& solver) {
  World<double> world(pulley_scene(settings));
  PulleyRun run{.solver = solver.name(), .steps = {look(world)}};
  for (int step = 1; step <= settings.steps; ++step) {
    world.step(solver);
    run.steps.push_back(look(world));
    if (step == settings.lift_step && settings.lift > 0) world.set_velocity({3}, {0, settings.lift, 0});
  }
  return run;
}

int right_solvers(const PulleyRuns& all) {
  const double tension = tension_by_hand(all.settings);
  return static_cast<int>(std::ranges::count_if(all.runs, [tension](const PulleyRun& run) {
    return std::abs(run.steps[1].tension - tension) <= 1e-9 * tension;
  }));
}

PulleyRuns run_pulleys(const PulleySettings& settings) {
  PulleyRuns all{.settings = settings, .first = World<double>(pulley_scene(settings)).velocity_problem()};
  const SolverSettings one_sweep = {.iterations = 1};
  const std::unique_ptr<Solver<double>> solvers[] = {
      std::make_unique<SequentialImpulse<double>>(one_sweep),
      std::make_unique<ProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<SparseProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<FactoredProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<NaiveProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<AcceleratedProjectedGaussSeidel<double>>(one_sweep),
      std::make_unique<Jacobi<double>>(one_sweep, Splitting::mass)};
  for (const std::unique_ptr<Solver<double>>& solver : solvers)
    all.runs.push_back(run_one(settings, *solver));
  end_at_wheels(all);
  return all;
}

namespace {

void run(Lesson& lesson) {
  const PulleySettings settings = settings_of(lesson);
  const PulleyRuns all = run_pulleys(settings);
  print_scene(lesson, all.settings);
  lesson.predict();
  print_runs(lesson, all);
  CountedCalls calls = count_calls(settings);
  time_calls(calls);
  print_calls(lesson, calls);
  const ObjectSweeps objects = sweep_objects(settings);
  print_objects(lesson, objects);
  lesson.answer(
      {tension_by_hand(settings)}, 0.02 * tension_by_hand(settings),
      fmt::format("j·v and j M⁻¹ jᵀ have a third term, and nothing else changes: {} solvers find that in one "
                  "sweep. A mass goes down where the rope pulls with less than its weight: {}.",
                  right_solvers(all), what_goes_down(settings)));
  check_runs(lesson, all);
  check_calls(lesson, calls);
  check_objects(lesson, objects);
  lesson.film(pulley_shots(all));
  lesson.data(steps_table(all));
  lesson.fingerprint(all.runs[0].steps.back().snapshot);
}

}  // namespace
}  // namespace cairn::pulley

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::pulley::run, argc, argv); }
