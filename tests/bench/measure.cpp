// Google Benchmark measures; this keeps every repetition for the tables.
#include "measure.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <vector>

#include "table.hpp"

namespace cairn::bench {

namespace {

/// A reporter that prints nothing.
class RepetitionKeeper final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const std::string& name = run.run_name.function_name;
      if (run.error_occurred) throw std::runtime_error(name + ": " + run.error_message);
      times[name].push_back(run.real_accumulated_time / static_cast<double>(run.iterations) * 1e9);
      for (const auto& [counter, value] : run.counters) counters[name][counter].push_back(value.value);
    }
  }

  std::map<std::string, List<double>> times = {};  // [ns] of one iteration, for each repetition
  std::map<std::string, std::map<std::string, List<double>>> counters = {};
};

/// The value below which the share `part` of all values lies, between two of them where it must be.
double quantile(const List<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const int below = static_cast<int>(place);
  const int above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - below);
}

}  // namespace

double Stopwatch::now() {
  std::timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double solve_seconds(Solver<double>& solver, const VelocityProblem<double>& start,
                     VelocityProblem<double>& problem, SolveObserver<double>* observer) {
  problem.velocity = start.velocity;
  problem.impulse = start.impulse;
  const Stopwatch stopwatch;
  solver.solve(problem, observer);
  const double seconds = stopwatch.seconds();
  benchmark::DoNotOptimize(problem.impulse.data());
  return seconds;
}

double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

Times times_of(List<double> nanoseconds) {
  std::sort(nanoseconds.begin(), nanoseconds.end());
  return {.median = quantile(nanoseconds, 0.5),
          .lower_quartile = quantile(nanoseconds, 0.25),
          .upper_quartile = quantile(nanoseconds, 0.75)};
}

std::map<std::string, Outcome> measure(const List<Case>& cases) {
  for (const Case& one : cases) {
    benchmark::RegisterBenchmark(one.name.c_str(), one.run)
        ->Iterations(one.iterations)
        ->Repetitions(one.repetitions)
        ->UseManualTime();
  }
  RepetitionKeeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper, ".");
  benchmark::ClearRegisteredBenchmarks();

  std::map<std::string, Outcome> outcomes;
  for (const auto& [name, times] : keeper.times) {
    Outcome& outcome = outcomes[name];
    outcome.time = times_of(times);
    for (const auto& [counter, values] : keeper.counters[name]) {
      outcome.counters[counter] = times_of(values).median;
    }
  }
  return outcomes;
}

std::int64_t iterations_for(double seconds) {
  const double repetition =
      0.015;  // [s] long beside the clock's resolution, short beside a turn of the scheduler
  return std::clamp<std::int64_t>(std::llround(repetition / seconds), 1, 100'000);
}

std::string ratio_cell(const Times& time, const Times& reference) {
  if (std::max(time.noise(), reference.noise()) > largest_noise) return "noisy";
  return three_digits(time.median / reference.median);
}

std::string noise_cell(const Times& time) { return fmt::format("{:.1f} %", 100 * time.noise()); }

}  // namespace cairn::bench
