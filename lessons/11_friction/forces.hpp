// Lesson 11. Forces on the block, drawn on the left half of a page.
#pragma once

#include "render/camera.hpp"
#include "render/page.hpp"
#include "study.hpp"

namespace cairn::friction {

/// Scene on the left, two panels on the right.
struct Layout {
  render::Rect scene, upper, lower, right;
};

Layout layout_of(const render::Page& page);

/// All of the slope, and the block upon it.
render::Camera camera_of(const render::Rect& viewport, const Slope& slope);

/// The block with what pulls it down the slope, what carries it and what holds it, and how far the latter may
/// go.
void draw_forces(render::Page& page, const Slide& slide, const Study& study);

/// The forces of both corners, each with its bracket.
void draw_corners(render::Page& page, const Slide& slide, const Study& study);

}  // namespace cairn::friction
