// Lesson 20. What it prints, checks and draws.
#pragma once

#include "bill.hpp"
#include "lessons/lesson.hpp"
#include "math/list.hpp"

namespace cairn::needs {

/// Prints all bills and the answer, and checks every claim.
void report(Lesson& lesson, const NeedsRun& all);

CsvTable bills_table(const NeedsRun& all);

/// The scene after so many steps, as the run with sleep sees it.
void draw_scene(render::Page& page, const render::Rect& rect, const NeedsRun& all, int step);

/// The pyramid and the ball at the end of one of the runs.
void draw_pyramid(render::Page& page, const render::Rect& rect, const NeedsRun& all, int run);

/// The question, the bill step by step, all of it, what to take when, and the answer.
List<Shot> needs_shots(const NeedsRun& all);

}  // namespace cairn::needs
