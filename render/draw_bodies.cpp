// Bodies: fill, outline, hatch, orientation mark, and the number in the middle.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/draw_parts.hpp"
#include "render/rects.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr double cut = 12;  // [px] beyond the viewport, where cut edges are not seen

Rect grown(const Rect& rect, double by) { return inset(rect, -by); }

bool is_active(BodyId id, const WorldLook& look) { return id == look.active_a || id == look.active_b; }

Color fill_of(const Theme& theme, const SnapshotBody& body, BodyId id, const WorldLook& look) {
  if (id == look.active_a) return theme.active_a;
  if (id == look.active_b) return theme.active_b;
  return body.awake ? theme.body : theme.sleeping;
}

// Of the ground only what looks up is drawn: it has no visible end.
void draw_surface(Canvas& canvas, const Outline& outline, const Stroke& stroke) {
  Point middle(0, 0);
  for (const Point& point : outline) middle += point / static_cast<double>(outline.size());
  for (int i = 0; i < outline.size(); ++i) {
    const Point& from = outline[i];
    const Point& to = outline[(i + 1) % outline.size()];
    const Point edge = to - from;
    Point outward(edge.y(), -edge.x());
    if (outward.dot(from - middle) < 0) outward = -outward;
    if (-outward.y() > 0.1 * outward.norm()) canvas.line(from, to, stroke);
  }
}

/// `with_edges`: no piece of an outline, whose edges are drawn once all pieces are.
void draw_static_shape(Page& page, const Outline& outline, BodyId id, bool with_edges) {
  Canvas& canvas = page.canvas();
  const Theme& theme = page.theme();
  const Paint edge{.outline = theme.outline, .outline_width = page.sizes().outline};
  canvas.polygon(outline, {.fill = theme.static_body});
  canvas.hatch(outline, {.width = 1, .color = theme.static_hatch}, page.sizes().hatch_pitch);
  if (!with_edges) return;
  if (id != ground) {
    canvas.polygon(outline, edge);
  } else {
    draw_surface(canvas, outline, {.width = page.sizes().outline, .color = theme.outline});
  }
}

bool has_pieces(const SnapshotBody& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(), is_piece);
}

// The half diagonal of a text of 1 px.
double text_reach(const Page& page, const std::string& name) {
  const TextStyle style{.size = 100, .bold = true};
  return std::hypot(page.canvas().text_width(name, style) / 200, cap_height / 2);
}

// Whether a text with this middle is inside the body, wherever the body is turned to.
bool fits(const Camera& camera, const SnapshotBody& body, const Point& middle, double width, double height) {
  constexpr double air = 3;  // [px]
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const Point corner = middle + Point(x * width, y * height);
      const Vec2<double> local = body.pose.local(camera.unproject(corner));
      if (!(depth_in(body, local) * camera.scale > air)) return false;
    }
  }
  return true;
}

// A circle shows how far it has turned by a radius, everything else by a short tick at its local x axis.
void draw_orientation(Page& page, const Camera& camera, const SnapshotBody& body, double name) {
  const bool is_circle = body.shapes.size() == 1 && std::holds_alternative<Circle<double>>(body.shapes[0]);
  const Vec2<double> along(1, 0);
  const double edge = reach(body, along) * camera.scale;  // [px]
  const double number = name > 0 ? name + 12 : 0;         // [px] kept free: a tick at a number is no minus
  const double inner = is_circle ? number : std::max(number, edge - std::clamp(0.18 * edge, 4.0, 10.0));
  if (!(edge - inner > 4)) return;
  const Point from = camera.project(body.pose.world(along * (edge / camera.scale)));
  const Point to = camera.project(body.pose.world(along * (inner / camera.scale)));
  const double width = is_circle ? page.sizes().outline : 0.75 * page.sizes().outline;
  page.canvas().line(from, to, {.width = width, .color = page.theme().outline});
  page.avoid({from, to});  // beside a number it would read as a sign
}

/// What is seen to touch and does not push.
void draw_sensor(Page& page, const Camera& camera, const SnapshotBody& body) {
  const Stroke stroke{.width = page.sizes().outline, .color = page.theme().secondary_text, .dash = {6, 5}};
  for (const Shape<double>& shape : body.shapes) {
    Outline outline = clipped(outline_of(camera, body.pose, shape), grown(camera.viewport, cut));
    if (outline.empty()) continue;
    outline.push_back(outline.front());
    page.canvas().polyline(outline, stroke);
  }
}

}  // namespace

std::string name_of(const WorldLook& look, BodyId body) {
  if (!look.numbers) return "";
  if (look.names.empty()) return std::to_string(body.index);
  const bool is_named = body.index >= 0 && body.index < look.names.size();
  return is_named ? look.names[body] : "";
}

double name_size(const Page& page, const Camera& camera, const SnapshotBody& body, const std::string& name) {
  if (name.empty()) return 0;
  const double room = depth_in(body, Vec2<double>(0, 0)) * camera.scale;
  const double reach_of_text = text_reach(page, name);
  // The same at every angle, so that it does not flicker while the body turns.
  const double size = std::min(std::floor(0.62 * room / reach_of_text), page.sizes().body_number);
  const double smallest = page.sizes().smallest;
  if (size >= smallest) return size;
  const double width = page.canvas().text_width(name, {.size = smallest, .bold = true});
  const Point middle = camera.project(body.pose.position);
  return fits(camera, body, middle, width, cap_height * smallest) ? smallest : 0;
}

void draw_static_body(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id) {
  if (!has_place(camera, body.pose)) return;
  if (body.sensor) return draw_sensor(page, camera, body);
  const Paint line{.outline = page.theme().outline, .outline_width = page.sizes().outline};
  for (const Shape<double>& shape : body.shapes) {
    if (is_line(shape)) {
      paint_shape(page.canvas(), camera, body.pose, shape, line);
      continue;
    }
    const Outline seen = clipped(outline_of(camera, body.pose, shape), grown(camera.viewport, cut));
    if (seen.size() > 2) draw_static_shape(page, seen, id, !is_piece(shape));
  }
  if (has_pieces(body))
    draw_outlines(page.canvas(), camera, body, {.width = line.outline_width, .color = line.outline});
}

void draw_dynamic_body(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id,
                       const WorldLook& look) {
  if (!is_seen(camera, body)) return;
  Canvas& canvas = page.canvas();
  const Color fill = fill_of(page.theme(), body, id, look);
  const Color line = body.awake ? page.theme().outline : page.theme().inactive;
  const double width = is_active(id, look) ? page.sizes().active_outline : page.sizes().outline;
  const bool is_compound = body.shapes.size() > 1;
  // All outlines of a compound first, twice as wide; then the fills upon their inner halves.
  const Paint first{.fill = fill, .outline = line, .outline_width = is_compound ? 2 * width : width};
  for (const Shape<double>& shape : body.shapes) {
    if (!is_piece(shape)) paint_shape(canvas, camera, body.pose, shape, first);
  }
  if (is_compound) {
    const Paint second{.fill = fill, .outline = fill, .outline_width = 1};  // no seam between two pieces
    for (const Shape<double>& shape : body.shapes) {
      if (!is_line(shape)) paint_shape(canvas, camera, body.pose, shape, second);
    }
  }
  if (has_pieces(body)) draw_outlines(canvas, camera, body, {.width = width, .color = line});
  const std::string name = name_of(look, id);
  const double size = name_size(page, camera, body, name);
  if (!has_pieces(body))
    draw_orientation(page, camera, body, size * (name.empty() ? 0 : text_reach(page, name)));
}

void write_name(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id,
                const WorldLook& look) {
  if (!is_seen(camera, body)) return;
  const std::string name = name_of(look, id);
  const double size = name_size(page, camera, body, name);
  if (size == 0) return;
  const TextStyle style{.size = size,
                        .color = page.theme().text,
                        .bold = true,
                        .align = Align::center,
                        .halo = fill_of(page.theme(), body, id, look)};
  const Point middle = camera.project(body.pose.position);
  const List<Point> place = {Point(middle.x(), baseline_around(middle.y(), size))};
  if (!write_if_free(page, place, camera.viewport, name, style) || !is_active(id, look)) return;
  // Which of the two it is, not by its colour alone.
  TextStyle rank = style;
  rank.bold = false;
  rank.size = std::max(page.sizes().smallest, std::floor(0.55 * size));
  const Point below = middle + Point(0, 0.5 * cap_height * size + 0.75 * rank.size);
  const std::string letter = id == look.active_a ? "a" : "b";
  // In a picture that has a vector b, too, "b" alone would be taken for it.
  for (const std::string& text : {"body " + letter, letter}) {
    if (!fits(camera, body, below, page.canvas().text_width(text, rank) + 8, 0.8 * rank.size)) continue;
    const List<Point> under = {Point(below.x(), baseline_around(below.y(), rank.size))};
    if (write_if_free(page, under, camera.viewport, text, rank)) return;
  }
}

bool write_if_free(Page& page, const List<Point>& places, const Rect& within, const std::string& text,
                   const TextStyle& style) {
  List<Point> free;
  for (const Point& at : places) {
    const Rect rect = text_rect(page.canvas(), at, text, style);
    const auto boxes = page.canvas().text_boxes();
    const bool is_taken = std::any_of(boxes.begin(), boxes.end(),
                                      [&rect](const TextBox& box) { return overlap(box.rect, rect); });
    if (!is_taken && contains(within, rect)) free.push_back(at);
  }
  if (free.empty()) return false;
  page.place_text(free, within, text, style);
  return true;
}

}  // namespace cairn::render
