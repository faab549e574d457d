// The frames of lesson 20.
#pragma once

#include <vector>

#include "bill.hpp"
#include "lessons/lesson.hpp"

namespace cairn::needs {

/// The scene after so many steps, as the run with sleep sees it.
void draw_scene(render::Page& page, const render::Rect& rect, const NeedsRun& all, std::size_t step);

/// The question, the bill step by step, all of it, what to take when, and the answer.
std::vector<Shot> needs_shots(const NeedsRun& all);

}  // namespace cairn::needs
