// Marks of joints: grooves of slides and slots, springs, the teeth of ratchets, the boxes of servos.
#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr int spiral_turns = 2;
constexpr int zigzag_bends = 9;
constexpr int drawn_teeth = 12;  // of any ratchet: a mark, not its own teeth

/// [px] From the middle of a turning joint; angles counterclockwise, as in the world.
Point around(const Point& middle, double radius, double angle) {
  return middle + radius * Point(std::cos(angle), -std::sin(angle));
}

Stroke outline_of(const Page& page) { return {.width = page.sizes().outline, .color = page.theme().joint}; }

void draw_spiral(Page& page, const Point& middle, double angle) {
  const double ring = page.sizes().joint, steps = 24 * spiral_turns;
  List<Point> points;
  for (double i = 0; i <= steps; ++i) {
    points.push_back(
        around(middle, ring * (1.2 + 1.8 * i / steps), angle + 2 * pi * spiral_turns * i / steps));
  }
  page.canvas().polyline(points, outline_of(page));
}

/// A saw of teeth: steep on the side that holds. Of a ratchet that turns counterclockwise that is the side
/// that looks back.
void draw_teeth(Page& page, const Point& middle, double angle) {
  const double ring = page.sizes().joint;
  List<Point> points;
  for (int i = 0; i <= drawn_teeth; ++i) {
    const double at = angle + 2 * pi * i / drawn_teeth;
    points.push_back(around(middle, 1.6 * ring, at));
    if (i < drawn_teeth) points.push_back(around(middle, 2.4 * ring, at));
  }
  page.canvas().polyline(points, outline_of(page));
}

void draw_servo_box(Page& page, const Point& middle) {
  const double half = 1.8 * page.sizes().joint;
  page.canvas().rect(
      {middle.x() - half, middle.y() - half, 2 * half, 2 * half},
      {.fill = page.theme().background, .outline = page.theme().joint, .outline_width = page.sizes().outline},
      0.4 * half);
}

void draw_groove(Page& page, const Point& from, const Point& to) {
  page.canvas().capsule(from, to, 1.5 * page.sizes().joint,
                        {.fill = faded(page.theme().background, 0.6),
                         .outline = page.theme().joint,
                         .outline_width = 0.7 * page.sizes().outline});
}

void draw_zigzag(Page& page, const Point& from, const Point& to) {
  const Point way = to - from;
  if (!(way.norm() > 1)) return;
  const double half = page.sizes().joint;
  const Point bend = half / way.norm() * Point(-way.y(), way.x());
  List<Point> points = {from};
  for (int i = 1; i <= zigzag_bends; ++i) {
    points.push_back(from + (i - 0.5) / zigzag_bends * way + (i % 2 == 0 ? 1 : -1) * bend);
  }
  points.push_back(to);
  page.canvas().polyline(points, outline_of(page));
}

/// Whether lines between them can be drawn.
bool has_groove(const Camera& camera, const SnapshotJoint& joint) {
  return joint.groove.size() == 2 &&
         std::all_of(joint.groove.begin(), joint.groove.end(), [&](const Vec2<double>& point) {
           return is_drawable(camera, {.position = point, .angle = 0});
         });
}

}  // namespace

void draw_joint_marks(Page& page, const Camera& camera, const Snapshot& snapshot,
                      const SnapshotJoint& joint) {
  const Point middle = camera.project(joint.anchor_a), end = camera.project(joint.anchor_b);
  if (joint.traits.slides) {
    const bool is_grooved = has_groove(camera, joint);
    if (joint.traits.has_spring)
      return draw_zigzag(page, is_grooved ? camera.project(joint.groove[1]) : middle, end);
    if (is_grooved) draw_groove(page, camera.project(joint.groove[0]), camera.project(joint.groove[1]));
    return;
  }
  const SnapshotBody* const b = body_of(snapshot, joint.b);
  const double angle = b != nullptr && has_place(camera, b->pose) ? b->pose.angle : 0;
  if (joint.traits.has_servo) draw_servo_box(page, middle);
  if (joint.traits.has_ratchet) draw_teeth(page, middle, angle);
  if (joint.traits.has_spring) draw_spiral(page, middle, angle);
}

}  // namespace cairn::render
