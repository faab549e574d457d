// What a sweep costs: a pyramid of boxes at rest, ten sweeps of each solver, warm.
//   bash tests/run bench
#include <benchmark/benchmark.h>

#include "cairn.hpp"

namespace {

using namespace cairn;

/// The problem of a pyramid with `base` boxes in its lowest row, after a few steps.
VelocityProblem<double> pyramid_problem(int base) {
  Scene scene({.dt = 0.02});
  scene.add_ground();
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      scene.add({.shapes = {box(1, 1)}, .position = {1.1 * (i + 0.5 * row), 0.5 + row}});
    }
  }
  World world(scene);
  SequentialImpulse solver;
  for (int step = 0; step < 5; ++step) world.step(solver);
  return world.velocity_problem();
}

template <typename SolverUnderTest>
void ten_sweeps(benchmark::State& state) {
  const VelocityProblem<double> start = pyramid_problem(static_cast<int>(state.range(0)));
  SolverUnderTest solver({.iterations = 10});
  VelocityProblem<double> problem = start;
  for (auto _ : state) {
    problem.velocity = start.velocity;  // linear in the rows, and small beside ten sweeps
    problem.impulse = start.impulse;
    solver.solve(problem);
    benchmark::DoNotOptimize(problem.impulse.data());
  }
  const double rows = start.row_count();
  state.counters["rows"] = rows;
  state.counters["row updates"] = benchmark::Counter(10 * rows, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["s per row update"] =
      benchmark::Counter(10 * rows, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(ten_sweeps<SequentialImpulse<double>>)->Name("SI")->Arg(3)->Arg(5)->Arg(10);
BENCHMARK(ten_sweeps<ProjectedGaussSeidel<double>>)->Name("PGS")->Arg(3)->Arg(5)->Arg(10);

}  // namespace

BENCHMARK_MAIN();
