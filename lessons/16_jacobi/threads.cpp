// The parallel hardware at hand: rows of one colour on two threads, and in the lanes of one.
#include "lesson.hpp"

#include <barrier>
#include <chrono>
#include <thread>

namespace cairn::everybody {

namespace {

constexpr int threaded_sweeps = 10;

/// A row update of SI that writes nothing to bodies that cannot move: rows of one colour may share those.
void update_row(VelocityProblem<double>& problem, int i) {
  const ConstraintRow<double>& row = problem.rows[i];
  const double before = problem.impulse[i];
  const double sum = before + effective_mass(problem, row) * (row.bias - row_velocity(problem, row));
  problem.impulse[i] = row.bounds.clamp(sum, problem.impulse);
  const double p = problem.impulse[i] - before;
  const auto push = [&problem, p](BodyId body, const Vec3<double>& j) {
    const Vec3<double>& inverse = problem.inverse_mass[body];
    if (inverse.x() > 0) problem.velocity[body] += inverse.cwiseProduct(j) * p;
  };
  push(row.a, row.jacobian_a);
  push(row.b, row.jacobian_b);
}

/// Sweeps colour by colour, each colour shared out among the threads. @returns [ns] of a row update.
double sweep_on_threads(VelocityProblem<double>& problem, const RowSequence& sequence, int threads) {
  std::barrier turn(threads);
  // [threads]
  const auto work = [&](int number) {
    for (int sweep = 0; sweep < threaded_sweeps; ++sweep) {
      for (int colour = 0; colour + 1 < sequence.colours.size(); ++colour) {
        const int first = sequence.colours[colour], count = sequence.colours[colour + 1] - first;
        const int begin = first + count * number / threads, end = first + count * (number + 1) / threads;
        for (int k = begin; k < end; ++k) update_row(problem, sequence.rows[k]);
        turn.arrive_and_wait();  // the next colour needs what this one has done
      }
    }
  };
  // [/threads]
  const auto begin = std::chrono::steady_clock::now();
  List<std::jthread> helpers;
  for (int number = 1; number < threads; ++number) helpers.emplace_back(work, number);
  work(0);
  helpers.clear();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return 1e9 * taken.count() / (threaded_sweeps * problem.row_count());
}

double time_in_lanes(VelocityProblem<double> problem) {
  WideSequentialImpulse<double> lanes({.iterations = threaded_sweeps});
  const auto begin = std::chrono::steady_clock::now();
  lanes.solve(problem);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return 1e9 * taken.count() / (threaded_sweeps * problem.row_count());
}

ThreadedSweeps sweep_threaded(int base) {
  const VelocityProblem<double> start = World<double>(pile_scene(base)).velocity_problem();
  RowSequence sequence;
  order_rows(start, RowOrder::coloured, 1, 1, sequence);
  ThreadedSweeps swept{.rows = start.row_count(), .colours = sequence.colours.size() - 1};
  VelocityProblem<double> one = start, two = start;
  swept.one = sweep_on_threads(one, sequence, 1);
  swept.two = sweep_on_threads(two, sequence, 2);
  swept.lanes = time_in_lanes(start);
  for (int i = 0; i < start.row_count(); ++i)
    swept.change = std::max(swept.change, std::abs(one.impulse[i] - two.impulse[i]));
  return swept;
}

}  // namespace

List<ThreadedSweeps> run_threads() { return {sweep_threaded(larger_base), sweep_threaded(60)}; }

void print_threads(Lesson& lesson, const List<ThreadedSweeps>& all) {
  lesson.print("By colours on this machine, ns a row update:    one thread   two threads   lanes of one");
  for (const ThreadedSweeps& swept : all)
    lesson.print(
        fmt::format("  {:>6} rows, {:>2} waits for the other thread a sweep{:>12.1f}{:>14.1f}{:>15.1f}",
                    swept.rows, swept.colours, swept.one, swept.two, swept.lanes));
  lesson.print();
}

void check_threads(Lesson& lesson, const List<ThreadedSweeps>& all) {
  double change = 0;
  for (const ThreadedSweeps& swept : all) change = std::max(change, swept.change);
  lesson.check_small("rows of one colour on two threads: change of the impulses (N s)", change, 0);
}

}  // namespace cairn::everybody
