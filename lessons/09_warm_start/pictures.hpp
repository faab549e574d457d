// The frames of lesson 09: three towers side by side, what the error does, and rows in another order.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "start.hpp"

namespace cairn::warm {

std::vector<Shot> start_shots(const WarmStart& all);

/// Their last part: charts of the error, and what becomes of impulses in the wrong place.
std::vector<Shot> order_shots(const WarmStart& all);

}  // namespace cairn::warm
