// The scene: islands in frames, and those that sleep pale.
#include <fmt/format.h>

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

/// "40 rows × 50 sweeps": what an island has taken by itself in this step; before the first step only its
/// rows.
std::string swept_text(const NeedsRun& all, int stage, int step) {
  const StageBill bill = all.runs[by_islands].steps[std::max(step, 1) - 1].stages[stage];
  const std::string sweeps = step == 0 ? "?" : fmt::format("{}", bill.sweeps);
  return fmt::format("{} rows × {} sweep{}", bill.rows, sweeps, sweeps == "1" ? "" : "s");
}

/// A frame around an island, dashed while it is awake, with its name and another line.
void draw_island(Page& page, const render::Camera& camera, const Island& island, const std::string& name,
                 const std::string& line) {
  const render::Theme& theme = page.theme();
  const double margin = 0.25;  // [m]
  const Point low =
      camera.project({island.box.lower.x() - margin, std::max(0.0, island.box.lower.y() - margin)});
  const Point high = camera.project({island.box.upper.x() + margin, island.box.upper.y() + margin});
  const bool asleep = island.awake == 0;
  const List<Point> frame = {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
  page.canvas().polyline(frame, {.width = page.sizes().axis,
                                 .color = asleep ? theme.inactive : theme.outline,
                                 .dash = asleep ? List<double>{2, 5} : List<double>{8, 5}});
  render::TextStyle text = page.tick();
  text.align = render::Align::center;
  text.halo = theme.panel;
  const double x = (low.x() + high.x()) / 2, above = high.y() - 0.4 * text.size;
  page.canvas().text({x, above}, line, text);
  text.bold = true;
  page.canvas().text({x, above - 1.2 * text.size}, name + (asleep ? ": asleep" : ""), text);
}

Aabb<double> view_of(const NeedsSettings& settings) {
  const double right = 20 + 0.8 * settings.links;
  const double top = std::max({settings.tower + 0.4, 0.8 * settings.links + 1.6, 6.5});
  return {{-10, -0.45}, {right, top}};
}

}  // namespace

void draw_scene(Page& page, const Rect& rect, const NeedsRun& all, int step) {
  const Rect inside = page.panel(
      rect,
      step == 0 ? "" : "rows × sweeps of the run \"exit by island\"; pale: asleep in the run \"sleep\"");
  const double words = 2.9 * page.sizes().tick;  // two lines above the highest frame
  const render::Camera camera =
      render::fit({inside.x, inside.y + words, inside.width, inside.height - words}, view_of(all.settings));
  const Snapshot& now = all.runs[shown].frames[step];
  page.canvas().push_clip(inside);
  draw_world(page, camera, now, {.numbers = false, .contacts = false, .penetration = false});
  const SnapshotBody& ball = now.bodies[ball_of(all.settings)];
  if (step < all.touch) {
    draw_arrow(
        page, camera, {.pixels_per_unit = 0.3 * camera.scale, .longest = 4 * camera.scale},
        {.kind = render::ArrowKind::velocity, .tail = ball.pose.position, .value = ball.velocity.head<2>()});
  }
  draw_island(page, camera, island_of(all, now, Group::pyramid), "pyramid", swept_text(all, 0, step));
  draw_island(page, camera, island_of(all, now, Group::tower), "tower", swept_text(all, 1, step));
  draw_island(page, camera, island_of(all, now, Group::chain), "chain", swept_text(all, 2, step));
  page.canvas().pop_clip();
}

void draw_pyramid(Page& page, const Rect& rect, const NeedsRun& all, int run) {
  const Rect inside = page.panel(rect, all.runs[run].switches.name + "; thin: before the hit");
  const render::Camera camera = render::fit(inside, {{-5.5, -0.45}, {7.5, 5.5}});
  page.canvas().push_clip(inside);
  draw_ghosts(page, camera, {&all.runs[run].frames[all.touch - 1], 1});  // before the hit
  draw_world(page, camera, all.runs[run].frames.back(),
             {.numbers = false, .contacts = false, .penetration = false});
  page.canvas().pop_clip();
}

}  // namespace cairn::needs
