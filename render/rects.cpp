// Rectangles in pixels: what meets what, and others made of them.
#include "render/rects.hpp"

#include <algorithm>

namespace cairn::render {
namespace {

// Narrows the part [enter, leave] of a segment to where one coordinate lies between low and high.
bool narrow(double from, double run, double low, double high, double& enter, double& leave) {
  if (run == 0) return from >= low && from <= high;
  enter = std::max(enter, ((run > 0 ? low : high) - from) / run);
  leave = std::min(leave, ((run > 0 ? high : low) - from) / run);
  return enter <= leave;
}

}  // namespace

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool contains(const Rect& outer, const Rect& inner) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

bool contains(const Rect& outer, const Point& point) {
  return point.x() >= outer.x && point.x() <= outer.x + outer.width && point.y() >= outer.y &&
         point.y() <= outer.y + outer.height;
}

bool clip(LineSegment& segment, const Rect& rect) {
  const Point from = segment.from;
  const Point run = segment.to - segment.from;
  double enter = 0;
  double leave = 1;
  if (!narrow(from.x(), run.x(), rect.x, rect.x + rect.width, enter, leave)) return false;
  if (!narrow(from.y(), run.y(), rect.y, rect.y + rect.height, enter, leave)) return false;
  if (enter > 0) segment.from = from + enter * run;
  if (leave < 1) segment.to = from + leave * run;
  return true;
}

Rect united(const Rect& a, const Rect& b) {
  const double x = std::min(a.x, b.x);
  const double y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

Rect scaled(const Rect& rect, double by) {
  return {by * rect.x, by * rect.y, by * rect.width, by * rect.height};
}

}  // namespace cairn::render
