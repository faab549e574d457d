// Floor 11. Which settings a tuner tries, and in which order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/solver_list.hpp"
#include "tuning/tuner.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

/// In level 2 of the study no scene that newton loses with 1 to 16 linear systems a step, at a step of the
/// grid, is held with 32 or 64: none of 738.
int most_sweeps_of(const std::string& solver) {
  if (solver == "reference") return 1;
  return solver == "newton" ? 16 : 256;
}

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

double work_of_a_sweep(const std::string& solver) {
  if (solver == "block" || solver == "block-contact") return 1.6;
  if (solver == "accelerated") return 1.3;
  if (solver == "wide") return 0.15;
  if (solver == "wide-accelerated") return 0.3;
  if (solver == "pgs-sparse") return 1.8;
  return solver == "box2d" ? 1 : solver_entry(solver).updates_a_row;
}

double expected_work(const Setting& setting) {
  const double steps = setting.substeps / setting.dt;
  if (setting.solver == "reference") return steps * 2000;
  const StabilizationPolicy policy = setting.stabilization.policy;
  const bool twice = policy == StabilizationPolicy::relaxed || policy == StabilizationPolicy::soft ||
                     policy == StabilizationPolicy::split_impulse;
  const double sweeps = (twice ? 2 : 1) * setting.sweeps.iterations * work_of_a_sweep(setting.solver);
  return steps * (work_of_a_step + sweeps);
}

List<Setting> tuner_settings(const List<std::string>& solvers, bool has_joints) {
  List<StabilizationPolicy> policies = {StabilizationPolicy::relaxed, StabilizationPolicy::soft,
                                        StabilizationPolicy::split_impulse};
  if (has_joints) policies.push_back(StabilizationPolicy::baumgarte);
  List<Setting> settings;
  for (const std::string& solver : solvers) {
    const int most_sweeps = most_sweeps_of(solver);
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
