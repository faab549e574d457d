// What a row update costs on this machine, for solvers that do the same arithmetic in different ways.
#include "lesson.hpp"

#include <chrono>

#include "constraints/converted.hpp"

namespace cairn::cost {

namespace {

const int readings = 15;
const double least_reading = 1e-3;  // [s] below it the clock itself would be seen

double seconds_of(const std::function<void()>& work, int repetitions) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < repetitions; ++i) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// [ns] of one call: the least of some readings, as other programs can only make it longer.
double least_nanoseconds(const std::function<void()>& work) {
  const double once = seconds_of(work, 1);
  const int repetitions =
      static_cast<int>(std::clamp(std::ceil(least_reading / std::max(once, 1e-9)), 1.0, 1e4));
  double least = once;
  for (int reading = 0; reading < readings; ++reading)
    least = std::min(least, seconds_of(work, repetitions) / repetitions);
  return 1e9 * least;
}

/// What is left of SI where all is known beforehand: which bodies, which direction, which masses. One line
/// for this kind of row, and nothing to look up.
double tower_only(int boxes, int sweeps) {
  List<double> v(boxes + 1, -gravity * time_step);
  List<double> impulse(boxes + 1, 0.0);
  v[0] = 0;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 1; i <= boxes; ++i) {
      const double sum = std::max(0.0, impulse[i] + (v[i - 1] - v[i]) * (i == 1 ? 1.0 : 0.5));
      const double change = sum - impulse[i];
      impulse[i] = sum;
      v[i] += change;
      if (i > 1) v[i - 1] -= change;
    }
  }
  return impulse[1];
}

template <typename Real>
SolverTime time_of(const std::string& name, Solver<Real>& solver) {
  SolverTime time{.name = name};
  for (const int rows : timed_rows) {
    const VelocityProblem<Real> problem = converted<Real>(tower_problem(rows));
    VelocityProblem<Real> copy = problem;
    const double nanoseconds = least_nanoseconds([&] {
      copy.velocity = problem.velocity;
      copy.impulse = problem.impulse;
      solver.solve(copy);
    });
    time.nanoseconds.push_back(nanoseconds / (rows * timed_sweeps));
  }
  return time;
}

SolverTime time_of_tower_only() {
  SolverTime time{.name = "this tower only"};
  double kept = 0;  // or the compiler would leave everything out
  for (const int rows : timed_rows) {
    const double nanoseconds = least_nanoseconds([&] { kept += tower_only(rows, timed_sweeps); });
    time.nanoseconds.push_back(nanoseconds / (rows * timed_sweeps));
  }
  if (!(kept > 0)) time.nanoseconds.clear();
  return time;
}

}  // namespace

List<SolverTime> measure_times() {
  const SolverSettings settings{.iterations = timed_sweeps};
  SequentialImpulse<double> si(settings);
  SequentialImpulse<double> in_the_loop(settings, {.effective_mass = EffectiveMass::in_the_loop});
  SequentialImpulse<float> single(settings);
  Jacobi<double> jacobi({.iterations = timed_sweeps, .relaxation = 0.5});
  AcceleratedProjectedGaussSeidel<double> accelerated(settings);
  FactoredProjectedGaussSeidel<double> factored(settings);
  SparseProjectedGaussSeidel<double> sparse(settings);
  ProjectedGaussSeidel<double> dense(settings);
  NaiveProjectedGaussSeidel<double> naive(settings);
  return {time_of<double>("SI", si),
          time_of<double>("Jacobi", jacobi),
          time_of<double>("PGS with momentum", accelerated),
          time_of<double>("sparse PGS", sparse),
          time_of<double>("dense PGS", dense),
          time_of<double>("naive PGS", naive),
          time_of<double>("factored PGS", factored),
          time_of<float>("SI in float", single),
          time_of<double>("SI, mass in loop", in_the_loop),
          time_of_tower_only()};
}

}  // namespace cairn::cost
