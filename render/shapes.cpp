// Boxes, circles, capsules and glyphs.
#include "render/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace cairn::render {
namespace {

constexpr double smallest_radius = 0.5;  // [px]

/// A disk below one pixel keeps its area by opacity: the distance measure would make it too dark.
Box not_too_small(const Box& box, Color& fill) {
  Box grown = box;
  const double radius = box.radius + std::min(box.half_length, box.half_width);
  if (radius < smallest_radius && box.half_length == 0 && box.half_width == 0) {
    const double part = radius / smallest_radius;
    // The measure itself gives pi (r^2 + 1/12): at r = 1/2 that is 4/3 too much.
    fill.a *= static_cast<float>(part * part * 0.75);
    grown.radius = smallest_radius;
  }
  return grown;
}

}  // namespace

double half_outline(const Paint& paint) {
  return paint.outline.a > 0 && paint.outline_width > 0 && usable(paint.outline_width)
             ? 0.5 * paint.outline_width
             : 0;
}

void add_box(Batch& batch, const Box& box, const Paint& paint) {
  const bool sound = usable(box.center) && usable(box.half_length) && usable(box.half_width) &&
                     usable(box.radius) && box.half_length >= 0 && box.half_width >= 0 && box.radius >= 0;
  const double rim = half_outline(paint);
  if (!sound || (paint.fill.a <= 0 && rim <= 0)) {
    return;
  }
  Measure measure = {};
  measure.fill = paint.fill;
  measure.outline = paint.outline;
  measure.half_outline = rim;
  const Box grown = rim > 0 ? box : not_too_small(box, measure.fill);
  const Point& x = grown.axis;
  const Point y = perpendicular(x);
  measure.kind = Kind::box;
  measure.local[0] = {x.x(), x.y(), -x.dot(grown.center)};
  measure.local[1] = {y.x(), y.y(), -y.dot(grown.center)};
  measure.shape = {static_cast<float>(grown.half_length), static_cast<float>(grown.half_width),
                   static_cast<float>(grown.radius), 0};
  const double margin = grown.radius + rim + 1;
  const Point along = (grown.half_length + margin) * x;
  const Point across = (grown.half_width + margin) * y;
  const FixedList<Point, 4> hull = {grown.center - along - across, grown.center + along - across,
                                    grown.center + along + across, grown.center - along + across};
  batch.add(hull, measure);
}

void add_glyph(Batch& batch, const PixelRect& target, int texel_x, int texel_y, const Color& color) {
  Measure measure = {};
  measure.kind = Kind::glyph;
  measure.fill = color;
  measure.local[0] = {1, 0, static_cast<double>(texel_x - target.left)};
  measure.local[1] = {0, 1, static_cast<double>(texel_y - target.top)};
  const double left = target.left;
  const double top = target.top;
  const double right = target.right;
  const double bottom = target.bottom;
  const FixedList<Point, 4> hull = {Point(left, top), Point(right, top), Point(right, bottom),
                                    Point(left, bottom)};
  batch.add(hull, measure);
}

}  // namespace cairn::render
