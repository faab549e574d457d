// The two ends of every push at the left of a stack, velocities at its right.
#include "lessons/kit/stack_panel.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/draw.hpp"
#include <cairn/world/scene_snapshot.hpp>

namespace cairn {

namespace {

using render::ArrowKind;
using render::ArrowScale;
using render::Camera;
using render::fixed;
using render::Page;
using render::Point;
using render::TextStyle;

constexpr double near_place = -0.7, far_place = -1.0;  // [m] of the arrows, from the middle of the stack
constexpr double velocity_place = 0.75;
constexpr double longest_push = 0.65, ground_depth = 0.7;  // [m]
constexpr double text_gap = 14;                            // [px] from an arrow

TextStyle style_of(const Page& page, bool active) {
  TextStyle style = page.value();
  style.bold = active;
  if (!active) style.color = page.theme().secondary_text;
  return style;
}

/// Both ends of a push meet at its contact. Neighbours take turns with two columns, so that arrows never
/// meet.
void draw_pushes(Page& page, const Camera& camera, const StackMoment& moment) {
  const ArrowScale scale{.pixels_per_unit = longest_push * camera.scale / moment.largest_lambda,
                         .longest = camera.scale,
                         .unit = "N"};
  for (int i = 0; i < moment.lambda.size(); ++i) {
    const double lambda = moment.lambda[i], y = i;
    const double place = i % 2 == 0 ? near_place : far_place;
    const bool active = i == moment.active;
    if (lambda == 0 && !active) continue;
    page.canvas().line(camera.project({place, y}), camera.project({-0.5, y}),
                       {.width = 1, .color = page.theme().inactive});
    draw_arrow(page, camera, scale, {.tail = {place, y}, .value = {0, lambda}, .active = active});
    draw_arrow(page, camera, scale, {.tail = {place, y}, .value = {0, -lambda}, .active = active});
    TextStyle style = style_of(page, active);
    style.align = render::Align::right;
    const Point at = camera.project({far_place, y});
    page.canvas().text({at.x() - text_gap, at.y() + (i == 0 ? -text_gap : style.size / 3)},
                       fmt::format("λ_{{{}}} = {} N", i + 1, fixed(lambda, 2)), style);
  }
}

void draw_box_velocity(Page& page, const Camera& camera, const StackMoment& moment, int box) {
  const ArrowScale scale{.pixels_per_unit = 0.5 * camera.scale / moment.largest_velocity,
                         .longest = camera.scale,
                         .unit = "m/s"};
  const double now = moment.velocity[box], y = box + 0.6;
  const double before = moment.earlier.empty() ? now : moment.earlier[box];
  const bool lit = moment.active >= 0 && (box == moment.active || box + 1 == moment.active);
  const bool changed = std::abs(now - before) > 1e-12;
  const double place = changed ? velocity_place + 0.2 : velocity_place;
  if (changed) {
    draw_arrow(page, camera, scale,
               {.kind = ArrowKind::inactive, .tail = {velocity_place, y}, .value = {0, before}});
  }
  draw_arrow(page, camera, scale, {.kind = ArrowKind::velocity, .tail = {place, y}, .value = {0, now}});
  const Point at = camera.project({place, y - 0.1}) + Point(text_gap, 0);
  page.canvas().text(at, fmt::format("v_{{{}}} = {} m/s", box + 1, fixed(now, 3)), style_of(page, lit));
  if (!changed) return;
  const TextStyle was = style_of(page, false);
  page.canvas().text(at + Point(0, 1.3 * was.size), fmt::format("was {}", fixed(before, 3)), was);
}

}  // namespace

Snapshot stack_at_rest(int boxes) {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < boxes; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .mass = 1});
  Snapshot stack = snapshot(scene);
  for (int i = 0; i < boxes; ++i)
    stack.contacts.push_back({.a = {i}, .b = {i + 1}, .position = {0, i}, .normal = {0, 1}});
  return stack;
}

Camera draw_stack_panel(Page& page, const render::Rect& view, const StackMoment& moment) {
  const auto boxes = static_cast<double>(moment.lambda.size());
  Camera camera = render::fit(view, {{-2.05, -ground_depth}, {2.05, boxes + 0.1}});
  camera.center.y() = 0.5 * view.height / camera.scale - ground_depth;
  render::WorldLook look;
  look.penetration = false;
  look.active_contact = moment.active;
  if (moment.active >= 0) {
    look.active_a = {moment.active};
    look.active_b = {moment.active + 1};
  }
  draw_world(page, camera, moment.stack, look);
  draw_pushes(page, camera, moment);
  for (int box = 0; box < moment.velocity.size(); ++box) draw_box_velocity(page, camera, moment, box);
  return camera;
}

}  // namespace cairn
