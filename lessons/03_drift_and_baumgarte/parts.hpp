// Lesson 03. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "drift.hpp"
#include "lessons/kit/lesson.hpp"
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

/// What is drawn of the balls.
struct BallLook {
  int step = 0;           // with outlines of all the steps before
  bool asks = false;      // how deep the balls are, and that we ask how high the one with beta = 1 comes
  bool measured = false;  // how high it is
};
/// The four balls side by side, in a panel.
void draw_balls(render::Page& page, const render::Rect& rect, const DriftRuns& all, const BallLook& look);

/// "β = 0.2".
std::string beta_name(double beta);
/// Each beta has one colour and dash in all pictures.
render::SeriesStyle beta_style(const render::Theme& theme, double beta);

}  // namespace cairn::drift
