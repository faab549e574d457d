// Lesson 08. The same thing twice: PGS on A lambda = b and SI, row by row.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pictures.hpp"
#include "twice.hpp"

namespace {

using namespace cairn;
using namespace cairn::twice;

LessonInfo info() {
  return {
      .number = 8,
      .name = "same_thing_twice",
      .title = "The same thing twice",
      .idea =
          "PGS solves A λ = b and never looks at a velocity; SI looks at velocities and never builds A. They "
          "are one algorithm in two costumes.",
      .paper = "paper 4.1, eq (24)-(29)",
      .equations = {"(26)  v = v̄ + M⁻¹ Jᵀ η Δt                          what SI keeps up to date",
                    "(27)  η_i ← η_i + (ζ − j·v) / (j M⁻¹ jᵀ Δt)        one update of SI",
                    "(28)  η_i ← (b_i − Σ_{j≠i} A_ij η_j) / A_ii        one update of PGS",
                    "(29)  put A = J M⁻¹ Jᵀ, b = (ζ − J v̄)/Δt and (26) into (28), and (27) is left"},
      .needs = {"lesson 06"},
      .reads = {"src/solvers/projected_gauss_seidel.cpp", "src/solvers/sequential_impulse.cpp"},
      .question =
          "After 50 sweeps in single precision: will the impulses of PGS and SI be equal to the last bit?",
      .hints = {"Write v of (27) as (26) says, and look for a row of A.",
                "(a + b) + c and a + (b + c) are the same number, but not the same float.",
                "Each row adds up about twenty numbers, in another order in each solver."},
      .parameters = {{"dt", 0.02, 0.0001, 1, "s", "time step"},
                     {"sweeps", 50, 2, 1000, "", "sweeps", Parameter::Kind::whole},
                     {"seed", 1, 0, 1e9, "", "of the random problem", Parameter::Kind::whole}},
      .cover = 16,
      .next = "lesson09_warm_start   (yesterday's answer is today's first guess)"};
}

void print_first_sweep(Lesson& lesson, const TwiceRun& run) {
  lesson.print("Sweep 1, before clamping (N):");
  lesson.print("step      η_l       j·v         (27) SI       (28) PGS           (29)   (27)-(28)   clamped");
  for (const RowStep& step : run.steps) {
    const std::string line = fmt::format(
        "{:>4} {:>8.3f} {:>9.4f} {:>15.8f} {:>14.8f} {:>14.8f} {:>11.1e} {:>9.3f}", step.row + 1, step.eta,
        step.row_velocity, step.by_27, step.by_28, step.by_29, step.by_27 - step.by_28, step.si);
    if (step.row < 12) {
      lesson.print(line);
    } else {
      lesson.detail(line);
    }
  }
  lesson.print(fmt::format("  ...  (-v shows all {} rows)", run.steps.size()));
  lesson.print();
}

void print_precisions(Lesson& lesson, const TwiceRun& run) {
  lesson.print(fmt::format("max |λ_PGS − λ_SI| after {} sweeps, {} of {} rows at their bound:",
                           run.settings.sweeps, run.at_bound, run.problem.row_count()));
  for (const PrecisionRun& precision : run.precisions) {
    const double worst = *std::max_element(precision.difference.begin(), precision.difference.end());
    lesson.print(fmt::format("  {:<12} {:>9.1e} N of {:.1f} N: {:.1e}, where ε is {:.1e}", precision.name,
                             worst, precision.scale, worst / precision.scale, precision.epsilon));
  }
  lesson.print("Erratum: in (28) of the paper read i for l, and m for n; both sums use the newest η.");
  lesson.print();
}

void check_precision(Lesson& lesson, const PrecisionRun& precision) {
  // The worst of all sweeps, each measured by its own bound: at most 1.
  double worst = 0;
  for (std::size_t k = 1; k < precision.difference.size(); ++k) {
    worst = std::max(
        worst, precision.difference[k] / precision.scale / rounding_bound(precision, static_cast<int>(k)));
  }
  lesson.check_small(fmt::format("{}: PGS = SI after every sweep, in units of 64 ε (1 + k)", precision.name),
                     worst, 1);
}

void check_run(Lesson& lesson, const TwiceRun& run) {
  double by_row = 0;
  double scale = 0;
  for (const RowStep& step : run.steps) {
    scale = std::max({scale, std::abs(step.by_27), std::abs(step.by_28)});
    by_row = std::max({by_row, std::abs(step.by_27 - step.by_28), std::abs(step.by_27 - step.by_29)});
  }
  // One sweep: see rounding_bound().
  lesson.check_small("(27) = (29) = (28) for every row of sweep 1 (N)", by_row, 128 * 2.3e-16 * scale);
  for (const PrecisionRun& precision : run.precisions) check_precision(lesson, precision);
  check_precision(lesson, run.warm);
  // Every update rounds two bodies' velocities, which are of the size of M^-1 J^T lambda dt: at most 10 a
  // row.
  const double updates = static_cast<double>(run.settings.sweeps) * run.problem.row_count();
  const double velocity_scale = 10 * run.precisions[1].scale * run.settings.dt + 2;
  lesson.check_small("(26) after every row update of SI (m/s)", run.identity_error,
                     2.3e-16 * updates * velocity_scale);
  lesson.check_that("some one-sided rows end at their bound", run.at_bound > 0,
                    fmt::format("{} of {}", run.at_bound, run.problem.row_count() / 2));
}

CsvTable sweeps_table(const TwiceRun& run) {
  CsvTable table{.header = {"precision", "sweep", "largest_difference_newton", "largest_lambda_newton"}};
  for (const PrecisionRun& precision : run.precisions) {
    for (std::size_t k = 0; k < precision.difference.size(); ++k) {
      table.rows.push_back(
          {precision.name, static_cast<long long>(k), precision.difference[k], precision.scale});
    }
  }
  return table;
}

void run(Lesson& lesson) {
  const TwiceSettings settings{.sweeps = lesson.whole("sweeps"),
                               .dt = lesson.real("dt"),
                               .seed = static_cast<std::uint64_t>(lesson.whole("seed"))};
  const TwiceRun twice = run_twice(settings);
  lesson.print(fmt::format(
      "Scene: {} bodies with random masses and velocities, {} random rows between them, every second "
      "one-sided; Δt = {:g} s, {} sweeps, seed {}",
      settings.bodies, settings.rows, settings.dt, settings.sweeps, settings.seed));
  lesson.predict();
  lesson.print();
  print_first_sweep(lesson, twice);
  print_precisions(lesson, twice);
  check_run(lesson, twice);
  lesson.film(twice_shots(twice));
  lesson.data(sweeps_table(twice));
  lesson.fingerprint(twice.si.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
