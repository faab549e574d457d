// The two boxes as rows and as a scene, and what theory says of them.
#include "ratio.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cairn::edges {

VelocityProblem<double> two_boxes(double ratio) {
  VelocityProblem<double> problem;
  problem.dt = time_step;
  problem.inverse_mass = {{0, 0, 0}, {1, 1, 0}, {1 / ratio, 1 / ratio, 0}};
  problem.velocity = {{0, 0, 0}, {0, -gravity * time_step, 0}, {0, -gravity * time_step, 0}};
  for (int i = 0; i < 2; ++i) {
    ConstraintRow<double> row;
    row.a = {i};
    row.b = {i + 1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, 0};
    row.bounds = Bounds<double>::unilateral();
    row.key = {.source = static_cast<std::uint64_t>(i)};
    problem.rows.push_back(row);
    problem.blocks.push_back({i, 1});
    problem.impulse.push_back(0);
  }
  return problem;
}

Scene two_boxes_scene(double ratio) {
  Scene scene({.gravity = {0, -gravity}, .dt = time_step});
  scene.add_ground();
  for (int i = 0; i < 2; ++i) {
    scene.add({.shapes = {box(1, 1)},
               .position = {0, 0.5 + i},
               .mass = i == 0 ? 1 : ratio,
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
  for (std::size_t k = 1; k < run.load.size(); ++k) {
    const double formula = std::pow(rate_by_formula(run.ratio), static_cast<double>(k));
    const double above = 1 - run.load[k][1] / (run.ratio * gravity);
    gap = std::max({gap, std::abs(run.error[k] - formula), std::abs(above - formula)});
  }
  return gap;
}

const RatioRun& run_of(const std::vector<RatioRun>& runs, double ratio) {
  for (const RatioRun& run : runs) {
    if (run.ratio == ratio) return run;
  }
  throw std::out_of_range("run_of: no run with this ratio");
}

}  // namespace cairn::edges
