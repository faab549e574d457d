// Floor 11. Which settings a tuner tries, and in which order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/solver_list.hpp"
#include "tuning/tuner.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

void sort_by_work(List<Setting>& settings) {
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return expected_work(a) < expected_work(b); });
}

Stabilization with_policy(StabilizationPolicy policy) {
  Stabilization stabilization;
  stabilization.policy = policy;
  return stabilization;
}

}  // namespace

List<std::string> tuned_solvers() {
  List<std::string> names;
  for (const SolverEntry& entry : solver_entries()) {
    if (entry.tuned) names.push_back(entry.name);
  }
  return names;
}

double expected_work(const Setting& setting) {
  const double steps = setting.substeps / setting.dt;
  const SolverEntry& solver = solver_entry(setting.solver);
  if (!solver.uses_sweeps) return steps * solver.work_of_a_sweep;
  const StabilizationPolicy policy = setting.stabilization.policy;
  const bool twice = policy == StabilizationPolicy::relaxed || policy == StabilizationPolicy::soft ||
                     policy == StabilizationPolicy::split_impulse;
  const double sweeps = (twice ? 2 : 1) * setting.sweeps.iterations * solver.work_of_a_sweep;
  return steps * (work_of_a_step + sweeps);
}

List<Setting> tuner_settings(const List<std::string>& solvers, bool has_joints) {
  List<StabilizationPolicy> policies = {StabilizationPolicy::relaxed, StabilizationPolicy::soft,
                                        StabilizationPolicy::split_impulse};
  if (has_joints) policies.push_back(StabilizationPolicy::baumgarte);
  List<Setting> settings;
  for (const std::string& solver : solvers) {
    const int most_sweeps = solver_entry(solver).most_tried_sweeps;
    for (const int frequency : {60, 120, 240}) {
      for (const int substeps : {1, 2, 4, 8, 16}) {
        for (int sweeps = 1; sweeps <= most_sweeps; sweeps *= 2) {
          for (const StabilizationPolicy policy : policies) {
            Setting setting{.solver = solver, .dt = 1.0 / frequency, .substeps = substeps};
            setting.sweeps.iterations = sweeps;
            setting.stabilization = with_policy(policy);
            settings.push_back(setting);
          }
        }
      }
    }
  }
  sort_by_work(settings);
  return settings;
}

List<Setting> plain_si_settings() {
  List<Setting> settings;
  for (int sweeps = 1; sweeps <= 1024; sweeps *= 2) {
    settings.emplace_back();
    settings.back().sweeps.iterations = sweeps;
  }
  return settings;
}

List<Setting> box2d_settings() {
  List<Setting> settings;
  for (const int frequency : {60, 120, 240}) {
    for (const int substeps : {1, 4}) {
      for (int sweeps = 4; sweeps <= 64; sweeps *= 2) {
        for (const int position_iterations : {3, 10}) {
          Setting setting{.solver = "box2d", .dt = 1.0 / frequency, .substeps = substeps};
          setting.sweeps.iterations = sweeps;
          setting.position_iterations = position_iterations;
          settings.push_back(setting);
        }
      }
    }
  }
  sort_by_work(settings);
  return settings;
}

}  // namespace cairn
