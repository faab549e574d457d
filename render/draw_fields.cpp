// What acts on bodies from outside: water, points that attract, wind and forces.
#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr double longest = 64;    // [px] of the arrow of the largest force
constexpr double far_away = 1e4;  // [px] beyond every picture

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

}  // namespace

void draw_fields(Page& page, const Camera& camera, const Snapshot& snapshot) {
  if (snapshot.fields.water) {
    const Outline part = below_level(camera, *snapshot.fields.water, up_direction(snapshot.gravity));
    if (part.size() > 2) page.canvas().polygon(part, {.fill = page.theme().water});
  }
  for (const Attraction& star : snapshot.fields.attractions) draw_star(page, camera, star);
  draw_wind(page, camera, snapshot.fields.wind);
}

void draw_outer_forces(Page& page, const Camera& camera, const Snapshot& snapshot) {
  double largest = 0;
  for (const SnapshotForce& force : snapshot.forces) largest = std::max(largest, force.force.norm());
  if (!(largest > 0)) return;
  const ArrowScale scale{.pixels_per_unit = longest / largest, .longest = longest};
  for (const SnapshotForce& force : snapshot.forces) {
    if (!is_drawable(camera, {.position = force.point, .angle = 0})) continue;
    draw_arrow(page, camera, scale, {.kind = ArrowKind::external, .tail = force.point, .value = force.force});
  }
}

}  // namespace cairn::render
