// The scene: islands in frames, and those that sleep pale.
#include <algorithm>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"

namespace cairn::needs {

namespace {

using render::Page;
using render::Point;
using render::Rect;

const int shown = sleeping;  // the run whose bodies are drawn

/// What an island of the frame is like.
struct Island {
  Aabb<double> box = {};
  int bodies = 0;
  int awake = 0;
};

Island island_of(const NeedsRun& all, const Snapshot& now, Group group) {
  Snapshot part = now;
  part.bodies.resize(1);
  Island island;
  for (const BodyId body : now.bodies.indices()) {
    if (group_of(all.settings, body) != group) continue;
    part.bodies.push_back(now.bodies[body]);
    ++island.bodies;
    island.awake += now.bodies[body].awake ? 1 : 0;
  }
  island.box = render::bounds_of(List<Snapshot>{part});
  return island;
}

/// A dashed frame around an island, with its name and whether it sleeps.
void draw_island(Page& page, const render::Camera& camera, const Island& island, const std::string& name) {
  const render::Theme& theme = page.theme();
  const double margin = 0.25;  // [m]
  const Point low =
      camera.project({island.box.lower.x() - margin, std::max(0.0, island.box.lower.y() - margin)});
  const Point high = camera.project({island.box.upper.x() + margin, island.box.upper.y() + margin});
  const bool asleep = island.awake == 0;
  const List<Point> frame = {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
  page.canvas().polyline(frame, {.width = page.sizes().axis,
                                 .color = asleep ? theme.inactive : theme.si.color,
                                 .dash = asleep ? List<double>{2, 5} : List<double>{8, 5}});
  render::TextStyle text = page.tick();
  text.align = render::Align::center;
  text.halo = theme.panel;
  const std::string state = asleep ? "asleep" : "awake";
  const double x = (low.x() + high.x()) / 2, above = high.y() - 0.4 * text.size;
  const List<Point> places = {{x, above},
                              {x, above - 1.3 * text.size},
                              {x, low.y() + 1.3 * text.size},
                              {x, above - 2.6 * text.size},
                              {x, low.y() + 2.6 * text.size}};
  page.place_text(places, camera.viewport, name + ": " + state, text);
}

Aabb<double> view_of(const NeedsSettings& settings) {
  const double right = 20 + 0.8 * settings.links;
  const double top = std::max({settings.tower + 1.9, 0.8 * settings.links + 2.6, 7.4});
  return {{-10, -0.45}, {right, top}};
}

}  // namespace

void draw_scene(Page& page, const Rect& rect, const NeedsRun& all, int step) {
  const Rect inside = page.panel(rect, "");
  const render::Camera camera = render::fit(inside, view_of(all.settings));
  const Snapshot& now = all.runs[shown].frames[step];
  page.canvas().push_clip(inside);
  draw_world(page, camera, now, {.numbers = false, .contacts = false, .penetration = false});
  const SnapshotBody& ball = now.bodies[ball_of(all.settings)];
  if (step < all.touch) {
    draw_arrow(
        page, camera, {.pixels_per_unit = 0.3 * camera.scale, .longest = 4 * camera.scale},
        {.kind = render::ArrowKind::velocity, .tail = ball.pose.position, .value = ball.velocity.head<2>()});
  }
  draw_island(page, camera, island_of(all, now, Group::pyramid), "pyramid");
  draw_island(page, camera, island_of(all, now, Group::tower), "tower");
  draw_island(page, camera, island_of(all, now, Group::chain), "chain");
  page.canvas().pop_clip();
}

void draw_pyramid(Page& page, const Rect& rect, const NeedsRun& all, int run) {
  const Rect inside = page.panel(rect, all.runs[run].switches.name);
  const render::Camera camera = render::fit(inside, {{-5.5, -0.45}, {7.5, 5.5}});
  page.canvas().push_clip(inside);
  draw_world(page, camera, all.runs[run].frames.back(),
             {.numbers = false, .contacts = false, .penetration = false});
  page.canvas().pop_clip();
}

}  // namespace cairn::needs
