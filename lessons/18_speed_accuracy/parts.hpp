// Lesson 18. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "cost.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"

namespace cairn::cost {

/// Prints errors, sweeps, times and the answer, and checks every claim.
void report(Lesson& lesson, const CostRun& run);

/// Errors, and no times: those are different on every run.
CsvTable errors_table(const CostRun& run);

using Runs = std::shared_ptr<const CostRun>;

/// The tower's loads sweep by sweep, errors against sweeps and work, and what moves them.
List<Shot> cost_shots(const CostRun& run);

/// Digits, sizes, precision, and what a row update takes on this machine.
List<Shot> digit_shots(const Runs& run);

/// In the order of CostRun::curves: SI, Jacobi, SOR, momentum.
render::SeriesStyle style_of(const render::Page& page, int curve);
std::string short_name(const CostRun& run, int curve);

}  // namespace cairn::cost
