// Floor 9. Long steps, short steps, steps that change, and how often a step sweeps.
#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/check.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using Policy = StabilizationPolicy;

/// Boxes of 1 m whose centres are `spacing` [m] apart: less than 1 m is an overlap.
Scene spaced_stack(int boxes, double spacing, const Setting& setting = {}) {
  Scene scene = scene_for(setting);
  scene.add_ground({.half_width = 30});
  for (int i = 0; i < boxes; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i * spacing}});
  return scene;
}

/// 2.5 cm a box, as of any stack; or what slop and springs give way by, if that is more. Each of two points
/// bears half the weight of the boxes above it; there, 1 N s makes a box of 1 kg and 1 m faster by
/// 1 + 0.5^2 / (1 / 6) = 2.5 m/s.
double stack_limit(int boxes, const Setting& setting) {
  double sunk = 0;  // [m] of the highest box
  for (int above = 1; above <= boxes; ++above) {
    const double inverse_mass = above == boxes ? 2.5 : 5.0;  // [1/kg] of one box on the ground, or of two
    sunk +=
        setting.stabilization.slop.value_or(usual_slop) + spring_sag(setting, 10.0 * above / 2, inverse_mass);
  }
  return std::max(0.025 * boxes, sunk);
}

ExtremeRun stack_run(double seconds, const Setting& setting) {
  return {.seconds = seconds, .measure = farthest_place(), .limit = stack_limit(5, setting), .floor = 0};
}

/// The engine's own check, without anything of a study in front of it.
ExtremeFinding refuse_step(const Setting& setting) {
  World<double> world(spaced_stack(1, 1, setting));
  return {.quantity = "not refused"};
}

List<ExtremeCase> time_step_cases() {
  struct Step {
    std::string text;
    double dt;
    double seconds;
    ExtremeVerdict required;
  };
  const List<Step> steps = {
      {"1e-6", 1e-6, 2e-3, ExtremeVerdict::ok},     {"1e-4", 1e-4, 0.1, ExtremeVerdict::ok},
      {"1/1000", 1e-3, 1, ExtremeVerdict::ok},      {"1/240", 1.0 / 240, 3, ExtremeVerdict::ok},
      {"1/60", 1.0 / 60, 3, ExtremeVerdict::ok},    {"1/30", 1.0 / 30, 3, ExtremeVerdict::ok},
      {"1/20", 1.0 / 20, 3, ExtremeVerdict::bound}, {"1/10", 1.0 / 10, 3, ExtremeVerdict::bound},
      {"1", 1, 60, ExtremeVerdict::bound}};
  AxisCases cases("dt");
  for (const Step& step : steps) {
    for (ExtremeSetting tried : usual_settings()) {
      tried.setting.dt = step.dt;
      // Springs that swing but once in four steps of 1 s give way to a box by 4 m: nothing would hold it.
      const bool gives_way = spring_sag(tried.setting, 10, 1) > 0.5;
      cases.add(step.text, tried, gives_way ? ExtremeVerdict::refuse : step.required,
                [seconds = step.seconds](const Setting& setting) {
                  return run_extreme(spaced_stack(5, 1), setting, stack_run(seconds, setting));
                });
    }
  }
  for (const double dt : {0.0, -1.0, double(INFINITY), double(NAN)}) {
    Setting setting;
    setting.dt = dt;
    cases.add(shortest(dt), {setting, true}, ExtremeVerdict::refuse, refuse_step);
  }
  return cases.all();
}

/// An error must not become a speed that grows without end as dt goes to 0: bodies that overlap by 2 cm take
/// what is left of them apart, and nothing flies.
List<ExtremeCase> short_step_cases() {
  AxisCases cases("dt-overlap");
  for (const double dt : {1e-6, 1e-5, 1e-4, 1e-3}) {
    for (ExtremeSetting tried : usual_settings()) {
      tried.setting.dt = dt;
      cases.add(shortest(dt), tried, ExtremeVerdict::bound, [](const Setting& setting) {
        return run_extreme(spaced_stack(2, 0.98), setting,
                           stack_run(std::min(2000 * setting.dt, 0.5), setting));
      });
    }
  }
  return cases.all();
}

/// The fastest that a settled stack of ten goes up or down [m/s] while every step has the other of two
/// lengths: that is where the weights go that its impulses bear. How it sways within its slop does not count.
template <Scalar Real>
double fastest_of_changing_steps(const Setting& setting, double short_step, double long_step) {
  World<Real> world(spaced_stack(10, 1, setting));
  const auto solver = make_solver<Real>(setting.solver, setting.sweeps);
  double fastest = 0;
  for (int step = 0; step < 720; ++step) {
    if (step >= 600) world.set_dt(step % 2 == 0 ? short_step : long_step);
    if (world.step(*solver).not_finite) return INFINITY;
    if (step < 600) continue;
    for (const Vec3<Real>& velocity : world.bodies().velocity) {
      fastest = std::max(fastest, static_cast<double>(std::abs(velocity.y())));
    }
  }
  return fastest;
}

/// Impulses that were not scaled would leave g times the change of dt: 0.17 m/s for 60 and 30 Hz.
ExtremeFinding change_steps(double other, const Setting& setting) {
  const double fastest = in_scalar(setting.scalar, [&](auto real) {
    return fastest_of_changing_steps<decltype(real)>(setting, setting.dt, other);
  });
  return judged("fastest up or down (m/s)", fastest, 0.02, 10 * std::abs(setting.dt - other));
}

List<ExtremeCase> changing_step_cases() {
  struct Change {
    std::string text;
    double other;
  };
  AxisCases cases("dt-changes");
  for (const Change& change : {Change{"60 and 30 Hz", 1.0 / 30}, Change{"60 and 240 Hz", 1.0 / 240},
                               Change{"60 and 1000 Hz", 1e-3}}) {
    for (const ExtremeSetting& tried :
         {ExtremeSetting{setting_of("si", 30), true}, ExtremeSetting{setting_of("block-contact", 30), true},
          ExtremeSetting{setting_of("pgs-sparse", 30), false},
          ExtremeSetting{setting_of("accelerated", 30), false},
          ExtremeSetting{setting_of("si", 30, Policy::soft, 4), false},
          ExtremeSetting{setting_of("si", 100, Policy::split_impulse), false}}) {
      const bool twice = change.other > tried.setting.dt / 4.5;
      cases.add(change.text, tried, twice ? ExtremeVerdict::ok : ExtremeVerdict::bound,
                [other = change.other](const Setting& setting) { return change_steps(other, setting); });
    }
  }
  return cases.all();
}

/// Without sweeps nothing but gravity acts: after n steps of dt a body has fallen g dt^2 n (n + 1) / 2.
ExtremeFinding free_fall(const Setting& setting) {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .position = {0, 100}});
  const int steps = 60;
  const double fall = 10 * setting.dt * setting.dt * steps * (steps + 1) / 2;
  return run_extreme(scene, setting,
                     {.seconds = steps * setting.dt,
                      .measure = {"error of the fall (m)",
                                  [fall](const TrialResult& run) { return std::abs(run.farthest - fall); }},
                      .limit = 1e-12});
}

/// Seconds of one step over those that its solver may take: it must stop, and soon.
ExtremeFinding budgeted_step(const Setting& setting) {
  World<double> world(spaced_stack(20, 1, setting));
  const auto solver = make_solver<double>(setting.solver, setting.sweeps);
  world.step(*solver);
  const auto start = std::chrono::steady_clock::now();
  const StepReport report = world.step(*solver);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  ExtremeFinding finding = judged("time / budget", passed.count() / setting.sweeps.time_budget, 2, 100);
  if (report.solve.stop != Stop::time) {
    finding.verdict = ExtremeVerdict::fail;
    finding.note = "did not stop by its budget";
  }
  return finding;
}

/// Without a sweep there is no ground: to fall is right.
ExtremeFinding few_sweeps(const Setting& setting) {
  ExtremeRun run = stack_run(1, setting);
  if (setting.sweeps.iterations == 0) run.floor = -1e300, run.thinnest = 1e300;
  return run_extreme(spaced_stack(2, 1), setting, run);
}

List<ExtremeCase> iteration_cases() {
  AxisCases cases("iterations");
  for (const std::string solver : {"si", "block-contact", "pgs-sparse", "accelerated", "jacobi-split"}) {
    const bool quick = solver == "si" || solver == "accelerated";
    cases.add("0, in flight", {setting_of(solver, 0), quick}, ExtremeVerdict::ok, free_fall);
    for (const int sweeps : {0, 1}) {
      cases.add(fmt::format("{}, on the ground", sweeps), {setting_of(solver, sweeps), quick},
                ExtremeVerdict::bound, few_sweeps);
    }
    Setting many = setting_of(solver, 1000000);
    many.sweeps.time_budget = 0.01;
    cases.add("1e6 within 10 ms", {many, quick}, ExtremeVerdict::bound, budgeted_step);
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> step_axes() {
  const std::string usual = "si and block under every policy, block-contact, PGS, accelerated";
  return {{"dt", "a step of VALUE s, on a stack of 5", usual, time_step_cases},
          {"dt-overlap", "a step of VALUE s, on two boxes that begin 2 cm inside each other", usual,
           short_step_cases},
          {"dt-changes", "steps of two lengths in turn, on a settled stack of 10",
           "si under every policy, block-contact, PGS, accelerated: all start warm", changing_step_cases},
          {"iterations", "so many sweeps a step", "every family that sweeps", iteration_cases}};
}

}  // namespace cairn
