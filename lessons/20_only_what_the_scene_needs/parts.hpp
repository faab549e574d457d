// Lesson 20. What it prints, checks and draws.
#pragma once

#include <string>

#include "bill.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"

namespace cairn::needs {

/// Prints all bills and the answer, and checks every claim.
void report(Lesson& lesson, const NeedsRun& all);

CsvTable bills_table(const NeedsRun& all);

/// The scene of a run after so many steps, and a line above each island.
struct SceneView {
  std::string title = {};
  int run = by_islands;
  int step = 0;
  List<std::string> lines = {};
};
void draw_scene(render::Page& page, const render::Rect& rect, const NeedsRun& all, const SceneView& view);

/// "40 rows × 50 sweeps": what each island takes in a step; before the first step only its rows.
List<std::string> swept_lines(const NeedsRun& all, int run, int step);

/// How far a body ends from where it should be [m], and the box for which that is most.
double off_at_end(const NeedsRun& all, int run, BodyId body);
BodyId farthest_box(const NeedsRun& all, int run);

/// The pyramid and the ball at the end of one of the runs.
void draw_pyramid(render::Page& page, const render::Rect& rect, const NeedsRun& all, int run);

/// The question, the bill step by step, all of it, what to take when, and the answer.
List<Shot> needs_shots(const NeedsRun& all);

}  // namespace cairn::needs
