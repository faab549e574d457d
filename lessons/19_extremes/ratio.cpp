// The two boxes as rows and as a scene, and what theory says of them.
#include "lesson.hpp"

#include <cairn/validation/column.hpp>

namespace cairn::edges {

List<double> masses_of(double ratio) { return {std::max(1.0, 1 / ratio), std::max(1.0, ratio)}; }

double weight_of(double ratio) { return (masses_of(ratio)[0] + masses_of(ratio)[1]) * gravity; }

VelocityProblem<double> two_boxes(double ratio) {
  return cases::column<double>(masses_of(ratio), gravity, time_step);
}

Scene two_boxes_scene(double ratio) {
  Scene scene({.gravity = {0, -gravity},
               .dt = time_step,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  for (int i = 0; i < 2; ++i) {
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.5 + i},
               .mass = masses_of(ratio)[i],
               .fixed_rotation = true});
  }
  return scene;
}

double rate_by_formula(double ratio) { return ratio / (1 + ratio); }

int sweeps_by_formula(double ratio, double share) {
  return static_cast<int>(std::ceil(std::log(share) / std::log(rate_by_formula(ratio))));
}

double gap_to_formula(const RatioRun& run) {
  double gap = 0;
  for (int k = 1; k < run.load.size(); ++k) {
    const double formula = std::pow(rate_by_formula(run.ratio), k);
    const double above = 1 - run.load[k][1] / (masses_of(run.ratio)[1] * gravity);
    gap = std::max({gap, std::abs(run.error[k] - formula), std::abs(above - formula)});
  }
  return gap;
}

double worst(const List<double>& by_step, int step) {
  return *std::max_element(by_step.begin(), by_step.begin() + step + 1);
}

bool is_ok(const StackCourse& course, int step) {
  return worst(course.off_by_step, step) <= 0.01 && worst(course.energy_by_step, step) <= 0.01;
}

std::string verdict(bool is_good) { return is_good ? "OK" : "BROKEN"; }

const RatioRun& run_of(const List<RatioRun>& runs, double ratio) {
  for (const RatioRun& run : runs) {
    if (run.ratio == ratio) return run;
  }
  throw std::out_of_range("run_of: no run with this ratio");
}

}  // namespace cairn::edges
