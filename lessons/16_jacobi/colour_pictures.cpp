// The contacts of the pyramid as a graph: which colour each has, and what goes at the same time.
#include "lesson.hpp"

#include "render/lint.hpp"

namespace cairn::everybody {

namespace {

/// From the middle of one box to the middle of the other; from the ground straight up.
struct Edge {
  Point from = {0, 0};
  Point to = {0, 0};
};

Edge edge_of(const Camera& camera, const Snapshot& snapshot, const ColouredContact& contact) {
  const Vec2<double> upper = snapshot.bodies[contact.b].pose.position;
  Vec2<double> lower = snapshot.bodies[contact.a].pose.position;
  if (contact.a == ground) lower = {upper.x(), 0};
  return {camera.project(lower), camera.project(upper)};
}

/// What a colour of the graph looks like.
Color color_of(const Page& page, int colour) {
  const Theme& theme = page.theme();
  const FixedList<Color, 4> colors = {theme.positive, theme.velocity, theme.penetration, theme.negative};
  return colors[colour % colors.size()];
}

/// All contacts, each in its colour, with the number of that.
void draw_graph(Page& page, const Rect& rect, const PileRun& run) {
  const Rect inside = page.panel(rect, "contacts, each in its colour");
  const Camera camera = pyramid_camera(inside, run.settings.base);
  draw_world(page, camera, run.snapshot, {.numbers = false, .contacts = false});
  for (const ColouredContact& contact : run.contacts.contacts) {
    const Edge edge = edge_of(camera, run.snapshot, contact);
    page.canvas().line(edge.from, edge.to,
                       {.width = page.sizes().arrow, .color = color_of(page, contact.colour)});
  }
  TextStyle text = page.value();
  text.bold = true;
  text.align = Align::center;
  const double radius = 0.72 * text.size;
  for (const ColouredContact& contact : run.contacts.contacts) {
    const Edge edge = edge_of(camera, run.snapshot, contact);
    const double share = contact.a == ground ? 0.0 : 0.5;
    const Point middle = edge.from + share * (edge.to - edge.from);
    const Color fill = color_of(page, contact.colour);
    page.canvas().circle(middle, radius, {.fill = fill, .outline = page.theme().outline, .outline_width = 1});
    text.color = render::ink_on(fill);
    text.halo = fill;
    page.canvas().text({middle.x(), middle.y() + 0.36 * text.size}, fmt::format("{}", contact.colour + 1),
                       text);
  }
}

/// One turn: the contacts of a colour, and the boxes that they hold; every box has one at most.
void draw_turn(Page& page, const Rect& rect, const PileRun& run, int colour) {
  const int count = run.contacts.count[colour];
  const Rect inside =
      page.panel(rect, fmt::format("turn {}: {} contact{}", colour + 1, count, count == 1 ? "" : "s"));
  const Camera camera = pyramid_camera(inside, run.settings.base);
  for (const SnapshotBody& body : run.snapshot.bodies) {
    if (body.type != BodyType::dynamic) continue;
    const Point low = camera.project(body.pose.position - Vec2<double>(0.5, 0.5));
    const Point high = camera.project(body.pose.position + Vec2<double>(0.5, 0.5));
    page.canvas().rect({low.x(), high.y(), high.x() - low.x(), low.y() - high.y()},
                       {.fill = page.theme().body, .outline = page.theme().inactive, .outline_width = 1});
  }
  const Point left = camera.project({-0.625 * run.settings.base, 0});
  const Point right = camera.project({0.625 * run.settings.base, 0});
  page.canvas().line(left, right, {.width = page.sizes().axis, .color = page.theme().outline});
  const render::Paint dot{
      .fill = color_of(page, colour), .outline = page.theme().outline, .outline_width = 1};
  for (const ColouredContact& contact : run.contacts.contacts) {
    if (contact.colour != colour) continue;
    const Edge edge = edge_of(camera, run.snapshot, contact);
    page.canvas().line(edge.from, edge.to, {.width = 1.4 * page.sizes().arrow, .color = dot.fill});
    page.canvas().circle(edge.to, 1.4 * page.sizes().contact, dot);
    if (contact.a != ground) page.canvas().circle(edge.from, 1.4 * page.sizes().contact, dot);
  }
}

}  // namespace

Camera pyramid_camera(const Rect& inside, int base) {
  const double half = 0.625 * base + 0.2;
  return fit(inside, {{-half, -0.3}, {half, base + 0.1}});
}

void draw_colours(Page& page, const PileRun& run) {
  const List<Rect> parts = in_columns(page, {0.44, {0.56, {0.77, 0.23}}});
  draw_graph(page, parts[0], run);
  const int turns = run.contacts.count.size();
  const int across = (turns + 1) / 2;
  const List<Rect> lines = in_rows(page, parts[1], {1, 1});
  for (int k = 0; k < turns; ++k) {
    const List<Rect> panels = in_columns(page, lines[k / across], List<Cut>(across, 1.0));
    draw_turn(page, panels[k % across], run, k);
  }
  const int contacts = run.contacts.contacts.size();
  page.note(
      parts[2], "Gauss-Seidel in parallel",
      fmt::format(
          "In one turn no box has two contacts, so no contact waits for another: {} turns for {} contacts. "
          "{} boxes at the bottom: {} turns of {}.",
          turns, contacts, larger_base, run.larger.count.size(), counts_text(run.larger)));
}

}  // namespace cairn::everybody
