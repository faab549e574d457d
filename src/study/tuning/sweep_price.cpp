// Floor 9. Times of solves, beside those of sequential impulses.
#include <cairn/study/tuning/sweep_price.hpp>

#include <algorithm>

#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/frozen/frozen_set.hpp>
#include <cairn/study/solve_trial.hpp>

namespace cairn {

namespace {

constexpr int least_rows = 30;  // fewer take less time than what a solve begins with
constexpr int measured_sweeps = 64;

/// [ns] of an update of one row, by the count of SolverEntry::updates_a_row.
double time_of_an_update(const std::string& solver, const VelocityProblem<double>& problem) {
  const SolveOutcome outcome =
      try_solver(problem, {.solver = solver, .sweeps = measured_sweeps, .start = Start::cold}, std::nullopt,
                 {.repetitions = 15, .seconds = 0.01});
  return outcome.times.least / static_cast<double>(outcome.row_updates);
}

}  // namespace

List<SweepPrice> measured_prices(const List<std::string>& solvers) {
  List<List<double>> prices(solvers.size());
  for (const std::string& name : frozen_names()) {
    const VelocityProblem<double> problem = make_frozen(name).problem;
    if (problem.row_count() < least_rows) continue;
    const double unit = time_of_an_update("si", problem);
    for (int i = 0; i < solvers.size(); ++i) {
      const double update = time_of_an_update(solvers[i], problem);
      prices[i].push_back(solver_entry(solvers[i]).updates_a_row * update / unit);
    }
  }
  List<SweepPrice> all;
  for (int i = 0; i < solvers.size(); ++i) {
    std::sort(prices[i].begin(), prices[i].end());
    all.push_back({solvers[i], prices[i].front(), prices[i][prices[i].size() / 2], prices[i].back()});
  }
  return all;
}

}  // namespace cairn
