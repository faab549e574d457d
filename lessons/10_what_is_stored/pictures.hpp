// The frames of lesson 10: which rows meet, the pattern of A, pairs on which (30) errs, and what it all
// costs.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "stored.hpp"

namespace cairn::stored {

std::vector<Shot> stored_shots(const StoredRun& run);

/// Their parts: pairs of rows for which (30) and A disagree, and charts.
std::vector<Shot> case_shots(const StoredRun& run);
std::vector<Shot> cost_shots(const StoredRun& run);

}  // namespace cairn::stored
