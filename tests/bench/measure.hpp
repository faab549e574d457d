// Times many things in one run, a little of each in turn, with Google Benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/solvers/solver.hpp>

namespace cairn::bench {

/// Above this spread the machine had other work, or the code has two speeds: a ratio would mean nothing.
inline constexpr double largest_noise = 0.10;

/// Repetitions of one time [ns].
struct Times {
  double median = 0;
  double lower_quartile = 0;
  double upper_quartile = 0;
  double noise() const { return (upper_quartile - lower_quartile) / median; }
};

/// What is timed, and how often. `run` is a benchmark as its library wants it.
struct Case {
  std::string name = {};  // no two alike
  std::function<void(benchmark::State&)> run = {};
  std::int64_t iterations = 1;  // in each repetition
  int repetitions = 11;
};

/// What came out of a case: the time of one iteration, and of each counter the median.
struct Outcome {
  Times time = {};
  std::map<std::string, double> counters = {};
};

/// Seconds of processor time that this thread has used since the stopwatch was made. What other programs take
/// of a busy machine is not in it.
class Stopwatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now();
  double start_ = now();
};

/// How long a solve takes [s], from where `start` begins. `problem` is scratch, as large as `start`.
double solve_seconds(Solver<double>& solver, const VelocityProblem<double>& start,
                     VelocityProblem<double>& problem, SolveObserver<double>* observer = nullptr);

/// Bytes of the heap that are in use, whoever asked for them: the C library counts them.
double heap_in_use();

/// Runs all repetitions of all cases in a shuffled order, so that what disturbs the machine for a while
/// disturbs all of them alike.
std::map<std::string, Outcome> measure(const List<Case>& cases);

/// Median and quartiles; at least one value.
Times times_of(List<double> nanoseconds);

/// How many iterations fill one repetition, from how long one took [s].
std::int64_t iterations_for(double seconds);

/// "1.23", or "noisy" when one of the two times cannot be trusted.
std::string ratio_cell(const Times& time, const Times& reference);
/// "4.5 %"
std::string noise_cell(const Times& time);

}  // namespace cairn::bench
