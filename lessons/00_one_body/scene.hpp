// Lesson 00. The flight so far, where its three methods are, and how far they miss.
#pragma once

#include "parts.hpp"
#include "render/page.hpp"

namespace cairn::one_body {

/// What all frames share.
struct Story {
  Flight flight = {};
  Convergence convergence = {};
  double fastest = 0;  // [m/s] of the whole flight: one scale for all arrows
};

struct SceneLook {
  int step = 0;
  bool velocity = true;  // the arrow
  bool asks = false;     // marks the height that the question is about
};

/// The box with up to seven earlier outlines and the paths so far; once they part, their ends enlarged.
void draw_scene(render::Page& page, const render::Rect& rect, const Story& story, const SceneLook& look);

/// Height above the parabola over time, up to `step`.
void draw_errors(render::Page& page, const render::Rect& rect, const Story& story, int step);

}  // namespace cairn::one_body
