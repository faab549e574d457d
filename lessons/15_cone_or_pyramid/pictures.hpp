// The frames of lesson 15: one row at a time in the first step, then the slide, then all directions.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "slide.hpp"

namespace cairn::top_view {

std::vector<Shot> slide_shots(const Slides& all);

}  // namespace cairn::top_view
