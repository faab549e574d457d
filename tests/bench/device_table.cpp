// All rows at once on a device, beside colours on lanes: the same error, and what it takes (paper 4.4).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include <cairn/constraints/converted.hpp>
#include <cairn/math/list.hpp>
#include "measure.hpp"
#include "scenes.hpp"
#include "table.hpp"
#include "tables.hpp"
#ifdef CAIRN_HAVE_OPENCL
#include <cairn/device/opencl_jacobi.hpp>
#endif

namespace cairn::bench {

namespace {

constexpr double wanted = 0.01;  // R_E
constexpr int base = 4;          // boxes in the lowest row of a pyramid: 64 rows
constexpr int most_sweeps = 1 << 14;
constexpr int repetitions = 5;

/// A way to solve, and how often all rows wait for each other in a sweep.
struct Contender {
  std::string name = {};
  std::function<std::unique_ptr<Solver<float>>(const SolverSettings&)> make = {};
  int waits = 0;
};

/// So many of the problem side by side, on the same ground.
VelocityProblem<double> side_by_side(const VelocityProblem<double>& one, int copies) {
  VelocityProblem<double> all = one;
  const int bodies = one.body_count() - 1;
  for (int copy = 1; copy < copies; ++copy) {
    const auto moved = [&](BodyId body) {
      return body == ground ? body : BodyId{body.index + copy * bodies};
    };
    const auto later = [&](int row) { return row < 0 ? row : row + copy * one.row_count(); };
    for (ConstraintRow<double> row : one.rows) {
      row.a = moved(row.a);
      row.b = moved(row.b);
      row.bounds.normal_row = later(row.bounds.normal_row);
      row.bounds.second_normal_row = later(row.bounds.second_normal_row);
      all.rows.push_back(row);
    }
    for (const RowBlock& block : one.blocks) all.blocks.push_back({later(block.first), block.count});
    for (int body = 1; body <= bodies; ++body) {
      all.inverse_mass.push_back(one.inverse_mass[BodyId{body}]);
      all.velocity.push_back(one.velocity[BodyId{body}]);
    }
    for (const double impulse : one.impulse) all.impulse.push_back(impulse);
  }
  return all;
}

double error_after(const Contender& contender, int sweeps, const VelocityProblem<double>& start) {
  VelocityProblem<float> problem = converted<float>(start);
  contender.make({.iterations = sweeps})->solve(problem);
  return residual(converted<double>(problem), residual_scale(start)).energy;
}

/// The fewest sweeps to the error; above most_sweeps: it does not come there.
int sweeps_needed(const Contender& contender, const VelocityProblem<double>& start) {
  int enough = 1;
  while (enough <= most_sweeps && error_after(contender, enough, start) > wanted) enough *= 2;
  if (enough > most_sweeps) return enough;
  for (int step = enough / 4; step > 0; step /= 2) {
    if (error_after(contender, enough - step, start) <= wanted) enough -= step;
  }
  return enough;
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of the wall clock, medians [ms] of solves in turn: the device works beside this thread.
List<double> solve_times(const List<Contender>& contenders, const List<int>& sweeps,
                         const VelocityProblem<float>& start) {
  List<std::unique_ptr<Solver<float>>> solvers;
  for (int i = 0; i < contenders.size(); ++i) {
    solvers.push_back(contenders[i].make({.iterations = sweeps[i]}));
  }
  List<List<double>> times(contenders.size());
  VelocityProblem<float> problem = start;
  for (int repetition = 0; repetition <= repetitions; ++repetition) {
    for (int i = 0; i < contenders.size(); ++i) {
      problem.velocity = start.velocity;
      problem.impulse = start.impulse;
      const double begin = wall_seconds();
      solvers[i]->solve(problem);
      // The first one touches all memory.
      if (repetition > 0) times[i].push_back(1e3 * (wall_seconds() - begin));
    }
  }
  List<double> medians;
  for (const List<double>& all : times) medians.push_back(times_of(all).median);
  return medians;
}

template <typename SolverType>
std::unique_ptr<Solver<float>> made(const SolverSettings& settings) {
  return std::make_unique<SolverType>(settings);
}

List<Contender> all_contenders() {
  List<Contender> all = {
      {"si", made<SequentialImpulse<float>>},
      {"wide", made<WideSequentialImpulse<float>>},
      {"jacobi-split", [](const SolverSettings& settings) -> std::unique_ptr<Solver<float>> {
         return std::make_unique<Jacobi<float>>(settings, Splitting::mass);
       }}};
#ifdef CAIRN_HAVE_OPENCL
  if (has_opencl_device<float>()) all.push_back({"opencl-jacobi", made<OpenClJacobi<float>>, 2});
#endif
  return all;
}

void print_device() {
#ifdef CAIRN_HAVE_OPENCL
  if (has_opencl_device<float>()) {
    fmt::print("OpenCL device: {}\n\n", OpenClJacobi<float>().device());
    return;
  }
#endif
  fmt::print("OpenCL device: none, or built without OpenCL\n\n");
}

}  // namespace

void print_device_table() {
  print_heading("11. All rows at once on a device, beside colours on lanes");
  fmt::print(
      R"(Pyramids of {} boxes at the bottom, side by side on one ground, from a cold start, in float, down to R_E <=
{}: every solver does as many sweeps as it needs for that, and only then are times compared. Waits: how often
all that work at once wait for the last of them, the kernels of a device. Times are of the
wall clock, with all that a solve sets up and sends, medians of {} solves in turn.
)",
      base, wanted, repetitions);
  print_device();
  const VelocityProblem<double> one = cold(pyramid_problem(base));
  const List<Contender> contenders = all_contenders();
  List<int> sweeps;
  for (const Contender& contender : contenders) sweeps.push_back(sweeps_needed(contender, one));
  TextTable table({{"rows", "m"},
                   {"solver", ""},
                   {"sweeps", ""},
                   {"waits", ""},
                   {"R_E", "at the end"},
                   {"a solve", "ms"},
                   {"a row update", "ns"},
                   {"to si", "ratio"}});
  for (const int copies : {16, 156, 1563, 15'625}) {
    const VelocityProblem<double> start = side_by_side(one, copies);
    const List<double> times = solve_times(contenders, sweeps, converted<float>(start));
    for (int i = 0; i < contenders.size(); ++i) {
      const double updates = static_cast<double>(sweeps[i]) * start.row_count();
      table.add({grouped(start.row_count()), contenders[i].name, grouped(sweeps[i]),
                 grouped(std::ptrdiff_t{sweeps[i]} * contenders[i].waits),
                 fmt::format("{:.4f}", error_after(contenders[i], sweeps[i], start)), three_digits(times[i]),
                 three_digits(1e6 * times[i] / updates), three_digits(times[i] / times[0])});
    }
  }
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
