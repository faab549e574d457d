// Turns shapes into hulls and measures for a batch. Whatever is not usable() is left out.
#pragma once

#include <cairn/math/list.hpp>
#include "render/batch.hpp"

namespace cairn::render {

/// A box around `center` that lies along a unit `axis`, grown by `radius`: circle, capsule and rounded
/// rectangle.
struct Box {
  Point center = Point::Zero();
  Point axis = Point::UnitX();
  double half_length = 0;  // along the axis [px]
  double half_width = 0;   // across it [px]
  double radius = 0;       // [px]
};

void add_box(Batch& batch, const Box& box, const Paint& paint);
void add_polygon(Batch& batch, Span<const Point> points, const Paint& paint, double rounding);
void add_hatch(Batch& batch, Span<const Point> points, const Stroke& stroke, double pitch);
/// Ends are cut straight at the end points; inner points are joined round. Points that are not usable break
/// it.
void add_polyline(Batch& batch, Span<const Point> points, const Stroke& stroke);
/// A rectangle of texels at whole pixels.
void add_glyph(Batch& batch, const PixelRect& target, int texel_x, int texel_y, const Color& color);

/// The outline's half width [px], zero where it would not be seen.
double half_outline(const Paint& paint);

/// The parts of a polyline that a dash pattern draws; parts far outside the frame are left out.
List<List<Point>> dashes(Span<const Point> points, Span<const double> pattern, const Rect& bounds);

}  // namespace cairn::render
