// The frames of lesson 09: three towers side by side, what the error does, and rows in another order.
#pragma once

#include <array>
#include <vector>

#include "lessons/lesson.hpp"
#include "render/theme.hpp"
#include "start.hpp"

namespace cairn::warm {

std::vector<Shot> start_shots(const WarmStart& all);

/// Their last part: charts of the error, and what becomes of impulses in the wrong place.
std::vector<Shot> order_shots(const WarmStart& all);

/// Cold, warm, and a guess in the wrong place. All three are SI: the right ones have its colour, and only the
/// dash tells them apart; the mistake has the colour of mistakes, as in lesson 07.
std::array<render::SeriesStyle, 3> start_styles(const render::Theme& theme);

}  // namespace cairn::warm
