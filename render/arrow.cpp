// Arrows, friction limits and the key of their scale.
#include "render/arrow.hpp"

#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/text_layout.hpp"

namespace cairn::render {

namespace {

constexpr double shortest_arrow = 8;  // [px] below it a dot
constexpr double dot_radius = 3;      // [px]
constexpr double label_distance = 6;  // [px]

/// One arrow in pixels.
struct ArrowShape {
  Point tail = {0, 0};
  Point tip = {0, 0};
  Point along = {1, 0};   // unit, from tail to tip
  Point across = {0, 1};  // unit
  double length = 0;
  double shaft = 0, head_length = 0, head_width = 0;
  bool cut = false;  // drawn shorter than it is
  Color color = {};
};

Color color_of(const Theme& theme, ArrowKind kind) {
  switch (kind) {
    case ArrowKind::normal:
    case ArrowKind::negative_correction:
      return theme.normal;
    case ArrowKind::friction:
      return theme.friction;
    case ArrowKind::joint:
      return theme.joint;
    case ArrowKind::velocity:
      return theme.velocity;
    case ArrowKind::external:
      return theme.external;
    case ArrowKind::inactive:
      break;
  }
  return theme.inactive;
}

bool is_lit(const Arrow& arrow) { return arrow.active && arrow.kind != ArrowKind::inactive; }

ArrowShape shape_of(const Page& page, const Camera& camera, const ArrowScale& scale, const Arrow& arrow) {
  ArrowShape shape;
  shape.tail = camera.project(arrow.tail);
  const double value = std::hypot(arrow.value.x(), arrow.value.y());
  const double whole = value * scale.pixels_per_unit;
  shape.cut = whole > scale.longest * (1 + 1e-9);  // the largest of a sequence is not cut by a rounding error
  shape.length = shape.cut ? scale.longest : whole;
  if (whole > 0) shape.along = Point(arrow.value.x(), -arrow.value.y()) / value;
  shape.across = perpendicular(shape.along);
  shape.tip = shape.tail + shape.length * shape.along;
  const Sizes& sizes = page.sizes();
  const double thickest = is_lit(arrow) ? sizes.arrow : sizes.inactive_arrow;
  shape.shaft = std::min(thickest, std::max(1.5, shape.length / 10));
  shape.head_length = std::min(sizes.head_length * (is_lit(arrow) ? 1 : 0.7), 0.25 * shape.length);
  // A short head stays wide enough to be seen beside the shaft.
  shape.head_width = std::clamp(shape.head_length * sizes.head_width / sizes.head_length, 3.2 * shape.shaft,
                                std::max(3.2 * shape.shaft, sizes.head_width));
  shape.color = is_lit(arrow) ? color_of(page.theme(), arrow.kind) : page.theme().inactive;
  return shape;
}

void draw_solid(Canvas& canvas, const ArrowShape& shape, const Point& from, const Point& to) {
  const Point side = 0.5 * shape.shaft * shape.across;
  const FixedList<Point, 4> corners = {from - side, to - side, to + side, from + side};
  canvas.polygon(corners, {.fill = shape.color});
}

/// Rungs slanted against the shaft's own direction: hatching at a fixed angle would vanish along it.
void draw_hatched(Canvas& canvas, const ArrowShape& shape, const Point& from, const Point& to) {
  const double half = 0.5 * shape.shaft + 1;
  const Point side = half * shape.across;
  const Stroke line = {.width = 1.25, .color = shape.color, .dash = {}};
  const FixedList<Point, 5> outline = {from - side, to - side, to + side, from + side, from - side};
  canvas.polyline(outline, line);
  const double length = (to - from).norm();
  for (double s = 0; s + 2 * half <= length; s += 4) {
    canvas.line(from + s * shape.along - side, from + (s + 2 * half) * shape.along + side, line);
  }
}

void draw_shaft(Canvas& canvas, const ArrowShape& shape, ArrowKind kind, const Point& from, const Point& to) {
  switch (kind) {
    case ArrowKind::negative_correction:
      return draw_hatched(canvas, shape, from, to);
    case ArrowKind::external:
      // Drawn from the head, so that the head never hangs behind a gap.
      return canvas.line(to, from, {.width = shape.shaft, .color = shape.color, .dash = {8, 6}});
    case ArrowKind::normal:
    case ArrowKind::friction:
    case ArrowKind::joint:
    case ArrowKind::velocity:
    case ArrowKind::inactive:
      break;
  }
  draw_solid(canvas, shape, from, to);
}

void draw_head(Canvas& canvas, const ArrowShape& shape, ArrowKind kind) {
  const Point base = shape.tip - shape.head_length * shape.along;
  const Point side = 0.5 * shape.head_width * shape.across;
  if (kind != ArrowKind::velocity) {
    const FixedList<Point, 3> corners = {base - side, shape.tip, base + side};
    canvas.polygon(corners, {.fill = shape.color});
    return;
  }
  // The stroke's round cap would reach beyond the tip by half its width.
  const double width = std::max(1.5, 0.65 * shape.shaft);
  const Point inset = 0.5 * width * shape.along;
  const FixedList<Point, 3> chevron = {base - side, shape.tip - inset, base + side};
  canvas.polyline(chevron, {.width = width, .color = shape.color, .dash = {}});
}

/// The sign "two slanted strokes" where a piece of the shaft is left out.
void draw_cut_mark(Canvas& canvas, const ArrowShape& shape, const Point& at, double half_gap) {
  const Point slant = (0.5 * shape.shaft + 5) * (shape.across + 0.45 * shape.along);
  for (const double side : {-half_gap, half_gap}) {
    const Point middle = at + side * shape.along;
    canvas.line(middle - slant, middle + slant, {.width = 2, .color = shape.color, .dash = {}});
  }
}

/// A minus beside the shaft, on the side that the label does not take first; for labels without one.
void draw_minus(Canvas& canvas, const ArrowShape& shape) {
  const double sideways = shape.across.x() > 0 || (shape.across.x() == 0 && shape.across.y() < 0) ? -1 : 1;
  const Point middle =
      shape.tail + 0.35 * shape.length * shape.along + sideways * (0.5 * shape.shaft + 10) * shape.across;
  canvas.line(middle - Point(4, 0), middle + Point(4, 0), {.width = 2, .color = shape.color, .dash = {}});
}

void draw_shape(Canvas& canvas, const ArrowShape& shape, ArrowKind kind) {
  if (shape.length < shortest_arrow) {
    canvas.circle(shape.tail, dot_radius, {.fill = shape.color});
    return;
  }
  // An open head lets its shaft run up to the tip.
  const Point end =
      shape.tip - (kind == ArrowKind::velocity ? 0.5 * shape.shaft : shape.head_length) * shape.along;
  if (shape.cut) {
    const double half_gap = 3;
    const Point at = shape.tail + 0.62 * shape.length * shape.along;
    draw_shaft(canvas, shape, kind, shape.tail, at - half_gap * shape.along);
    draw_shaft(canvas, shape, kind, at + half_gap * shape.along, end);
    draw_cut_mark(canvas, shape, at, half_gap);
  } else {
    draw_shaft(canvas, shape, kind, shape.tail, end);
  }
  draw_head(canvas, shape, kind);
}

/// Whether the label already tells a number, other than an index such as the 2 of λ_2.
bool has_number(const std::string& label) {
  char before = ' ';
  for (const char letter : label) {
    const bool is_digit = letter >= '0' && letter <= '9';
    if (is_digit && before != '_' && before != '{' && before != '^') return true;
    before = letter;
  }
  return false;
}

std::string label_of(const ArrowScale& scale, const Arrow& arrow, bool cut) {
  if (!cut || has_number(arrow.label)) return arrow.label;
  std::string number = significant(std::hypot(arrow.value.x(), arrow.value.y()));
  if (!scale.unit.empty()) number += " " + scale.unit;
  return arrow.label.empty() ? number : arrow.label + " = " + number;
}

TextStyle label_style(const Page& page, const ArrowShape& shape, bool lit) {
  TextStyle style = page.value();
  style.align = Align::center;
  style.halo = page.theme().background;
  if (!lit) style.color = page.theme().secondary_text;
  if (!lit || page.compact()) return style;
  style.size = std::max(style.size, large_text);
  style.bold = true;
  style.color = shape.color;
  return style;
}

/// Base lines, centred, of a text beside the arrow: right (or above) of its middle, on the other side, beyond
/// the tip, before the tail, and beside both ends.
List<Point> label_places(const ArrowShape& shape, double width, const TextStyle& style) {
  Point side = shape.across;
  if (side.x() < -1e-9 || (std::abs(side.x()) <= 1e-9 && side.y() > 0)) side = -side;
  const double height = style.size;
  const double body = std::max(0.5 * std::max(shape.head_width, shape.shaft), dot_radius) + label_distance;
  const auto reach = [&](const Point& direction) {
    return 0.5 * width * std::abs(direction.x()) + 0.5 * height * std::abs(direction.y());
  };
  const Point out = (body + reach(side)) * side;
  const Point ahead = (label_distance + reach(shape.along)) * shape.along;
  const Point first = shape.tail + 0.2 * shape.length * shape.along;
  const Point middle = shape.tail + 0.5 * shape.length * shape.along;
  const Point last = shape.tail + 0.8 * shape.length * shape.along;
  List<Point> places = {middle + out, middle - out, shape.tip + ahead, shape.tail - ahead,
                        last + out,   last - out,   first + out,       first - out};
  for (Point& place : places)
    place = Point(std::round(place.x()), std::round(baseline_around(place.y(), height)));
  return places;
}

}  // namespace

ArrowScale arrow_scale(double largest, const std::string& unit, const Camera& camera) {
  ArrowScale scale;
  scale.unit = unit;
  scale.longest = 0.35 * camera.viewport.height;
  if (largest > 0 && std::isfinite(largest)) scale.pixels_per_unit = scale.longest / largest;
  return scale;
}

void draw_arrow(Page& page, const Camera& camera, const ArrowScale& scale, const Arrow& arrow) {
  const ArrowShape shape = shape_of(page, camera, scale, arrow);
  if (!shape.tail.allFinite() || !shape.tip.allFinite()) return;
  draw_shape(page.canvas(), shape, arrow.kind);
  const bool is_signed = arrow.label.starts_with("−");
  if (arrow.kind == ArrowKind::negative_correction && !is_signed && shape.length >= shortest_arrow)
    draw_minus(page.canvas(), shape);
  page.avoid({shape.tail, shape.tip});
  const std::string label = label_of(scale, arrow, shape.cut);
  if (label.empty()) return;
  const TextStyle style = label_style(page, shape, is_lit(arrow));
  const double width = page.canvas().text_width(label, style);
  page.place_text(label_places(shape, width, style), camera.viewport, label, style);
}

void draw_friction_limit(Page& page, const Camera& camera, const ArrowScale& scale, const Vec2<double>& tail,
                         const Vec2<double>& direction, double limit) {
  const Point start = camera.project(tail);
  const Point along = Point(direction.x(), -direction.y()).normalized();
  const double reach = limit * scale.pixels_per_unit;
  if (!start.allFinite() || !along.allFinite() || !std::isfinite(reach)) return;
  const Point side = (0.5 * page.sizes().head_width + 3) * perpendicular(along);
  const double leg = 0.35 * page.sizes().head_length;
  const double width = page.compact() ? 1.5 : 2;
  for (const double sign : {-1.0, 1.0}) {
    const Point end = start + sign * reach * along;
    const Point inward = -sign * leg * along;
    const FixedList<Point, 4> bracket = {end - side + inward, end - side, end + side, end + side + inward};
    page.canvas().polyline(bracket, {.width = width, .color = page.theme().friction, .dash = {}});
  }
}

void draw_scale_key(Page& page, const ArrowScale& scale, const Point& corner) {
  const double room = page.compact() ? 60 : 100;  // [px]
  const double most = room / scale.pixels_per_unit;
  if (!(most > 0) || !std::isfinite(most)) return;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  double value = decade;
  for (const double factor : {2.0, 5.0}) {
    if (factor * decade <= most * (1 + 1e-9)) value = factor * decade;
  }
  const double length = value * scale.pixels_per_unit;
  const double tick = 4;
  const double y = std::round(corner.y() - tick) - 0.5;
  const Stroke stroke = {.width = page.compact() ? 1.5 : 2, .color = page.theme().secondary_text, .dash = {}};
  page.canvas().line({corner.x(), y}, {corner.x() + length, y}, stroke);
  for (const double x : {corner.x(), corner.x() + length}) {
    page.canvas().line({x, y - tick}, {x, y + tick}, stroke);
  }
  std::string text = significant(value);
  if (!scale.unit.empty()) text += " " + scale.unit;
  TextStyle style = page.tick();
  page.canvas().text({corner.x() + length + 8, std::round(baseline_around(y, style.size))}, text, style);
}

void draw_length(Page& page, const Point& from, const Point& to, const Stroke& stroke) {
  const Point along = (to - from).normalized();
  const Point tick = 6 * Point(-along.y(), along.x());
  page.canvas().line(from, to, stroke);
  for (const Point& end : {from, to}) page.canvas().line(end - tick, end + tick, stroke);
}

}  // namespace cairn::render
