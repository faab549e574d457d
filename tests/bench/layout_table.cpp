// What objects and virtual calls cost in a sweep (paper 4.2 and 4.4).
#include <fmt/format.h>

#include <stdexcept>

#include "layouts.hpp"
#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "scenes.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

/// @throws std::logic_error unless ten sweeps give the impulses and velocities of SequentialImpulse, bit by
/// bit: otherwise the times would be those of different computations.
void require_same_answer(Layout& layout, const VelocityProblem<double>& start) {
  const int sweeps = 10;
  VelocityProblem<double> expected = start;
  SequentialImpulse<double>({.iterations = sweeps}).solve(expected);
  PerBody<Vec3<double>> velocity = start.velocity;
  for (int sweep = 0; sweep < sweeps; ++sweep) layout.sweep(velocity);
  if (layout.impulses() != expected.impulse || velocity != expected.velocity) {
    throw std::logic_error("cairn_bench: " + layout.name() + ": impulses must be those of SequentialImpulse");
  }
}

/// Goes on from where the last sweep ended: what a sweep costs does not depend on how far it has come.
Case layout_case(const std::shared_ptr<Layout>& layout, const VelocityProblem<double>& start) {
  const auto velocity = std::make_shared<PerBody<Vec3<double>>>(start.velocity);
  const Stopwatch pilot;
  for (int sweep = 0; sweep < 5; ++sweep) layout->sweep(*velocity);
  const std::int64_t sweeps = iterations_for(pilot.seconds() / 5);
  const auto run = [=](benchmark::State& state) {
    for (auto _ : state) {
      const Stopwatch stopwatch;
      for (std::int64_t sweep = 0; sweep < sweeps; ++sweep) layout->sweep(*velocity);
      state.SetIterationTime(stopwatch.seconds() / static_cast<double>(sweeps));
      benchmark::DoNotOptimize(velocity->data());
    }
  };
  return {.name = layout->name(), .run = run, .iterations = 1, .repetitions = 21};
}

/// The library's own sweeps: an order that can be chosen, stopping, observers.
Case library_case(const VelocityProblem<double>& start) {
  const int sweeps = 20;
  const auto problem = std::make_shared<VelocityProblem<double>>(start);
  const auto solver = std::make_shared<SequentialImpulse<double>>(SolverSettings{.iterations = sweeps});
  solve_seconds(*solver, start, *problem);  // all memory is touched now
  const double seconds = solve_seconds(*solver, start, *problem);
  const auto run = [=, &start](benchmark::State& state) {
    for (auto _ : state) state.SetIterationTime(solve_seconds(*solver, start, *problem) / sweeps);
  };
  return {.name = "SequentialImpulse, with its set-up",
          .run = run,
          .iterations = iterations_for(seconds),
          .repetitions = 21};
}

void print_for_scene(int base) {
  const VelocityProblem<double> start = cold(pyramid_with_chains_problem(base));
  List<Case> cases;
  for (std::unique_ptr<Layout>& layout : make_layouts(start)) {
    require_same_answer(*layout, start);
    cases.push_back(layout_case(std::move(layout), start));
  }
  const VelocityProblem<double> coloured = in_coloured_order(start);
  std::shared_ptr<Layout> coloured_layout = make_coloured_layout(coloured);
  require_same_answer(*coloured_layout, coloured);
  cases.push_back(layout_case(coloured_layout, coloured));
  cases.push_back(library_case(start));
  const std::map<std::string, Outcome> outcomes = measure(cases);

  int joint_rows = 0;
  for (const ConstraintRow<double>& row : start.rows) joint_rows += row.bounds.is_equality() ? 1 : 0;
  const std::size_t bytes = start.rows.bytes() + 2 * start.impulse.bytes();  // two more numbers a row
  fmt::print(
      "Pyramid of base {} and chains: m = {} rows in {} constraints, {} rows of joints; the rows take {} "
      "kB\n",
      base, start.row_count(), start.blocks.size(), joint_rows,
      grouped(static_cast<std::ptrdiff_t>(bytes / 1000)));
  TextTable table(
      {{"how the sweep is written", ""}, {"row update", "ns"}, {"noise", ""}, {"to the first", "ratio"}});
  const double m = start.row_count();
  const Times& first = outcomes.at(cases[0].name).time;
  for (const Case& one : cases) {
    const Times& time = outcomes.at(one.name).time;
    table.add({one.name, three_digits(time.median / m), noise_cell(time), ratio_cell(time, first)});
  }
  fmt::print("{}\n", table.text());
}

}  // namespace

void print_layout_table() {
  print_heading("2. Layout: the same SI sweep with arrays and with objects");
  fmt::print(
      "Paper 4.2: a class for each type of constraint. Paper 4.4: virtual calls bring overhead with them, "
      "small\n"
      "beside their flexibility; arrays lie well in the cache, which matters only for systems that do not "
      "fit.\n"
      "All ways gave the impulses and velocities of SequentialImpulse after ten sweeps, to the last bit.\n"
      "Scattered: each object allocated alone, in a shuffled order. Coloured: neighbours share no body that "
      "can\n"
      "move, so that no update waits for the one before; the same sweep in another order, as many "
      "bytes.\n\n");
  for (const int base : {10, 30, 100}) print_for_scene(base);
}

}  // namespace cairn::bench
