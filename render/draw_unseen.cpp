// What of a world its picture does not show: bodies beyond its border, too small to be seen, or nowhere.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/draw_parts.hpp"
#include "render/rects.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr int most_announced = 4;    // bodies beyond the border that are named
constexpr int most_ringed = 6;       // where more bodies are too small, they are counted
constexpr double least_seen = 1;     // [px] radius
constexpr double ring_radius = 9;    // [px]
constexpr double border_rim = 4;     // [px] kept free along the border
constexpr double border_arrow = 13;  // [px] length of an arrow at the border

/// Bodies by what hides them.
struct Unseen {
  List<BodyId> outside = {};
  List<BodyId> tiny = {};
  List<BodyId> nowhere = {};  // without a position, or turned by no number
};

double largest_radius(const SnapshotBody& body) {
  double largest = 0;
  for (const Shape<double>& shape : body.shapes) largest = std::max(largest, bounding_radius(shape));
  return largest;
}

Unseen unseen_of(const Camera& camera, const Snapshot& snapshot) {
  Unseen unseen;
  for (const BodyId id : snapshot.bodies.indices()) {
    const SnapshotBody& body = snapshot.bodies[id];
    if (body.type != BodyType::dynamic || body.shapes.empty()) continue;
    if (!body.pose.position.allFinite() || !std::isfinite(body.pose.angle)) {
      unseen.nowhere.push_back(id);
    } else if (!is_seen(camera, body)) {
      unseen.outside.push_back(id);
    } else if (largest_radius(body) * camera.scale < least_seen) {
      unseen.tiny.push_back(id);
    }
  }
  return unseen;
}

/// The body's own name, or "body 7". What markup would read as a subscript is taken literally.
std::string spoken_name(const WorldLook& look, BodyId id) {
  if (id.index >= look.names.size() || look.names[id].empty()) return "body " + std::to_string(id.index);
  std::string name;
  for (const char letter : look.names[id]) {
    if (letter == '_' || letter == '^') name += '\\';
    name += letter;
  }
  return name;
}

TextStyle unseen_style(const Page& page) {
  TextStyle style = page.label();
  style.size = std::max(page.sizes().smallest, std::round(0.85 * style.size));
  style.halo = page.theme().panel;
  return style;
}

/// Where the ray from the middle of a rectangle to a body leaves it.
Point exit_of(const Rect& rect, const Point& along) {
  const double across = rect.width / 2 / std::max(std::abs(along.x()), 1e-12);
  const double upright = rect.height / 2 / std::max(std::abs(along.y()), 1e-12);
  return Point(rect.x + rect.width / 2, rect.y + rect.height / 2) + std::min(across, upright) * along;
}

/// An arrow at the border, and beside it which body is there and how far from the middle of the view. False
/// where there is no room for the text: then there is no arrow either.
bool announce(Page& page, const Camera& camera, const SnapshotBody& body, const std::string& name) {
  const Vec2<double> away = body.pose.position - camera.center;
  const Vec2<double> unit = away.stableNormalized();
  const Point along(unit.x(), -unit.y());
  const Rect frame = inset(camera.viewport, border_rim);
  const Point tip = exit_of(frame, along);
  const std::string text = name + ", " + significant(std::hypot(away.x(), away.y()), 2) + " m away";
  TextStyle style = unseen_style(page);
  style.align = Align::center;
  const double width = page.canvas().text_width(text, style), height = 1.3 * style.size;
  // The text touches the arrow's base, whatever way that points.
  const double beside = std::min(0.5 * width / std::max(std::abs(along.x()), 1e-12),
                                 0.5 * height / std::max(std::abs(along.y()), 1e-12));
  const double depth = border_arrow + 4 + beside;
  List<Point> places;
  for (const double row : {0, 1, -1, 2, -2, 3, -3, 4, -4}) {
    Point middle = tip - depth * along + Point(0, row * height);
    middle.x() = std::clamp(middle.x(), frame.x + width / 2,
                            std::max(frame.x + width / 2, frame.x + frame.width - width / 2));
    places.emplace_back(std::round(middle.x()), std::round(baseline_around(middle.y(), style.size)));
  }
  if (!write_if_free(page, places, camera.viewport, text, style)) return false;
  const Point base = tip - border_arrow * along;
  const Point side = 0.4 * border_arrow * perpendicular<double>(along);
  const List<Point> corners = {tip, base + side, base - side};
  page.canvas().polygon(corners, {.fill = page.theme().text});
  return true;
}

void draw_ring_around(Page& page, const Camera& camera, const SnapshotBody& body, const std::string& name) {
  const Point at = camera.project(body.pose.position);
  page.canvas().circle(at, ring_radius,
                       {.outline = page.theme().text, .outline_width = 0.75 * page.sizes().outline});
  page.canvas().circle(at, 1.5, {.fill = page.theme().text});
  const TextStyle style = unseen_style(page);
  const double width = page.canvas().text_width(name, style);
  const double beside = ring_radius + 5;
  List<Point> places;
  for (const double row : {0.0, -1.3, 1.3}) {
    const double y = std::round(baseline_around(at.y() + row * style.size, style.size));
    places.emplace_back(at.x() + beside, y);
    places.emplace_back(at.x() - beside - width, y);
  }
  write_if_free(page, places, camera.viewport, name, style);
}

/// Lines in the upper left corner, below what is there already.
void write_notes(Page& page, const Camera& camera, const List<std::string>& notes) {
  const TextStyle style = unseen_style(page);
  const Rect within = inset(camera.viewport, border_rim);
  const double pitch = std::round(leading * style.size);
  for (const std::string& note : notes) {
    List<Point> places;
    for (double y = within.y + pitch; y < within.y + within.height; y += pitch) {
      places.emplace_back(within.x + border_rim, y);
    }
    write_if_free(page, places, camera.viewport,
                  ellipsized(page.canvas(), note, within.width - 2 * border_rim, style), style);
  }
}

std::string bodies_text(int count) { return std::to_string(count) + (count == 1 ? " body" : " bodies"); }

}  // namespace

void draw_unseen(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look) {
  const Unseen unseen = unseen_of(camera, snapshot);
  page.canvas().push_clip(camera.viewport);
  List<std::string> notes;
  int announced = 0, left_out = 0;
  for (const BodyId id : unseen.outside) {
    const bool is_announced =
        announced < most_announced && announce(page, camera, snapshot.bodies[id], spoken_name(look, id));
    ++(is_announced ? announced : left_out);
  }
  if (left_out > 0) {
    notes.push_back(announced > 0 ? "and " + std::to_string(left_out) + " more outside of the picture"
                                  : bodies_text(left_out) + " outside of the picture");
  }
  if (unseen.tiny.size() <= most_ringed) {
    for (const BodyId id : unseen.tiny) {
      draw_ring_around(page, camera, snapshot.bodies[id], spoken_name(look, id));
    }
  } else {
    notes.push_back(bodies_text(unseen.tiny.size()) + " smaller than 2 pixels");
  }
  if (!unseen.nowhere.empty()) {
    const int others = unseen.nowhere.size() - 1;
    notes.push_back(spoken_name(look, unseen.nowhere.front()) +
                    (others > 0 ? " and " + std::to_string(others) + " more are nowhere: not finite"
                                : " is nowhere: not finite"));
  }
  write_notes(page, camera, notes);
  page.canvas().pop_clip();
}

}  // namespace cairn::render
