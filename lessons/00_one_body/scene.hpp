// Lesson 00. What the frames share: the page's parts, the flight so far, and its error.
#pragma once

#include <string>

#include "flight.hpp"
#include "parts.hpp"

namespace cairn::one_body {

/// What all frames share.
struct Story {
  Flight flight = {};
  Convergence convergence = {};
  std::string question = {};
  double fastest = 0;  // [m/s] of the whole flight: one scale for all arrows
};

/// The page in two columns, the right one in two panels; a compact page has room for one panel there.
struct Layout {
  render::Rect scene, upper, lower;
};

Layout layout_of(const render::Page& page);

/// The box at `step` with up to seven earlier outlines and the three paths so far.
void draw_scene(render::Page& page, const Story& story, int step);

/// Height above the parabola over time, up to `step`.
void draw_errors(render::Page& page, const render::Rect& rect, const Story& story, int step);

}  // namespace cairn::one_body
