// The frames of lesson 14: the row and its numbers, then every step of the fall.
#pragma once

#include <vector>

#include "falls.hpp"
#include "lessons/lesson.hpp"

namespace cairn::pulley {

std::vector<Shot> pulley_shots(const PulleyRuns& all);

}  // namespace cairn::pulley
