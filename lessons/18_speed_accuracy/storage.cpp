// What a solver takes before its first sweep, and what a row update takes where rows fill more than a cache.
#include "lesson.hpp"

#include <Eigen/LU>
#include <chrono>

#include "lessons/kit/random.hpp"

namespace cairn::cost {

namespace {

constexpr int small_rows = 500, large_rows = 500'000;  // some 70 kB, and some 70 MB
constexpr int prepared_rows = 200;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// [s] of a solve with so many sweeps, the least of some.
double seconds_of_solve(Solver<double>& solver, const VelocityProblem<double>& start) {
  double least = std::numeric_limits<double>::infinity();
  for (int reading = 0; reading < 9; ++reading) {
    VelocityProblem<double> problem = start;
    const auto begin = std::chrono::steady_clock::now();
    solver.solve(problem);
    least = std::min(least, seconds_since(begin));
  }
  return least;
}

template <typename Kind>
SetUp set_up_of(const std::string& name) {
  const VelocityProblem<double> problem = tower_problem(prepared_rows);
  Kind once({.iterations = 1}), often({.iterations = 51});
  const double first = seconds_of_solve(once, problem);
  const double sweep = (seconds_of_solve(often, problem) - first) / 50;
  return {name, (first - sweep) / sweep};
}

/// Sweeps over rows of which row i lies at place[i]. @returns [ns] of a row update, the least of some sweeps.
double time_of_sweeps(VelocityProblem<double>& problem, const PerRow<ConstraintRow<double>>& rows,
                      const List<int>& place) {
  double least = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < 3; ++sweep) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < place.size(); ++i) {
      const ConstraintRow<double>& row = rows[place[i]];
      const double corrective = -row_velocity(problem, row) * (i == 0 ? 1 : 0.5);  // (22), boxes of 1 kg
      const double sum = std::max(0.0, problem.impulse[i] + corrective);
      apply_impulse(problem, row, sum - problem.impulse[i]);
      problem.impulse[i] = sum;
    }
    least = std::min(least, 1e9 * seconds_since(begin) / place.size());
  }
  return least;
}

Stored time_stored(int rows) {
  VelocityProblem<double> in_order = tower_problem(rows), shuffled = in_order;
  Stored stored{.rows = rows, .bytes = static_cast<double>(rows * sizeof(ConstraintRow<double>))};
  List<int> place;
  for (int i = 0; i < rows; ++i) place.push_back(i);
  stored.in_order = time_of_sweeps(in_order, in_order.rows, place);
  Random random(1);
  for (int i = rows; i-- > 1;) std::swap(place[i], place[static_cast<int>(random.between(0, i + 1))]);
  PerRow<ConstraintRow<double>> scattered = in_order.rows;
  for (int i = 0; i < rows; ++i) scattered[place[i]] = in_order.rows[i];
  stored.shuffled = time_of_sweeps(shuffled, scattered, place);
  for (int i = 0; i < rows; ++i)
    stored.change = std::max(stored.change, std::abs(in_order.impulse[i] - shuffled.impulse[i]));
  return stored;
}

}  // namespace

void measure_storage(CostRun& run) {
  run.set_ups = {set_up_of<SequentialImpulse<double>>("SI"),
                 set_up_of<SparseProjectedGaussSeidel<double>>("sparse PGS"),
                 set_up_of<ProjectedGaussSeidel<double>>("dense PGS")};
  run.stored = {time_stored(small_rows), time_stored(large_rows)};
}

void print_storage(Lesson& lesson, const CostRun& run) {
  std::string line = fmt::format("6. Before the first sweep, in sweeps, {} rows:", prepared_rows);
  for (const SetUp& each : run.set_ups)
    line += fmt::format("  {} {}", each.name, significant(each.sweeps, 2));
  lesson.print(line);
  lesson.print("7. Out of the cache, ns for one row update; rows stored in order and shuffled:");
  for (const Stored& each : run.stored)
    lesson.print(fmt::format("   {:>7} rows, {:>9} kB {:>9} {:>9}", each.rows,
                             significant(each.bytes / 1000, 2), significant(each.in_order, 2),
                             significant(each.shuffled, 2)));
  lesson.print();
}

void check_storage(Lesson& lesson, const CostRun& run) {
  double change = 0;
  for (const Stored& each : run.stored) change = std::max(change, each.change);
  lesson.check_small("rows stored in another order: change of the impulses (N s)", change, 0);
  const int n = run.settings.boxes;
  const SystemMatrices<double> pgs = system_matrices(tower_problem(n));
  const Vector<double> eliminated = pgs.A.partialPivLu().solve(pgs.b);
  const List<double> exact = exact_lambda(n);
  double gap = 0;
  for (int i = 0; i < n; ++i) gap = std::max(gap, std::abs(eliminated(i) - exact[i]));
  // The condition of A is below 2 n², and elimination rounds some n times at the size of n g.
  lesson.check_small("A and b of PGS, eliminated: the exact loads (N)", gap,
                     epsilon * 2 * n * n * n * n * gravity);
  VelocityProblem<double> problem = tower_problem(n);
  SequentialImpulse<double>({.iterations = run.settings.sweeps}).solve(problem);
  const List<double> special = tower_only(n, run.settings.sweeps);
  double apart = 0;
  for (int i = 0; i < n; ++i) apart = std::max(apart, std::abs(special[i] - problem.impulse[i]));
  lesson.check_small("a loop for this tower only repeats SI: the same impulses (N s)", apart, 0);
}

}  // namespace cairn::cost
