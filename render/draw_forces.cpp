// Forces and velocities of a world as arrows.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/draw_parts.hpp"
#include "render/rects.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr int most_labels = 12;       // more arrows than this go without numbers
constexpr double least_drawn = 1e-9;  // [N or m/s] less is round-off
constexpr double shortest = 8;        // [px] what is drawn as a dot is about zero, and has no number
constexpr double aside = 12;          // [px] from the middle of a shaft to a text

/// An arrow on the page, and from where its label points away.
struct PlacedArrow {
  Arrow arrow = {};
  Vec2<double> body = {0, 0};  // [m] centre of the body it acts upon
  Color color = {};
};

LineSegment line_of(const Camera& camera, const ArrowScale& scale, const Arrow& arrow) {
  const double length = std::min(arrow.value.norm() * scale.pixels_per_unit, scale.longest);
  const Point tail = camera.project(arrow.tail);
  const Vec2<double> along = arrow.value.normalized();
  return {tail, tail + length * Point(along.x(), -along.y())};
}

std::string value_text(const Page& page, const std::string& symbol, double value, const ArrowScale& scale) {
  const std::string number = readable(value, std::abs(value) < 100 ? 2 : 1);
  if (page.compact()) return number;
  return (symbol.empty() ? "" : symbol + " = ") + number + (scale.unit.empty() ? "" : " " + scale.unit);
}

bool can_be_drawn(const Camera& camera, const Arrow& arrow) {
  return is_drawable(camera, {.position = arrow.tail, .angle = 0}) && arrow.value.allFinite() &&
         arrow.value.norm() > least_drawn;
}

// What is left of the regions around a rectangle.
List<Rect> without(const List<Rect>& regions, const Rect& hole) {
  List<Rect> left;
  const auto keep = [&left](double x, double y, double right, double bottom) {
    if (right > x && bottom > y) left.push_back({x, y, right - x, bottom - y});
  };
  for (const Rect& r : regions) {
    const double right = r.x + r.width;
    const double bottom = r.y + r.height;
    const double top = std::clamp(hole.y, r.y, bottom);
    const double base = std::clamp(hole.y + hole.height, r.y, bottom);
    keep(r.x, r.y, right, top);
    keep(r.x, base, right, bottom);
    keep(r.x, top, std::clamp(hole.x, r.x, right), base);
    keep(std::clamp(hole.x + hole.width, r.x, right), top, right, base);
  }
  return left;
}

// An arrow passes behind numbers that were there before it.
void draw_behind_text(Page& page, const Camera& camera, const ArrowScale& scale, const Arrow& arrow) {
  List<Rect> regions = {camera.viewport};
  for (const TextBox& box : page.canvas().text_boxes()) {
    LineSegment line = line_of(camera, scale, arrow);
    const Rect hole{std::floor(box.rect.x), std::floor(box.rect.y), std::ceil(box.rect.width) + 1,
                    std::ceil(box.rect.height) + 1};
    if (clip(line, hole)) regions = without(regions, hole);
  }
  for (const Rect& region : regions) {
    page.canvas().push_clip(region);
    draw_arrow(page, camera, scale, arrow);
    page.canvas().pop_clip();
  }
}

TextStyle label_style(const Page& page, Color color) {
  TextStyle style = page.value();
  style.halo = page.theme().background;
  style.align = Align::center;
  if (page.compact()) return style;
  style.size = std::max(style.size, 18.0);  // bold of this size may have the arrow's colour
  style.bold = true;
  style.color = color;
  return style;
}

/// Base lines of a text beside a line: its middle right or left of a point of the line, above or below it, or
/// beyond the tip, whichever is nearer; first on the side that `outward` shows.
List<Point> places_beside(const LineSegment& line, const Point& outward, double width, double height) {
  const Point run = line.to - line.from;
  const Point along = run.normalized();
  constexpr double steep = 1e-6;  // no division by zero
  const double sideways =
      aside + width / 2 + height / 2 * std::abs(along.x()) / std::max(std::abs(along.y()), steep);
  const double upwards =
      aside + height / 2 + width / 2 * std::abs(along.y()) / std::max(std::abs(along.x()), steep);
  Point shift(0, std::copysign(upwards, outward.y()));
  if (sideways < upwards) shift = {std::copysign(sideways, outward.x()), 0};
  const double beyond = aside + width / 2 * std::abs(along.x()) + height / 2 * std::abs(along.y());
  List<Point> places;
  const auto add = [&](const Point& middle) {
    places.emplace_back(std::round(middle.x()), std::round(baseline_around(middle.y(), height)));
  };
  for (const double part : {0.5, 0.8, 0.2, 1.0, 0.0}) add(line.from + part * run + shift);
  for (const double part : {0.5, 0.8, 0.2, 1.0, 0.0}) add(line.from + part * run - shift);
  add(line.to + beyond * along);
  return places;
}

void write_label(Page& page, const Camera& camera, const ArrowScale& scale, const PlacedArrow& placed,
                 const List<PlacedArrow>& all) {
  const LineSegment line = line_of(camera, scale, placed.arrow);
  const TextStyle style = label_style(page, placed.color);
  const std::string& label = placed.arrow.label;
  Point outward = perpendicular<double>(line.to - line.from);
  const double side = outward.dot(line.from - camera.project(placed.body));
  if (side < -outward.norm()) outward = -outward;
  List<Point> places = places_beside(line, outward, page.canvas().text_width(label, style), style.size);
  // A number beside two arrows could belong to either.
  const auto meets_arrow = [&](const Point& at) {
    const Rect rect = text_rect(page.canvas(), at, label, style);
    return std::any_of(all.begin(), all.end(), [&](const PlacedArrow& other) {
      LineSegment shaft = line_of(camera, scale, other.arrow);
      return clip(shaft, rect);
    });
  };
  places.erase(std::remove_if(places.begin(), places.end(), meets_arrow), places.end());
  write_if_free(page, places, camera.viewport, label, style);
}

void draw_arrows(Page& page, const Camera& camera, const ArrowScale& scale, List<PlacedArrow> arrows) {
  page.canvas().push_clip(camera.viewport);
  const bool are_few = arrows.size() <= most_labels;
  for (const PlacedArrow& placed : arrows) {
    Arrow bare = placed.arrow;
    if (!are_few || bare.value.norm() * scale.pixels_per_unit <= scale.longest) bare.label.clear();
    if (are_few && bare.label.empty()) {
      draw_behind_text(page, camera, scale, bare);
    } else {
      draw_arrow(page, camera, scale, bare);
    }
  }
  for (const PlacedArrow& placed : arrows) {
    const double length = placed.arrow.value.norm() * scale.pixels_per_unit;
    if (are_few && length >= shortest && length <= scale.longest)
      write_label(page, camera, scale, placed, arrows);
  }
  page.canvas().pop_clip();
}

Vec2<double> center_of(const Snapshot& snapshot, BodyId id, const Vec2<double>& otherwise) {
  const SnapshotBody* body = body_of(snapshot, id);
  return body != nullptr && body->pose.position.allFinite() ? body->pose.position : otherwise;
}

// The part of a velocity's line that the number in the middle of the body needs [m].
double free_of_number(const Page& page, const Camera& camera, const SnapshotBody& body, BodyId id) {
  return 0.7 * name_size(page, camera, body, std::to_string(id.index)) / camera.scale;
}

}  // namespace

void draw_contact_forces(Page& page, const Camera& camera, const ArrowScale& scale,
                         const Snapshot& snapshot) {
  if (!(snapshot.dt > 0)) return;
  List<PlacedArrow> arrows;
  for (const SnapshotContact& contact : snapshot.contacts) {
    const Vec2<double> right(contact.normal.y(), -contact.normal.x());  // the normal turned by -90 degrees
    const double push = contact.normal_impulse / snapshot.dt;
    const double drag = contact.friction_impulse / snapshot.dt;
    const Vec2<double> center = center_of(snapshot, contact.b, contact.position);
    const Arrow normal{.kind = ArrowKind::normal,
                       .tail = contact.position,
                       .value = push * contact.normal,
                       .label = value_text(page, "λ_{n}", push, scale)};
    const Arrow friction{.kind = ArrowKind::friction,
                         .tail = contact.position,
                         .value = drag * right,
                         .label = value_text(page, "λ_{t}", drag, scale)};
    // What is too small for an arrow would be a dot upon the dot of the contact.
    const auto is_arrow = [&](const Arrow& arrow) {
      return can_be_drawn(camera, arrow) && arrow.value.norm() * scale.pixels_per_unit >= shortest;
    };
    if (is_arrow(normal)) arrows.push_back({normal, center, page.theme().normal});
    if (is_arrow(friction)) arrows.push_back({friction, center, page.theme().friction});
  }
  draw_arrows(page, camera, scale, arrows);
}

void draw_joint_forces(Page& page, const Camera& camera, const ArrowScale& scale, const Snapshot& snapshot) {
  if (!(snapshot.dt > 0)) return;
  List<PlacedArrow> arrows;
  for (const SnapshotJoint& joint : snapshot.joints) {
    const Vec2<double> force = joint.impulse / snapshot.dt;
    const Arrow arrow{.kind = ArrowKind::joint,
                      .tail = joint.anchor_b,
                      .value = force,
                      .label = value_text(page, "λ", force.norm(), scale)};
    const Vec2<double> center = center_of(snapshot, joint.b, joint.anchor_b);
    if (can_be_drawn(camera, arrow)) arrows.push_back({arrow, center, page.theme().joint});
  }
  draw_arrows(page, camera, scale, arrows);
}

void draw_velocities(Page& page, const Camera& camera, const ArrowScale& scale, const Snapshot& snapshot) {
  List<PlacedArrow> arrows;
  for (const BodyId id : snapshot.bodies.indices()) {
    const SnapshotBody& body = snapshot.bodies[id];
    const Vec2<double> velocity = body.velocity.head<2>();
    if (body.type != BodyType::dynamic || !is_drawable(camera, body.pose)) continue;
    Arrow arrow{.kind = ArrowKind::velocity,
                .tail = body.pose.position,
                .value = velocity,
                .label = value_text(page, "", velocity.norm(), scale)};
    if (!can_be_drawn(camera, arrow)) continue;
    arrow.tail += free_of_number(page, camera, body, id) * velocity.normalized();
    arrows.push_back({arrow, body.pose.position, page.theme().velocity});
  }
  draw_arrows(page, camera, scale, arrows);
}

}  // namespace cairn::render
