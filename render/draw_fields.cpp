// What acts on bodies from outside: water, points that attract, wind and forces.
#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr double longest = 64;            // [px] of the arrow of the largest force
constexpr double widest = 0.75 * 2 * pi;  // [rad] of the bow of the largest torque
constexpr double far_away = 1e4;          // [px] beyond every picture

/// All of the viewport that is below the level, as gravity sees it.
Outline below_level(const Camera& camera, const Water& water, const Vec2<double>& up) {
  const Point surface = camera.project(water.level * up), down(-up.x(), up.y());
  const Point along = far_away * perpendicular<double>(down);
  return clipped({surface - along, surface + along, surface + along + far_away * down,
                  surface - along + far_away * down},
                 camera.viewport);
}

void draw_star(Page& page, const Camera& camera, const Attraction& star) {
  if (!is_drawable(camera, {.position = star.point, .angle = 0})) return;
  const Point at = camera.project(star.point);
  const Color color = page.theme().external;
  page.canvas().circle(at, 3.5, {.fill = color});
  for (const double radius : {9.0, 15.0})
    page.canvas().circle(at, radius, {.outline = faded(color, 6 / radius), .outline_width = 1.5});
}

/// An arrow in the upper left corner, with its speed.
void draw_wind(Page& page, const Camera& camera, const Vec2<double>& wind) {
  if (wind.isZero(0)) return;
  const Point along = Point(wind.x(), -wind.y()).normalized(),
              middle(camera.viewport.x + 44, camera.viewport.y + 34);
  const Vec2<double> tail = camera.unproject(middle - 24 * along),
                     tip = camera.unproject(middle + 24 * along);
  draw_arrow(page, camera, {.pixels_per_unit = camera.scale},
             {.kind = ArrowKind::external, .tail = tail, .value = tip - tail});
  const TextStyle style = page.value();
  write_if_free(page, {middle + Point(36, 0.35 * style.size)}, camera.viewport,
                "wind " + readable(wind.norm(), 2) + " m/s", style);
}

/// A dashed line with a ring at each of its points, as far as it can be drawn.
void draw_path(Page& page, const Camera& camera, const SnapshotPath& path) {
  List<Point> points;
  for (const Vec2<double>& point : path.points) {
    if (!is_drawable(camera, {.position = point, .angle = 0})) return;
    points.push_back(camera.project(point));
  }
  const Color color = page.theme().velocity;
  page.canvas().polyline(points, {.width = 1.5, .color = faded(color, 0.7), .dash = {6, 5}});
  for (const Point& point : points)
    page.canvas().circle(point, 3.5,
                         {.fill = page.theme().background, .outline = color, .outline_width = 1.5});
}

/// A bow around the centre of mass, from below on, with a head where it ends: the way that the torque turns.
void draw_torque(Page& page, const Point& middle, double turn) {
  const double radius = 20, head = 13, begin = -pi / 2;
  const auto at = [&](double angle, double distance) -> Point {
    return middle + distance * Point(std::cos(angle), -std::sin(angle));
  };
  const Color color = page.theme().external;
  // The head is as long as this angle of the bow.
  const double end = begin + turn, neck = end - std::copysign(head / radius, turn);
  List<Point> bow;
  const int pieces = 32;
  for (int i = 0; i <= pieces; ++i) bow.push_back(at(begin + (neck - begin) * i / pieces, radius));
  page.canvas().polyline(bow, {.width = page.sizes().arrow, .color = color});
  const List<Point> tip = {at(end, radius), at(neck, radius - 0.45 * head), at(neck, radius + 0.45 * head)};
  page.canvas().polygon(tip, {.fill = color});
}

}  // namespace

void draw_fields(Page& page, const Camera& camera, const Snapshot& snapshot) {
  if (snapshot.fields.water) {
    const Outline part = below_level(camera, *snapshot.fields.water, up_direction(snapshot.gravity));
    if (part.size() > 2) page.canvas().polygon(part, {.fill = page.theme().water});
  }
  for (const Attraction& star : snapshot.fields.attractions) draw_star(page, camera, star);
  for (const SnapshotPath& path : snapshot.paths) draw_path(page, camera, path);
  draw_wind(page, camera, snapshot.fields.wind);
}

void draw_outer_forces(Page& page, const Camera& camera, const Snapshot& snapshot) {
  double largest = 0, largest_torque = 0;
  for (const SnapshotForce& force : snapshot.forces) {
    largest = std::max(largest, force.force.norm());
    largest_torque = std::max(largest_torque, std::abs(force.torque));
  }
  const ArrowScale scale{.pixels_per_unit = longest / largest, .longest = longest};
  for (const SnapshotForce& force : snapshot.forces) {
    if (!is_drawable(camera, {.position = force.point, .angle = 0})) continue;
    if (!force.force.isZero(0)) {
      draw_arrow(page, camera, scale,
                 {.kind = ArrowKind::external, .tail = force.point, .value = force.force});
    }
    const Point middle = camera.project(snapshot.bodies[force.body].pose.position);
    if (force.torque != 0) draw_torque(page, middle, widest * force.torque / largest_torque);
  }
}

}  // namespace cairn::render
