// Lesson 11. Forces on the block, drawn upon the slope.
#pragma once

#include "render/camera.hpp"
#include "render/page.hpp"
#include "study.hpp"

namespace cairn::friction {

/// The block with what pulls it down the slope, what carries it and what holds it, and how far the latter may
/// go.
void draw_forces(render::Page& page, const render::Rect& rect, const Slide& slide);

/// What is drawn at the two corners.
enum class Corners { asked, solved };
/// The block's weight and the friction of both corners: as a question, or with its bracket and the load.
void draw_corners(render::Page& page, const render::Rect& rect, const Slide& slide, Corners corners);

}  // namespace cairn::friction
