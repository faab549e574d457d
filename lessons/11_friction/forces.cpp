// Lesson 11. Forces on the block, drawn on the left half of a page.
#include "forces.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "math/list.hpp"
#include "render/draw.hpp"

namespace cairn::friction {

using namespace render;

namespace {

/// Both blocks' weights at most: one scale for all frames with forces.
ArrowScale force_scale(const Camera& camera, const Study& study) {
  return arrow_scale(study.settings.slope.gravity, "N", camera);
}

/// Where the contact's force acts: the mean of the points, weighed by their loads.
Vec2<double> centre_of_pressure(const Snapshot& snapshot) {
  Vec2<double> sum(0, 0);
  double total = 0;
  for (const SnapshotContact& contact : snapshot.contacts) {
    sum += contact.normal_impulse * contact.position;
    total += contact.normal_impulse;
  }
  if (!(total > 0)) return snapshot.bodies[first_block].pose.position;
  return sum / total;
}

/// The sum of what the contact points give to the block [N]: along the normal, and downhill.
Vec2<double> contact_force(const Snapshot& snapshot) {
  Vec2<double> sum(0, 0);
  for (const SnapshotContact& contact : snapshot.contacts) {
    const double side = contact.b == first_block ? 1 : -1;
    sum += Vec2<double>(contact.normal_impulse, side * contact.friction_impulse);
  }
  return sum / snapshot.dt;
}

/// An arrow whose label stands at its tip: beside the middle it would stand upon the block.
void draw_force(Page& page, const Camera& camera, const ArrowScale& scale, const Arrow& arrow,
                const std::string& text) {
  draw_arrow(page, camera, scale, arrow);
  const Point tip =
      camera.project(arrow.tail) + scale.pixels_per_unit * Point(arrow.value.x(), -arrow.value.y());
  TextStyle style = page.value();
  style.halo = page.theme().background;
  const double width = page.canvas().text_width(text, style);
  const double size = style.size;
  const double side = arrow.value.x() < 0 ? -width : 0;
  List<Point> places = {tip + Point(arrow.value.x() < 0 ? -width - 8 : 16, size / 3)};
  if (arrow.value.y() < 0) places.insert(places.begin(), tip + Point(side, 1.4 * size));
  // Clear of the bracket that may stand at the tip.
  if (arrow.kind == ArrowKind::external) places.insert(places.begin(), tip + Point(size, -size));
  if (arrow.kind == ArrowKind::friction) {
    // Below the shaft, which comes down to the right from the tip.
    const double drop = 0.8 * width * std::abs(arrow.value.y() / arrow.value.x());
    places.insert(places.begin(), tip + Point(-0.2 * width, drop + 1.7 * size));
  }
  places.push_back(tip + Point(side, -10));
  for (Point& place : places) place.x() = std::max(place.x(), page.area().x);
  page.place_text(places, page.area(), text, style);
}

std::string newtons(const std::string& name, double value) { return name + " " + fixed(value, 2) + " N"; }

}  // namespace

Layout layout_of(const Page& page) {
  const List<Rect> halves = columns(page.area(), {48, 50}, page.sizes().gap);
  const List<Rect> panels = rows(halves[1], {50, 50}, page.sizes().gap);
  return {halves[0], panels[0], panels[1], halves[1]};
}

Camera camera_of(const Rect& viewport, const Slope& slope) {
  const double length = slope.length;
  return fit(viewport,
             {{-0.1, -0.3}, {length * std::cos(slope.angle) + 0.1, length * std::sin(slope.angle) + 0.9}});
}

/// The block with what pulls it down the slope, what carries it and what holds it, and how far the latter may
/// go.
void draw_forces(Page& page, const Slide& slide, const Study& study) {
  const Slope& slope = slide.slope;
  const Camera camera = camera_of(layout_of(page).scene, slope);
  const ArrowScale scale = force_scale(camera, study);
  const Snapshot& now = slide.frames[1];
  draw_world(page, camera, now, {.names = {"", "", ""}, .contacts = false});
  const Vec2<double> force = contact_force(now);
  const Vec2<double> foot = centre_of_pressure(now);
  const double pull = coulomb(slope, slide.block).needed;
  const double held = std::abs(force.y());
  draw_friction_limit(page, camera, scale, foot, slope.downhill(), slide.block.friction * force.x());
  draw_force(page, camera, scale,
             {.kind = ArrowKind::normal, .tail = foot, .value = force.x() * slope.normal()},
             newtons("λ_{n}", force.x()));
  draw_force(page, camera, scale,
             {.kind = ArrowKind::friction, .tail = foot, .value = -held * slope.downhill()},
             newtons("λ_{t}", held));
  draw_force(page, camera, scale,
             {.kind = ArrowKind::external, .tail = foot, .value = pull * slope.downhill()},
             newtons("m g sin α", pull));
  draw_scale_key(page, scale, {page.area().x, page.area().y + page.area().height});
}

void draw_corners(Page& page, const Slide& slide, const Study& study) {
  const Camera camera = camera_of(layout_of(page).scene, slide.slope);
  const ArrowScale scale = force_scale(camera, study);
  const Snapshot& now = slide.frames[1];
  draw_world(page, camera, now, {.names = {"", "", ""}});
  for (const SnapshotContact& contact : now.contacts) {
    const double load = contact.normal_impulse / now.dt;
    const double held = std::abs(contact.friction_impulse) / now.dt;
    const Vec2<double> downhill = slide.slope.downhill();
    draw_friction_limit(page, camera, scale, contact.position, downhill, contact.friction * load);
    draw_force(page, camera, scale,
               {.kind = ArrowKind::normal, .tail = contact.position, .value = load * slide.slope.normal()},
               newtons("λ_{n}", load));
    draw_force(page, camera, scale,
               {.kind = ArrowKind::friction, .tail = contact.position, .value = -held * downhill},
               newtons("λ_{t}", held));
  }
  draw_scale_key(page, scale, {page.area().x, page.area().y + page.area().height});
}

}  // namespace cairn::friction
