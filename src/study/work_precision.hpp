// Floor 9. Work against error: what more work buys, solver by solver.
#pragma once

#include <map>
#include <string>

#include <cairn/measure/csv.hpp>
#include <cairn/study/frozen/frozen_problem.hpp>
#include <cairn/study/journal.hpp>
#include <cairn/study/solve_trial.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Level 1: frozen problems, one step each. Every solver after 1, 2, 4 ... sweeps, from nothing and from the
/// problem's own impulses, in each precision.
struct SolveGrid {
  List<std::string> solvers = {"si", "accelerated", "newton", "jacobi-split", "block", "pgs-factored"};
  int most_sweeps = 4096;
  List<Start> starts = {Start::cold, Start::warm};
  List<Precision> scalars = {Precision::double_precision, Precision::single_precision};
  SolveTiming timing = {};
};

/// One task for each point of the grid on each problem. E_M is given where the reference says that the
/// velocity is unique; failures stay in the table, with their status. Reads the frozen problems when a task
/// runs, not before.
Study solve_study(const List<FrozenProblem>& problems, const SolveGrid& grid);

/// A point of a chart: work and error of one row of a table.
struct TradePoint {
  std::string solver = {};
  std::string setting = {};
  double work = 0;
  double error = 0;
  int row = 0;            // of the table
  bool on_front = false;  // no other point has both less work and a smaller error
};

/// The rows of a table that have these words in these columns.
CsvTable rows_with(const CsvTable& table, const std::map<std::string, std::string>& words);

/// Whether a row that ended so is one that can be held against others.
bool is_point(const std::string& status);

/// What a table's rows come to: `work` and `error` name two of its columns. Rows that failed, and such whose
/// numbers are not above 0, are not among them: an error of 0 stands at `least_error`.
List<TradePoint> trade_points(const CsvTable& table, const std::string& work, const std::string& error,
                              double least_error);

/// The rows whose time can be believed: the quartile range of their solves is at most `most_spread` of the
/// median. Rows without a time are kept.
CsvTable rows_with_steady_times(const CsvTable& table, double most_spread);

/// Work to come down to an error: the least row updates of each solver, infinite where it never did.
struct WorkToError {
  std::string scene = {};
  std::string solver = {};
  List<double> row_updates = {};  // for each of the errors asked for
  std::string ending = {};        // the status after the most sweeps
};
List<WorkToError> work_to_errors(const CsvTable& table, const List<double>& residuals);

/// Of one solver over a set of problems: its work over the least work of any solver, problem by problem.
struct PerformanceProfile {
  std::string solver = {};
  List<double> ratios = {};  // >= 1, ascending, one for each problem; infinite where it failed

  /// rho(tau): the share of the problems that it solves with at most `tau` times the work of the best. What
  /// no solver solves counts as a problem too.
  double share(double tau) const;
};

/// E. D. Dolan, J. J. More, "Benchmarking optimization software with performance profiles" (2002), for the
/// error at `which` of those that work_to_errors() was asked for. A solver that has no entry for a problem
/// failed there. In the order in which the solvers first appear.
List<PerformanceProfile> performance_profiles(const List<WorkToError>& work, int which);

}  // namespace cairn
