// The box on its rod, with level curves of c and the arrows of j, f and v.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"

namespace cairn::one_row {

namespace {

using render::Page;
using render::Point;
using render::Rect;
using render::significant;

/// The pivot, the box, and the circles around the pivot with room for their names.
render::Camera rod_camera(const Rect& inside, const Rod& rod) {
  const Vec2<double>& anchor = rod.settings.anchor;
  return render::fit(inside, {{std::min(-1.3, 0.9 * anchor.x() - 2.6), -rod.length - 1.5},
                              {std::max(anchor.x() + 2.6, 4.0), 0.5}});
}

/// Where c is −1, 0 and +1 m, were the anchor there. The label of a velocity may cross the dashed ones:
/// between two arrows there is no other place.
void draw_circles(Page& page, const render::Camera& camera, const Rod& rod, const RodLook& look) {
  for (const double c : {-1.0, 0.0, 1.0}) {
    const double radius = rod.length + c;
    List<Point> points;
    for (int k = 0; k <= 90; ++k)
      points.push_back(camera.project(Rotation<double>(-pi * k / 90) * Vec2<double>(radius, 0)));
    render::Stroke stroke{.width = page.sizes().axis, .color = page.theme().inactive, .dash = {6, 5}};
    if (c == 0) stroke = {.width = page.sizes().curve, .color = page.theme().joint, .dash = {}};
    page.canvas().polyline(points, stroke);
    if (c == 0 || !look.velocity) page.avoid(points);
    render::TextStyle style = page.value();
    const std::string name = c == 0 ? "c = 0" : "c = " + render::fixed(c, 0, render::Sign::always) + " m";
    const Point at = camera.project({0, -radius});
    const double width = page.canvas().text_width(name, style);
    page.canvas().rect({at.x() - width / 2 - 6, at.y() - 0.7 * style.size, width + 12, 1.4 * style.size},
                       {.fill = page.theme().panel});
    page.canvas().text(at + Point(-width / 2, 0.35 * style.size), name, style);
  }
}

/// Labels stand beside the box, not across its edges.
void keep_off_box(Page& page, const render::Camera& camera, const Pose<double>& pose) {
  List<Point> edges;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}})
    edges.push_back(camera.project(pose.world({x, y})));
  page.avoid(edges);
}

struct Arc {
  Vec2<double> center = {0, 0};  // [m]
  double radius = 0.8;           // [m]
  double middle = 0;             // [rad] direction of its middle
  double sign = 1;               // positive: counterclockwise
  std::string label = {};
  render::Color color = {};
};

/// A turning sense: an arc with a head.
void draw_arc(Page& page, const render::Camera& camera, const Arc& arc) {
  constexpr double half = 0.75;  // [rad] of the arc, to both sides
  List<Point> points;
  for (int k = 0; k <= 32; ++k) {
    const double angle = arc.middle + arc.sign * half * (k / 16.0 - 1);
    points.push_back(camera.project(arc.center + Rotation<double>(angle) * Vec2<double>(arc.radius, 0)));
  }
  const Point tip = points.back();
  const Point along = (tip - points[points.size() - 6]).normalized();
  const double length = page.sizes().head_length, width = page.sizes().head_width;
  points.resize(points.size() - 3);
  page.canvas().polyline(points, {.width = 0.8 * page.sizes().arrow, .color = arc.color, .dash = {}});
  const Point side = 0.5 * width * perpendicular(along);
  const FixedList<Point, 3> head = {tip - length * along - side, tip + 2 * along,
                                    tip - length * along + side};
  page.canvas().polygon(head, {.fill = arc.color});
  page.avoid(points);
  render::TextStyle style = page.value();
  style.halo = page.theme().panel;
  const Vec2<double> out = Rotation<double>(arc.middle) * Vec2<double>(arc.radius, 0);
  const Point at = camera.project(arc.center + out);
  const double wide = page.canvas().text_width(arc.label, style);
  const double gap = 0.7 * page.sizes().arrow + 6;
  const auto beyond = [&](double turn, double shift) {
    const Vec2<double> end = Rotation<double>(arc.middle + turn) * Vec2<double>(arc.radius, 0);
    return Point(camera.project(arc.center + end) + Point(-wide / 2, shift));
  };
  page.place_text({at + Point(gap, 0.35 * style.size), at + Point(-gap - wide, 0.35 * style.size),
                   beyond(1, -6), beyond(-1, 6 + style.size), beyond(1, 6 + style.size), beyond(-1, -6)},
                  camera.viewport, arc.label, style);
}

/// j or f: what it has for x and y at the anchor, and for the angle around the centre.
void draw_row_arrows(Page& page, const render::Camera& camera, const Rod& rod, const RodLook& look) {
  const Vec3<double>& value = look.force ? rod.force : rod.jacobian;
  const double size = value.head<2>().norm();
  if (!(size > 0)) return;
  const render::ArrowScale scale{.pixels_per_unit = 1.7 * camera.scale / size, .longest = 1e4, .unit = ""};
  const Vec2<double> anchor = look.pose.world(rod.pose.local(rod.settings.anchor));
  const std::string unit = look.force ? " N" : "";
  draw_arrow(
      page, camera, scale,
      {.kind = look.force ? render::ArrowKind::normal : render::ArrowKind::joint,
       .tail = anchor,
       .value = value.head<2>(),
       .label = fmt::format("({}, {}){}", significant(value.x(), 2), significant(value.y(), 2), unit)});
  if (std::abs(value.z()) < 1e-6 * size) return;
  const Vec2<double> arm = rod.pose.position - rod.settings.anchor;  // away from the rod
  draw_arc(page, camera,
           {.center = look.pose.position,
            .radius = 0.95,
            .middle = std::atan2(arm.y(), arm.x()),
            .sign = value.z() > 0 ? 1.0 : -1.0,
            .label = significant(value.z(), 2) + (look.force ? " N m" : " m"),
            .color = look.force ? page.theme().normal : page.theme().joint});
}

/// Beyond the tip of an arrow, above it or below it.
void write_at_tip(Page& page, const render::Camera& camera, const Vec2<double>& tip,
                  const Vec2<double>& along, const std::string& text) {
  render::TextStyle style = page.value();
  style.halo = page.theme().panel;
  style.align = render::Align::center;
  const double gap = along.y() > 0 ? -8 : 8 + style.size;
  const double half = page.canvas().text_width(text, style) / 2;
  const Point at = camera.project(tip) + Point(0, gap);
  List<Point> places = {at};
  for (const double away : {0.0, 1.5 * gap, 3 * gap}) {
    for (const double aside : {-0.7, 0.7, -1.2, 1.2}) places.push_back(at + Point(aside * half, away));
  }
  page.place_text(places, camera.viewport, text, style);
}

/// The velocity of the centre, and that of the anchor, which is what the rod sees.
void draw_velocity_arrows(Page& page, const render::Camera& camera, const Rod& rod, const RodLook& look) {
  const Vec3<double>& v = *look.velocity;
  const Vec2<double> at_anchor = v.head<2>() + cross(v.z(), rod.arm);
  double largest = std::max(v.head<2>().norm(), at_anchor.norm());
  if (!(largest > 0)) return;
  const render::ArrowScale scale{
      .pixels_per_unit = std::min(1.2, 2 / largest) * camera.scale, .longest = 1e4, .unit = "m/s"};
  for (const bool of_anchor : {false, true}) {
    const Vec2<double> tail = of_anchor ? rod.settings.anchor : look.pose.position;
    const Vec2<double> value = of_anchor ? at_anchor : Vec2<double>(v.head<2>());
    draw_arrow(page, camera, scale,
               {.kind = render::ArrowKind::velocity, .tail = tail, .value = value, .active = of_anchor});
    const Vec2<double> way = value * scale.pixels_per_unit / camera.scale;  // [m] to the tip
    page.avoid({camera.project(tail), camera.project(tail + way)});
  }
  const std::string text = fmt::format("{} m/s", significant(at_anchor.norm(), 3));
  write_at_tip(page, camera, rod.settings.anchor + at_anchor * scale.pixels_per_unit / camera.scale,
               at_anchor, text);
}

/// The velocities of the question, by number: what each does to the anchor is for the reader to find.
void draw_asked(Page& page, const render::Camera& camera, const Rod& rod) {
  const Vec2<double>& centre = rod.pose.position;
  double largest = 1e-9;
  for (const Motion& motion : rod.asked) largest = std::max(largest, motion.velocity.head<2>().norm());
  const render::ArrowScale scale{
      .pixels_per_unit = 1.6 / largest * camera.scale, .longest = 1e4, .unit = "m/s"};
  for (int i = 0; i < rod.asked.size(); ++i) {
    const Vec2<double> v = rod.asked[i].velocity.head<2>();
    draw_arrow(page, camera, scale, {.kind = render::ArrowKind::velocity, .tail = centre, .value = v});
    render::TextStyle style = page.value();
    style.halo = page.theme().panel;
    style.align = render::Align::center;
    const Vec2<double> tip = centre + v * (1 + 0.13 / v.norm()) * (scale.pixels_per_unit / camera.scale);
    page.canvas().text(camera.project(tip) + Point(0, 0.35 * style.size), std::to_string(i + 1), style);
  }
}

}  // namespace

void draw_rod(Page& page, const Rect& rect, const Rod& rod, const RodLook& look) {
  const Rect inside = page.panel(rect, "");
  const render::Camera camera = rod_camera(inside, rod);
  page.canvas().push_clip(inside);
  if (look.circles) draw_circles(page, camera, rod, look);
  const FixedList<Snapshot, 1> before = {rod.snapshot};
  if (look.ghost) draw_ghosts(page, camera, before);
  draw_world(page, camera, moved_to(rod, look.pose), {.names = {"", ""}, .contacts = false});
  page.canvas().circle(camera.project({0, 0}), page.sizes().joint,
                       {.fill = page.theme().panel, .outline = page.theme().outline, .outline_width = 2});
  keep_off_box(page, camera, look.pose);
  if (look.direction || look.force) draw_row_arrows(page, camera, rod, look);
  if (look.asked) draw_asked(page, camera, rod);
  if (look.velocity) draw_velocity_arrows(page, camera, rod, look);
  page.canvas().pop_clip();
}

}  // namespace cairn::one_row
