// The frames of lesson 03: three pendulums, four weights, four balls, and the depth that a ground can hold.
#pragma once

#include <string>
#include <vector>

#include "drift.hpp"
#include "lessons/lesson.hpp"
#include "render/page.hpp"

namespace cairn::drift {

std::vector<Shot> drift_shots(const DriftRuns& all);

/// Their parts, one for each scene, in the order of drift_shots().
std::vector<Shot> swing_shots(const DriftRuns& all);
std::vector<Shot> hang_shots(const DriftRuns& all);
std::vector<Shot> ball_shots(const DriftRuns& all);

/// The four balls side by side after `step` steps, with ghosts of the `ghosts` poses before.
void draw_balls(render::Page& page, const render::Rect& rect, const DriftRuns& all, int step, int ghosts);

/// What (7) asked for, what it took, and what came of it, in this step.
void draw_ball_table(render::Page& page, const render::Rect& rect, const DriftRuns& all, int step);
/// Their heights against steps, up to `step`.
void draw_heights(render::Page& page, const render::Rect& rect, const DriftRuns& all, int step);

/// "β = 0.2".
std::string beta_name(double beta);
/// The k-th of up to four curves: one colour, as they are one solver's, told apart by dash and marker.
render::SeriesStyle curve_style(const render::Theme& theme, std::size_t k);

}  // namespace cairn::drift
