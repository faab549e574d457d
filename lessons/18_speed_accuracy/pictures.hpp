// The frames of lesson 18: the tower's loads sweep by sweep, errors against sweeps, work and time, and what
// moves them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cost.hpp"
#include "lessons/lesson.hpp"

namespace cairn::cost {

using Runs = std::shared_ptr<const CostRun>;

std::vector<Shot> cost_shots(const CostRun& run);

/// Digits, sizes, precision, warm starts; and what depends on the machine.
std::vector<Shot> digit_shots(const Runs& run);
std::vector<Shot> clock_shots(const Runs& run);

/// In the order of CostRun::curves: SI, Jacobi, SOR, momentum.
render::SeriesStyle style_of(const render::Page& page, std::size_t curve);
std::string short_name(const CostRun& run, std::size_t curve);

}  // namespace cairn::cost
