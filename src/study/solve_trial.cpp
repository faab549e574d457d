// Floor 9. Solving, judging, and solving again for the clock.
#include <cairn/study/solve_trial.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <cairn/constraints/converted.hpp>
#include <cairn/measure/fingerprint.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// One reading of the clock must last as long, or its own time would be seen.
constexpr double least_reading = 20e-6;  // [s]

SolveTimes times_from(List<double> nanoseconds) {
  std::sort(nanoseconds.begin(), nanoseconds.end());
  const auto at = [&](double part) { return nanoseconds[static_cast<int>(part * (nanoseconds.size() - 1))]; };
  return {.repetitions = nanoseconds.size(),
          .least = nanoseconds.front(),
          .median = at(0.5),
          .quartile_range = at(0.75) - at(0.25)};
}

/// Seconds of one solve, from `count` of them on copies that were made before.
template <Scalar Real>
double timed_solves(Solver<Real>& solver, const VelocityProblem<Real>& problem, int count) {
  List<VelocityProblem<Real>> copies(count, problem);
  const double before = thread_cpu_seconds();
  for (VelocityProblem<Real>& copy : copies) solver.solve(copy);
  return (thread_cpu_seconds() - before) / count;
}

template <Scalar Real>
SolveTimes measured_times(Solver<Real>& solver, const VelocityProblem<Real>& problem,
                          const SolveTiming& timing) {
  if (timing.repetitions < 1) return {};
  const double once = timed_solves(solver, problem, 1);  // and warms the caches
  const int batch = static_cast<int>(std::clamp(std::ceil(least_reading / std::max(once, 1e-9)), 1.0, 1e3));
  List<double> nanoseconds;
  double passed = 0;
  while (passed < timing.seconds || nanoseconds.size() < timing.repetitions) {
    const double seconds = timed_solves(solver, problem, batch);
    passed += seconds * batch;
    nanoseconds.push_back(1e9 * seconds);
  }
  return times_from(std::move(nanoseconds));
}

bool is_finite(const VelocityProblem<double>& answer) {
  return std::all_of(answer.velocity.begin(), answer.velocity.end(),
                     [](const Vec3<double>& v) { return v.allFinite(); });
}

/// How the same sweeps end where a standstill is looked for. Solved again: looking may cost a solver a
/// recomputed velocity, which the answer that is judged must not have seen.
template <Scalar Real>
std::string ending_of(const VelocityProblem<Real>& given, const SolveChoice& choice) {
  // No stall is as long: cycles and plateaus alone end it early.
  const int patience = std::numeric_limits<int>::max();
  const auto solver = make_solver<Real>(choice.solver, {.iterations = choice.sweeps, .patience = patience});
  VelocityProblem<Real> again = given;
  const Stop stop = solver->solve(again).stop;
  if (stop == Stop::cycle) return "cycle";
  return stop == Stop::plateau ? "plateau" : "ok";
}

template <Scalar Real>
SolveOutcome outcome_in(const VelocityProblem<double>& start, const SolveChoice& choice,
                        const std::optional<PerBody<Vec3<double>>>& truth, const SolveTiming& timing) {
  const VelocityProblem<Real> given = converted<Real>(start);
  const auto solver = make_solver<Real>(choice.solver, {.iterations = choice.sweeps});
  VelocityProblem<Real> solved = given;
  const SolveReport report = solver->solve(solved);
  const VelocityProblem<double> answer = converted<double>(solved);
  SolveOutcome outcome;
  outcome.status = is_finite(answer) ? ending_of(given, choice) : "nan";
  outcome.error = answer_error(start, answer, truth);
  const std::int64_t rows = start.row_count();
  outcome.row_updates =
      counted_updates(solver_entry(choice.solver), rows * report.iterations, rows * report.extra_sweeps);
  Fingerprint hash;
  for (const Vec3<Real>& velocity : solved.velocity) hash.add(velocity);
  outcome.state_hash = hash.value();
  outcome.times = measured_times(*solver, given, timing);
  return outcome;
}

}  // namespace

SolveOutcome try_solver(const VelocityProblem<double>& problem, const SolveChoice& choice,
                        const std::optional<PerBody<Vec3<double>>>& truth, const SolveTiming& timing) {
  VelocityProblem<double> start = problem;
  if (choice.start == Start::cold) std::fill(start.impulse.begin(), start.impulse.end(), 0.0);
  try {
    return choice.scalar == Precision::single_precision ? outcome_in<float>(start, choice, truth, timing)
                                                        : outcome_in<double>(start, choice, truth, timing);
  } catch (const std::length_error& error) {
    SolveOutcome refused;
    refused.status = "refused";
    refused.reason = error.what();
    return refused;
  }
}

}  // namespace cairn
