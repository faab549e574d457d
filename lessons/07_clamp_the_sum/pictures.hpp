// The frames of lesson 07: visit by visit with both clamps side by side, what becomes of the box, and why.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "feet.hpp"
#include "lessons/lesson.hpp"
#include "render/page.hpp"

namespace cairn::feet {

using Run = std::shared_ptr<const FeetRun>;

std::vector<Shot> feet_shots(const FeetRun& run);

/// Its parts: the visits of scene A; what comes after.
std::vector<Shot> visit_shots(const Run& run);
std::vector<Shot> motion_shots(const Run& run);
Shot spread_shot(const Run& run);
Shot side_shot(const Run& run);

/// What a box shows: sums and what was given last, and how fast its feet move.
struct BoxView {
  Pair impulse = {};        // [N s]
  int foot = -1;            // the one that was visited last; -1: none
  double before = 0;        // [N s] its sum before
  Pair foot_velocity = {};  // [m/s] upwards
  double fastest = 10;      // [m/s] of all that is shown
};
void draw_box(render::Page& page, const render::Rect& rect, const BoxRun& box, double largest,
              const BoxView& view);
BoxView view_after(const BoxRun& box, double speed, const Landing& landing, std::size_t visit);

/// A panel with a bar in the colour of what is clamped on top, and its name. Returns what is free inside.
render::Rect clamp_panel(render::Page& page, const render::Rect& rect, Clamped clamped);
render::SeriesStyle style_of(const render::Theme& theme, Clamped clamped);

}  // namespace cairn::feet
