// Lesson 03. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "drift.hpp"
#include "lessons/lesson.hpp"
#include "math/list.hpp"
#include "render/page.hpp"

namespace cairn::drift {

void print_scenes(Lesson& lesson, const DriftRuns& all);
void print_swings(Lesson& lesson, const DriftRuns& all);
void print_hangs(Lesson& lesson, const DriftRuns& all);
void print_balls(Lesson& lesson, const DriftRuns& all);
void print_limits(Lesson& lesson, const DriftRuns& all);
void check_rods(Lesson& lesson, const DriftRuns& all);
void check_balls(Lesson& lesson, const DriftRuns& all);
void check_limits(Lesson& lesson, const DriftRuns& all);
CsvTable balls_table(const DriftRuns& all);

/// Three pendulums, four weights, four balls, and the depth that a ground can hold.
List<Shot> drift_shots(const DriftRuns& all);

using Runs = std::shared_ptr<const DriftRuns>;

/// Their parts, one for each scene, in the order of drift_shots().
List<Shot> swing_shots(const Runs& all);
List<Shot> hang_shots(const Runs& all);
List<Shot> ball_shots(const Runs& all);

/// The step in which the ball with beta = 1 is highest.
int highest_step(const DriftRuns& all);

/// The four balls side by side after `step` steps, with ghosts of the `ghosts` poses before.
void draw_balls(render::Page& page, const render::Rect& rect, const DriftRuns& all, int step, int ghosts);

/// What (7) asked for, what it took, and what came of it, in this step.
void draw_ball_table(render::Page& page, const render::Rect& rect, const DriftRuns& all, int step);
/// Their heights against steps, up to `step`.
void draw_heights(render::Page& page, const render::Rect& rect, const DriftRuns& all, int step);

/// "β = 0.2".
std::string beta_name(double beta);
/// The k-th of up to four curves: one colour, as they are one solver's, told apart by dash and marker.
render::SeriesStyle curve_style(const render::Theme& theme, int k);

}  // namespace cairn::drift
