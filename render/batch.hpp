// Collects shapes as triangles: the vertex format of the one shader, cut to the frame, in draw order.
#pragma once

#include <cstdint>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"

namespace cairn::render {

/// How the fragment shader measures coverage; the numbers are known to shader.cpp.
enum class Kind { glyph = 0, box = 1, polygon = 2, hatch = 3 };

/// a x + b y + c of a pixel position.
struct Affine {
  double a = 0, b = 0, c = 0;
};

/// Four measures that vary over a shape, and what is constant on it. Meaning by kind:
///   glyph    local: texel x, y
///   box      local: x, y from the centre; shape: half length, half width, radius; first, second: lines
///            a x + b y + c = 0 across the picture, the box is kept from the first on and up to the second
///   polygon  local: signed distances to up to four edges; shape: interior angles [pi] between edges 01, 12,
///            23, 30; first[0]: the angle between edges 0 and 2
///   hatch    as polygon; second: pitch, half width, phase of the lines
struct Measure {
  Kind kind = Kind::box;
  FixedList<Affine, 4> local = {};
  FixedList<float, 4> shape = {};
  FixedList<float, 3> first = {0, 0, 1};
  FixedList<float, 3> second = {0, 0, -1};
  Color fill = transparent;
  Color outline = transparent;
  double half_outline = 0;  // [px]
};

struct Vertex {
  FixedList<float, 2> position = {};
  FixedList<float, 4> local = {};
  FixedList<float, 4> first_and_kind = {};
  FixedList<float, 4> second_and_half_outline = {};
  FixedList<float, 4> shape = {};
  FixedList<std::uint8_t, 4> fill = {};
  FixedList<std::uint8_t, 4> outline = {};
};

/// Whole pixels; the right and bottom ends are outside.
struct PixelRect {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return left >= right || top >= bottom; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Whole pixels of a frame of that size, the nearest; nothing if the rectangle is not a number.
PixelRect pixels_of(const Rect& rect, int width, int height);
PixelRect intersection(const PixelRect& a, const PixelRect& b);

/// Triangles under one clip: a range of the batch's indices.
struct Draw {
  PixelRect clip = {};
  int first = 0;
  int count = 0;
};

/// Finite, and near enough to the frame to be measured in double.
bool usable(double value);
bool usable(const Point& point);

class Batch {
 public:
  Batch(int width, int height);

  /// Forgets all triangles; the clip stays.
  void clear();
  void set_clip(const PixelRect& clip) { clip_ = clip; }

  /// A shape inside a convex hull that is given in turning order.
  void add(Span<const Point> hull, const Measure& measure);

  const List<Vertex>& vertices() const { return vertices_; }
  const List<std::uint32_t>& indices() const { return indices_; }
  const List<Draw>& draws() const { return draws_; }
  /// Where shapes are kept: the frame and a little around it.
  const Rect& bounds() const { return bounds_; }

 private:
  bool cut_to_bounds(Span<const Point> hull);
  void cut(int axis, double limit, double sign);

  Rect bounds_ = {};
  PixelRect clip_ = {};
  List<Vertex> vertices_ = {};
  List<std::uint32_t> indices_ = {};
  List<Draw> draws_ = {};
  List<Point> hull_ = {};     // the hull being added, cut
  List<Point> scratch_ = {};  // of cut()
};

}  // namespace cairn::render
