// Rectangles in pixels: what meets what, and others made of them.
#pragma once

#include "render/canvas.hpp"

namespace cairn::render {

bool overlap(const Rect& a, const Rect& b);
bool contains(const Rect& outer, const Rect& inner);
bool contains(const Rect& outer, const Point& point);
/// The rectangle around both.
Rect united(const Rect& a, const Rect& b);
/// Its lengths and its place by a factor.
Rect scaled(const Rect& rect, double by);

struct LineSegment {
  Point from = {0, 0};
  Point to = {0, 0};
};

/// Narrows the segment to what of it is inside. False if nothing is.
bool clip(LineSegment& segment, const Rect& rect);

}  // namespace cairn::render
