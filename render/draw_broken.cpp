// What is left of joints that have broken.
#include <cmath>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr double stub = 16;         // [px] length of what is left of a rod at an end
constexpr double crack = 4;         // [px] by which its broken edge stands out
constexpr double half_cross = 0.7;  // of the radius of a ring: half the width of the cross in it

/// The end of a rod, towards where its other end is.
void draw_stub(Page& page, const Point& at, const Point& along) {
  const Theme& theme = page.theme();
  const Point side = perpendicular<double>(along);
  const Point tip = at + stub * along;
  page.canvas().line(at, tip, {.width = 2.5 * page.sizes().outline, .color = theme.joint});
  const List<Point> edge = {tip - crack * side, tip + crack * along, tip, tip + crack * (along + side)};
  page.canvas().polyline(edge, {.width = page.sizes().outline, .color = theme.joint});
  page.canvas().circle(at, 0.7 * page.sizes().joint, {.fill = theme.joint});
}

/// A pin that holds nothing any more.
void draw_crossed_ring(Page& page, const Point& at) {
  const double radius = page.sizes().joint, half = half_cross * radius;
  page.canvas().circle(at, radius,
                       {.fill = page.theme().background,
                        .outline = page.theme().joint,
                        .outline_width = page.sizes().outline});
  const Stroke stroke{.width = page.sizes().outline, .color = page.theme().joint};
  page.canvas().line(at - Point(half, half), at + Point(half, half), stroke);
  page.canvas().line(at - Point(half, -half), at + Point(half, -half), stroke);
}

}  // namespace

void draw_broken_joints(Page& page, const Camera& camera, const Snapshot& snapshot) {
  for (const SnapshotBreak& broken : snapshot.broken) {
    const SnapshotJoint& joint = broken.joint;
    const SnapshotBody *a = body_of(snapshot, joint.a), *b = body_of(snapshot, joint.b);
    if (!joint.traits.holds_points || !a || !b || !has_place(camera, a->pose) || !has_place(camera, b->pose))
      continue;
    const Point from = camera.project(joint.anchor_a), to = camera.project(joint.anchor_b);
    const double length = (to - from).norm();
    const bool has_stubs = joint.traits.is_line && length > 0;
    const Point along = has_stubs ? Point((to - from) / length) : Point(1, 0);
    if (!a->removed) has_stubs ? draw_stub(page, from, along) : draw_crossed_ring(page, from);
    if (!b->removed) has_stubs ? draw_stub(page, to, -along) : draw_crossed_ring(page, to);
  }
}

}  // namespace cairn::render
