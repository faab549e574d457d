// Lesson 07. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "feet.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "render/page.hpp"

namespace cairn::feet {

/// The question of the card with the numbers of this landing.
std::string question_of(const FeetRun& run);

void tell_scene(Lesson& lesson, const FeetRun& run);
void tell_visits(Lesson& lesson, const FeetRun& run);
void tell_landings(Lesson& lesson, const FeetRun& run);
void tell_motion(Lesson& lesson, const FeetRun& run);
void check_claims(Lesson& lesson, const FeetRun& run);
CsvTable table_of(const FeetRun& run);

/// Visit by visit with both clamps side by side, what becomes of the box, and why.
List<Shot> feet_shots(const FeetRun& run);

using Run = std::shared_ptr<const FeetRun>;

/// Their part that comes after the visits of scene A.
List<Shot> motion_shots(const Run& run);
Shot spread_shot(const Run& run);
Shot side_shot(const Run& run);

/// What a box shows: sums and what was given last, and how fast its feet move.
struct BoxView {
  Pair impulse = {};        // [N s]
  int foot = -1;            // the one that was visited last; -1: none
  double before = 0;        // [N s] its sum before
  Pair foot_velocity = {};  // [m/s] upwards
  double fastest = 10;      // [m/s] of all that is shown
  bool asks = false;        // with a question mark at the left foot
};
void draw_box(render::Page& page, const render::Rect& rect, const BoxRun& box, double largest,
              const BoxView& view);

/// A panel with a bar in the colour of what is clamped on top, and its name, or another
/// one. Returns what is free inside.
render::Rect clamp_panel(render::Page& page, const render::Rect& rect, Clamped clamped,
                         const std::string& name = "");
render::SeriesStyle style_of(const render::Theme& theme, Clamped clamped);

}  // namespace cairn::feet
