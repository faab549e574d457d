// The scene: islands in frames, and those that sleep pale.
#include "lesson.hpp"

namespace cairn::needs {

namespace {

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

/// A frame around an island, dashed while it is awake, with its name and another line.
void draw_island(Page& page, const Camera& camera, const Island& island, const std::string& name,
                 const std::string& line) {
  const Theme& theme = page.theme();
  const double margin = 0.25 + page.sizes().joint / camera.scale;  // [m]
  const Point low =
      camera.project({island.box.lower.x() - margin, std::max(0.0, island.box.lower.y() - margin)});
  const Point high = camera.project({island.box.upper.x() + margin, island.box.upper.y() + margin});
  const bool asleep = island.awake == 0;
  const List<Point> frame = {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
  page.canvas().polyline(frame, {.width = page.sizes().axis,
                                 .color = asleep ? theme.inactive : theme.outline,
                                 .dash = asleep ? List<double>{2, 5} : List<double>{8, 5}});
  TextStyle text = aligned(page.tick(), Align::center);
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

List<std::string> swept_lines(const NeedsRun& all, int run, int step) {
  List<std::string> lines;
  for (const StageBill& bill : all.runs[run].steps[std::max(step, 1) - 1].stages) {
    const std::string sweeps = step == 0 ? "?" : fmt::format("{}", bill.sweeps);
    lines.push_back(bill.rows == 0
                        ? "no rows"
                        : fmt::format("{} rows × {} sweep{}", bill.rows, sweeps, sweeps == "1" ? "" : "s"));
  }
  return lines;
}

void draw_scene(Page& page, const Rect& rect, const NeedsRun& all, const SceneView& view) {
  const Rect inside = page.panel(rect, view.title);
  const double words = 2.9 * page.sizes().tick;  // two lines above the highest frame
  const Camera camera =
      fit({inside.x, inside.y + words, inside.width, inside.height - words}, view_of(all.settings));
  const Snapshot& now = all.runs[view.run].frames[view.step];
  page.canvas().push_clip(inside);
  draw_world(page, camera, now, {.numbers = false, .contacts = false, .penetration = false});
  const SnapshotBody& ball = now.bodies[ball_of(all.settings)];
  if (view.step < all.touch) {
    draw_arrow(page, camera, {.pixels_per_unit = 0.3 * camera.scale, .longest = 4 * camera.scale},
               {.kind = ArrowKind::velocity, .tail = ball.pose.position, .value = ball.velocity.head<2>()});
  }
  const FixedList<std::string, 3> names = {"pyramid", "tower", "chain"};
  const FixedList<Group, 3> groups = {Group::pyramid, Group::tower, Group::chain};
  for (int i = 0; i < names.size(); ++i)
    draw_island(page, camera, island_of(all, now, groups[i]), names[i], view.lines[i]);
  page.canvas().pop_clip();
}

}  // namespace cairn::needs
