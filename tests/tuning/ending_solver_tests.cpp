// The tuner and a solver whose solves end by themselves, as those of Newton's method do.
#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include <cairn/study/tuning/tuner.hpp>

using namespace cairn;

namespace {

/// Solves that end by themselves: with 8 systems and more each ends after one, with fewer none is ever
/// solved, and costs 20 times as much.
TrialResult ending_run(const Setting& setting, std::uint64_t = 0, double = 0) {
  TrialResult result;
  result.seconds = 2;
  const bool is_solved = setting.sweeps.iterations >= 8;
  result.worst_penetration = is_solved ? 0.0 : 1.0;
  result.step_seconds = (is_solved ? 1e-6 : 20e-6) * setting.substeps * result.seconds / setting.dt;
  result.steps = static_cast<int>(std::lround(result.seconds / setting.dt));
  result.median_step = result.step_seconds / result.steps;
  if (!is_solved) result.failures = {{}};
  return result;
}

}  // namespace

TEST_CASE("a solver that ends by itself is tried in fewer substeps, by what its solved runs cost") {
  Setting own{.solver = "newton", .substeps = 4};
  own.sweeps.iterations = 20;
  TunerOptions options = {.solvers = {"newton"}, .first = {own}, .starts = 1, .time_limit = 1e9};
  Setting fewest = own;
  fewest.substeps = 1;
  const double least = ending_run(fewest).cost(), frame = ending_run(fewest).frame();
  for (const std::optional<double> budget : {std::optional<double>(), std::optional<double>(1.5 * frame)}) {
    CAPTURE(budget.value_or(0));
    options.budget = budget;
    const TunerAnswer answer = tune(ending_run, {.penetration = 1e-3}, options);
    REQUIRE(answer.best);
    CHECK(answer.best->cost <= least);
    CHECK(answer.best->setting.sweeps.iterations >= 8);
  }
}

TEST_CASE("where nothing holds within a budget, the fastest that holds is named, not one that fails sooner") {
  TunerOptions options = {.solvers = {"newton"}, .starts = 1, .time_limit = 1e9, .budget = 1e-12};
  const TunerRun fast_failures = [](const Setting& setting, std::uint64_t, double) {
    TrialResult result = ending_run(setting);
    result.step_seconds = 0;  // nothing is known to be too much
    result.median_step = result.failures.empty() ? 1e-3 : 1e-13;
    return result;
  };
  const TunerAnswer answer = tune(fast_failures, {.penetration = 1e-3}, options);
  CHECK_FALSE(answer.best);
  REQUIRE(answer.nearest);
  CHECK(answer.nearest->setting.sweeps.iterations >= 8);
}
