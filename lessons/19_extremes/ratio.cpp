// Gauss-Seidel on two rows, watched.
#include "ratio.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace cairn::edges {

namespace {

/// Keeps what a lesson needs of every sweep, and computes nothing beside it: some runs have thousands.
class LoadRecorder final : public SolveObserver<double> {
 public:
  explicit LoadRecorder(RatioRun& run) : run_(run) {}
  bool watches_rows() const override { return true; }
  void after_row(const RowUpdate<double>& update, const VelocityProblem<double>&) override {
    jv_.push_back(update.row_velocity);
  }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    run_.load.push_back({problem.impulse[0] / problem.dt, problem.impulse[1] / problem.dt});
    run_.speed_jv.push_back(jv_);
    jv_.clear();
  }

 private:
  RatioRun& run_;
  std::vector<double> jv_;
};

}  // namespace

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

RatioRun run_ratio(double ratio, int sweeps) {
  RatioRun run{.ratio = ratio, .load = {{0, 0}}, .error = {1}, .speed_jv = {{0, 0}}};
  VelocityProblem<double> problem = two_boxes(ratio);
  LoadRecorder recorder(run);
  SequentialImpulse<double>({.iterations = std::max(sweeps, sweeps_by_formula(ratio) + 1)})
      .solve(problem, &recorder);
  const double exact = (1 + ratio) * gravity;
  for (std::size_t k = 1; k < run.load.size(); ++k) {
    run.error.push_back(1 - run.load[k][0] / exact);
    const double formula = std::pow(rate_by_formula(ratio), static_cast<double>(k));
    const double above = 1 - run.load[k][1] / (ratio * gravity);
    run.largest_gap =
        std::max({run.largest_gap, std::abs(run.error[k] - formula), std::abs(above - formula)});
    if (run.counted == 0 && run.error[k] <= goal) run.counted = static_cast<int>(k);
  }
  return run;
}

std::vector<RatioRun> run_ratios(double ratio, int sweeps) {
  std::set<double> ratios = {0.001, 0.01, 0.1, 1, 10, 100, 1000, 10000};
  ratios.insert(ratio);
  ratios.insert(1 / ratio);
  std::vector<RatioRun> runs;
  for (const double each : ratios) runs.push_back(run_ratio(each, sweeps));
  return runs;
}

const RatioRun& run_of(const std::vector<RatioRun>& runs, double ratio) {
  for (const RatioRun& run : runs) {
    if (run.ratio == ratio) return run;
  }
  throw std::out_of_range("run_of: no run with this ratio");
}

}  // namespace cairn::edges
