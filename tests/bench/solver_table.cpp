// What a row update of each solver costs, and what it buys (paper 4.1 and 4.4).
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "scenes.hpp"
#include <cairn/solvers/wide/wide_sequential_impulse.hpp>
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

using SolverFactory = std::function<std::unique_ptr<Solver<double>>(SolverSettings)>;

struct SolverEntry {
  std::string label = {};
  SolverFactory make = {};
};

template <typename SolverType>
std::unique_ptr<Solver<double>> plain_solver(const SolverSettings& settings) {
  return std::make_unique<SolverType>(settings);
}

std::unique_ptr<Solver<double>> coloured_si(SolverSettings settings) {
  settings.order = RowOrder::coloured;
  return std::make_unique<SequentialImpulse<double>>(settings);
}

std::unique_ptr<Solver<double>> si_masses_in_the_loop(const SolverSettings& settings) {
  return std::make_unique<SequentialImpulse<double>>(
      settings, SequentialImpulseVariant{.effective_mass = EffectiveMass::in_the_loop});
}

std::unique_ptr<Solver<double>> damped_jacobi(SolverSettings settings) {
  settings.relaxation = 0.25;
  return std::make_unique<Jacobi<double>>(settings);
}

std::unique_ptr<Solver<double>> mass_splitting(const SolverSettings& settings) {
  return std::make_unique<Jacobi<double>>(settings, Splitting::mass);
}

/// The first is what the others are compared with.
List<SolverEntry> solver_entries() {
  return {
      {"SI", plain_solver<SequentialImpulse<double>>},
      {"SI, masses in the loop", si_masses_in_the_loop},
      {"SI, coloured order", coloured_si},
      {"PGS factored", plain_solver<FactoredProjectedGaussSeidel<double>>},
      {"PGS sparse", plain_solver<SparseProjectedGaussSeidel<double>>},
      {"PGS dense", plain_solver<ProjectedGaussSeidel<double>>},
      {"PGS naive", plain_solver<NaiveProjectedGaussSeidel<double>>},
      {"PGS accelerated", plain_solver<AcceleratedProjectedGaussSeidel<double>>},
      {"SI in lanes", plain_solver<WideSequentialImpulse<double>>},
      {"Jacobi, omega 1/4", damped_jacobi},
      {"Jacobi, mass splitting", mass_splitting},
  };
}

/// So many sweeps that they take longer than all that is done once, and long enough for the clock.
int sweeps_to_time(const SolverEntry& entry, const VelocityProblem<double>& start,
                   VelocityProblem<double>& problem) {
  const double once = solve_seconds(*entry.make({.iterations = 1}), start, problem);
  int sweeps = 10;
  for (; sweeps < 640; sweeps *= 2) {
    const double many = solve_seconds(*entry.make({.iterations = 1 + sweeps}), start, problem);
    if (many > 3 * once && many > 2e-4) break;
  }
  return sweeps;
}

/// Times the sweeps alone: a solve with many more sweeps than one, minus a solve with one. What the solve
/// with one takes on top of a sweep is the set-up.
Case sweep_case(const SolverEntry& entry, const VelocityProblem<double>& start) {
  const auto problem = std::make_shared<VelocityProblem<double>>(start);
  const int sweeps = sweeps_to_time(entry, start, *problem);
  const std::shared_ptr<Solver<double>> once = entry.make({.iterations = 1});
  const std::shared_ptr<Solver<double>> many = entry.make({.iterations = 1 + sweeps});
  const auto one_solve_of_each = [=, &start] {
    const double one = solve_seconds(*once, start, *problem);
    const double sweep = (solve_seconds(*many, start, *problem) - one) / sweeps;
    return std::pair{sweep, one - sweep};
  };
  one_solve_of_each();  // all memory is touched now
  const Stopwatch pilot;
  one_solve_of_each();
  const double seconds = pilot.seconds();
  const auto run = [=](benchmark::State& state) {
    double all_set_up = 0;
    for (auto _ : state) {
      const auto [sweep, set_up] = one_solve_of_each();
      state.SetIterationTime(sweep);
      all_set_up += set_up;
    }
    state.counters["set-up [s]"] = all_set_up / static_cast<double>(state.iterations());
  };
  const int repetitions = seconds > 0.5 ? 5 : 15;
  return {.name = entry.label, .run = run, .iterations = iterations_for(seconds), .repetitions = repetitions};
}

/// The problem after so many sweeps from a cold start.
VelocityProblem<double> solved(const SolverEntry& entry, int sweeps, VelocityProblem<double> problem) {
  entry.make({.iterations = sweeps})->solve(problem);
  return problem;
}

/// R_E of the velocities that the solver returns.
std::string residual_cell(const VelocityProblem<double>& answer, const VelocityProblem<double>& start) {
  return fmt::format("{:.2e}", residual(answer, residual_scale(start)).energy);
}

/// The largest difference of two impulses, over the largest impulse.
std::string difference_cell(const PerRow<double>& impulses, const PerRow<double>& reference) {
  double difference = 0, largest = 0;
  for (int i = 0; i < impulses.size(); ++i) {
    difference = std::max(difference, std::abs(impulses[i] - reference[i]));
    largest = std::max(largest, std::abs(reference[i]));
  }
  return difference == 0 ? "0" : fmt::format("{:.0e}", difference / largest);
}

std::string memory_cell(const SolverEntry& entry, VelocityProblem<double> problem) {
  const double m = problem.row_count();
  const double of_problem = static_cast<double>(problem_memory(problem)) / m;
  const auto solver = entry.make({.iterations = 1});
  solver->solve(problem);
  return fmt::format("{:.0f} + {:.0f}", static_cast<double>(solver->memory()) / m, of_problem);
}

/// For each row [ns]; "< 5" where it cannot be told from the spread of a sweep. A first sweep that is cheaper
/// than the others, as that of accelerated PGS, is taken off.
std::string set_up_cell(const Outcome& outcome, double m) {
  const double set_up = outcome.counters.at("set-up [s]") * 1e9;
  const double spread = outcome.time.upper_quartile - outcome.time.lower_quartile;
  if (set_up < spread) return fmt::format("< {:.0f}", std::ceil(spread / m));
  return fmt::format("{:.0f}", set_up / m);
}

void print_for_pyramid(int base) {
  const VelocityProblem<double> start = cold(pyramid_problem(base));
  const double m = start.row_count();
  const List<SolverEntry> entries = solver_entries();
  List<Case> cases;
  for (const SolverEntry& entry : entries) cases.push_back(sweep_case(entry, start));
  const std::map<std::string, Outcome> outcomes = measure(cases);

  fmt::print("Pyramid of base {}: {} bodies, m = {} rows\n", base, start.body_count() - 1, start.row_count());
  TextTable table({{"solver", ""},
                   {"row update", "ns"},
                   {"noise", ""},
                   {"to SI", "ratio"},
                   {"set-up", "ns/row"},
                   {"own + problem", "bytes/row"},
                   {"R_E, 10", "sweeps"},
                   {"R_E, 100", "sweeps"},
                   {"p - p_SI", "relative"}});
  const VelocityProblem<double> reference = solved(entries[0], 10, start);
  const Times& reference_time = outcomes.at(entries[0].label).time;
  for (const SolverEntry& entry : entries) {
    const Outcome& outcome = outcomes.at(entry.label);
    const VelocityProblem<double> answer = solved(entry, 10, start);
    table.add({entry.label, three_digits(outcome.time.median / m), noise_cell(outcome.time),
               ratio_cell(outcome.time, reference_time), set_up_cell(outcome, m), memory_cell(entry, start),
               residual_cell(answer, start), residual_cell(solved(entry, 100, start), start),
               difference_cell(answer.impulse, reference.impulse)});
  }
  fmt::print("{}\n", table.text());
}

}  // namespace

void print_solver_table() {
  print_heading("1. Solvers: what a row update costs, and what it buys");
  fmt::print(
      "Paper 4.1: SI and PGS are one method: their R_E agree, and their impulses p but for rounding (last\n"
      "column, after 10 sweeps, over the largest impulse). Paper 4.4: PGS wastes time when it computes all\n"
      "velocities for every row (naive), and memory when it stores A (dense). A row update is one visit to "
      "a\n"
      "row; a sweep visits each once. Set-up is done once a solve: A, effective masses, the order of the "
      "rows.\n"
      "Own: what the solver keeps beside the problem. R_E is 1 at the start, which is cold (no impulses), "
      "and 0\n"
      "when solved.\n\n");
  for (const int base : {5, 10, 20}) print_for_pyramid(base);
}

}  // namespace cairn::bench
