// The frames of lesson 08: one for each row update of the first sweep, then one for each sweep.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "twice.hpp"

namespace cairn::twice {

std::vector<Shot> twice_shots(const TwiceRun& run);

}  // namespace cairn::twice
