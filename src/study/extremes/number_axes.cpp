// Floor 9. What numbers do: precision, the smallest and the largest of them, and the same bits twice.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

Scene boxes_in_order(int boxes, int first) {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < boxes; ++i) {
    const int place = (first + i) % boxes;
    scene.add({.shapes = {box(1, 1)}, .position = {0.02 * place, 0.5 + place}});
  }
  return scene;
}

List<ExtremeCase> scalar_cases() {
  struct Kind {
    std::string text;
    Precision scalar;
  };
  AxisCases cases("scalar");
  for (const Kind& kind :
       {Kind{"float", Precision::single_precision}, Kind{"double", Precision::double_precision}}) {
    for (ExtremeSetting tried : usual_settings()) {
      tried.setting.scalar = kind.scalar;
      tried.setting.sweeps.iterations = std::max(20, tried.setting.sweeps.iterations);
      cases.add(kind.text, tried, ExtremeVerdict::ok, [](const Setting& setting) {
        return run_extreme(boxes_in_order(5, 0), setting,
                           {.measure = farthest_place(), .limit = 0.125, .floor = 0});
      });
    }
  }
  return cases.all();
}

/// Twenty balls on pins, in no gravity, all moving at `speed`: seconds of processor time for 300 steps.
double seconds_at(double speed, const Setting& setting) {
  Scene scene = scene_for(setting, {.gravity = {0, 0}});
  for (int i = 0; i < 20; ++i) {
    const double x = 3.0 * i;
    const BodyId ball = scene.add(
        {.shapes = {circle(0.5)}, .position = {x, 0}, .velocity = {0, speed}, .damping = {.angular = 1}});
    scene.join<RevoluteJoint>({.a = ground, .b = ball, .anchor = {x - 1, 0}});
  }
  World<double> world(scene);
  const auto solver = make_solver<double>(setting.solver, setting.sweeps);
  const double start = thread_cpu_seconds();
  for (int step = 0; step < 300; ++step) world.step(*solver);
  return thread_cpu_seconds() - start;
}

/// The least of a few runs each, in turns: what else the machine does makes times longer, never shorter.
ExtremeFinding slow_down(double speed, const Setting& setting) {
  double usual = INFINITY, tiny = INFINITY;
  for (int i = 0; i < 15; ++i) {
    usual = std::min(usual, seconds_at(1, setting));
    tiny = std::min(tiny, seconds_at(speed, setting));
  }
  return judged("time / time of usual numbers", tiny / usual, 2, 1000);
}

List<ExtremeCase> denormal_cases() {
  AxisCases cases("denormals");
  for (const double speed : {1e-300, 1e-310, 1e-320}) {
    cases.add_usual(fmt::format("v {:g} m/s", speed), ExtremeVerdict::ok,
                    [speed](const Setting& setting) { return slow_down(speed, setting); });
  }
  return cases.all();
}

/// A body that is thrown out of the numbers: the step that would do it must not be done, and name the body.
template <Scalar Real>
ExtremeFinding overflow(double speed, const Setting& setting) {
  Scene scene = scene_for(setting);
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  const BodyId runaway = scene.add({.position = {0, 50}, .mass = 1, .fixed_rotation = true});
  scene.join<RevoluteJoint>({.a = BodyId{1}, .b = runaway, .anchor = {0, 25}});
  World<Real> world(scene);
  const auto solver = make_solver<Real>(setting.solver, setting.sweeps);
  world.step(*solver);
  world.set_velocity(runaway, {0, speed, 0});
  int stopped = 0;
  for (int step = 0; step < 20; ++step) stopped += world.step(*solver).not_finite.has_value();
  bool finite = true;
  for (const Pose<Real>& pose : world.bodies().pose) finite = finite && pose.position.allFinite();
  ExtremeFinding finding = judged("steps not done", stopped, 0, 20);
  if (!finite) finding = {.quantity = "steps not done", .note = "a body is nowhere"};
  return finding;
}

List<ExtremeCase> overflow_cases() {
  AxisCases cases("overflow");
  for (const double speed : {1e30, 1e37, 1e150, 1e200, 1e307}) {
    for (ExtremeSetting tried : usual_settings()) {
      if (speed < 1e38) tried.setting.scalar = Precision::single_precision;
      cases.add(fmt::format("{:g} m/s in {}", speed, speed < 1e38 ? "float" : "double"), tried,
                ExtremeVerdict::bound, [speed](const Setting& setting) {
                  return in_scalar(setting.scalar,
                                   [&](auto real) { return overflow<decltype(real)>(speed, setting); });
                });
    }
  }
  return cases.all();
}

TrialResult stack_result(int first, const Setting& setting) {
  return run_trial(boxes_in_order(5, first), setting, {.seconds = 2});
}

List<ExtremeCase> determinism_cases() {
  AxisCases cases("determinism");
  for (const ExtremeSetting& tried : usual_settings()) {
    cases.add("the same scene twice", tried, ExtremeVerdict::ok, [](const Setting& setting) {
      const bool same = stack_result(0, setting).state_hash == stack_result(0, setting).state_hash;
      return judged("runs that differ", same ? 0 : 1, 0, 0);
    });
    cases.add("bodies added in another order", tried, ExtremeVerdict::bound, [](const Setting& setting) {
      const double gap = std::abs(stack_result(0, setting).farthest - stack_result(3, setting).farthest);
      return judged("farthest differs by (m)", gap, 0.005, 0.1);
    });
  }
  return cases.all();
}

}  // namespace

List<ExtremeAxis> number_axes() {
  const std::string usual = "si and block under every policy, block-contact, PGS, accelerated";
  return {{"scalar", "what the engine computes in, on a leaning stack of 5", usual, scalar_cases},
          {"denormals", "numbers too small for all their digits, in double", usual, denormal_cases},
          {"overflow", "a body thrown so fast that numbers end", usual, overflow_cases},
          {"determinism", "the same again", usual, determinism_cases}};
}

}  // namespace cairn
