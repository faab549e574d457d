// Floor 9. Which settings a tuner tries, and in which order.
#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/study/tuning/tuner.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

void sort_by_work(List<Setting>& settings) {
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return expected_work(a) < expected_work(b); });
}

/// A choice that finds an answer soon: most of what the others are too much work beside.
bool is_coarse(const Setting& setting) {
  const auto is_power_of_4 = [](int number) {
    while (number % 4 == 0) number /= 4;
    return number == 1;
  };
  return setting.dt == 1.0 / 60 && setting.stabilization.policy == StabilizationPolicy::relaxed &&
         is_power_of_4(setting.substeps) && is_power_of_4(setting.sweeps.iterations);
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
  const int iterations = solver.ends_by_itself() ? 1 : setting.sweeps.iterations;
  const double sweeps = (twice ? 2 : 1) * iterations * solver.work_of_a_sweep;
  return steps * (work_of_a_step + sweeps);
}

List<Setting> tuner_settings(const List<std::string>& solvers, bool has_joints) {
  List<StabilizationPolicy> policies = {StabilizationPolicy::relaxed, StabilizationPolicy::soft,
                                        StabilizationPolicy::split_impulse};
  if (has_joints) policies.push_back(StabilizationPolicy::baumgarte);
  List<Setting> settings;
  for (const std::string& solver : solvers) {
    const SolverEntry& entry = solver_entry(solver);
    List<int> sweeps = doubled(1, entry.most_tried_sweeps);
    if (entry.ends_by_itself()) std::reverse(sweeps.begin(), sweeps.end());
    const List<Setting> own = settings_of({.solvers = {solver},
                                           .frequencies = {60, 120, 240},
                                           .substeps = {1, 2, 4, 8, 16},
                                           .sweeps = sweeps,
                                           .policies = policies});
    settings.insert(settings.end(), own.begin(), own.end());
  }
  sort_by_work(settings);
  std::stable_partition(settings.begin(), settings.end(), is_coarse);
  return settings;
}

List<Setting> plain_si_settings() { return settings_of({.sweeps = doubled(1, 1024)}); }

List<Setting> box2d_settings() {
  List<Setting> settings = settings_of({.solvers = {"box2d"},
                                        .frequencies = {60, 120, 240},
                                        .substeps = {1, 4},
                                        .sweeps = doubled(4, 64),
                                        .position_iterations = {3, 10}});
  sort_by_work(settings);
  return settings;
}

}  // namespace cairn
