// Lesson 00. What the frames share: the page's parts, the flight so far, and its error.
#include "scene.hpp"

#include <algorithm>
#include <cmath>

#include "math/list.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::one_body {

using namespace render;

namespace {

constexpr int first_steps = 5;  // that have the plot of errors to themselves

/// All of the flight with the whole box at both ends, and room for arrows and labels.
Camera camera_of(const Page& page, const Story& story) {
  Aabb<double> seen = bounds_of(story.flight.cairn);
  for (const Vec2<double>& point : story.flight.explicit_euler) {
    const Vec2<double> half(1, 1);  // the box, and the arrow beyond it
    seen.lower = seen.lower.cwiseMin(point - half);
    seen.upper = seen.upper.cwiseMax(point + half);
  }
  return fit(layout_of(page).scene, seen);
}

Span<const Vec2<double>> first(const List<Vec2<double>>& path, int step) { return {path.data(), step + 1}; }

/// The fastest arrow is a little longer than the box is wide.
ArrowScale velocity_scale(const Camera& camera, const Story& story) {
  const double longest = 1.1 * camera.scale;
  return {.pixels_per_unit = longest / story.fastest, .longest = longest, .unit = "m/s"};
}

void draw_velocity(Page& page, const Camera& camera, const ArrowScale& scale, const Snapshot& now) {
  const SnapshotBody& box = now.bodies[{1}];
  const Vec2<double> velocity = box.velocity.head<2>();
  draw_arrow(page, camera, scale,
             {.kind = ArrowKind::velocity, .tail = box.pose.position, .value = velocity});
  const Point tip =
      camera.project(box.pose.position) + scale.pixels_per_unit * Point(velocity.x(), -velocity.y());
  TextStyle style = page.value();
  style.halo = page.theme().background;
  const double size = style.size;
  const std::string text = fixed(velocity.norm(), 2) + " m/s";
  const double width = page.canvas().text_width(text, style);
  const List<Point> places = {tip + Point(10, size / 3), tip + Point(-width - 18, size / 3),
                              tip + Point(-width / 2, -14), tip + Point(-width / 2, size + 14)};
  page.place_text(places, layout_of(page).scene, text, style);
}

/// How long a metre is, because the answer is a length.
void draw_metre(Page& page, const Camera& camera) {
  const Rect scene = layout_of(page).scene;
  const TextStyle style = page.value();
  const double y = scene.y + scene.height - style.size / 3;
  const double width = page.canvas().text_width("1 m", style);
  const double right = scene.x + scene.width - width - 16, left = right - camera.scale;
  const render::Stroke stroke = {.width = page.sizes().axis, .color = page.theme().text, .dash = {}};
  page.canvas().line({left, y}, {right, y}, stroke);
  for (const double end : {left, right}) page.canvas().line({end, y - 5}, {end, y + 5}, stroke);
  page.canvas().text({right + 8, y + style.size / 3}, "1 m", style);
}

void draw_parabola(Page& page, const Camera& camera, const Flight& flight) {
  List<Point> points;
  for (const Vec2<double>& point : flight.exact) points.push_back(camera.project(point));
  page.canvas().polyline(points, {.width = page.sizes().axis, .color = page.theme().exact.color, .dash = {}});
  page.note_curve(points);
}

/// Markers on a path of a few pixels would hide it.
SeriesStyle path_style(SeriesStyle style, int step) {
  if (step < 10) style.marker = Marker::none;
  return style;
}

/// Above the parabola after so many steps [m].
double height_above(const Flight& flight, const List<Vec2<double>>& path, int step) {
  return path[step].y() - flight.exact[step].y();
}

Series error_series(const Flight& flight, const List<Vec2<double>>& path, int step, const std::string& name,
                    const SeriesStyle& style) {
  Series series = {.name = name, .style = style};
  for (int i = 0; i <= step; ++i) {
    series.x.push_back(flight.time[i]);
    series.y.push_back(height_above(flight, path, i));
  }
  return series;
}

}  // namespace

Layout layout_of(const Page& page) {
  const List<Rect> halves = columns(page.area(), {60, 40}, page.sizes().gap);
  const List<Rect> panels = rows(halves[1], {62, 38}, page.sizes().gap);
  return {halves[0], panels[0], panels[1]};
}

void draw_scene(Page& page, const Story& story, int step) {
  const Camera camera = camera_of(page, story);
  const Theme& theme = page.theme();
  const Flight& flight = story.flight;
  List<Snapshot> earlier;
  for (int ghost = 0; ghost < 7; ++ghost) {
    const int at = ghost * flight.thrown.steps / 7;
    if (at < step) earlier.push_back(flight.cairn[at]);
  }
  draw_ghosts(page, camera, earlier);
  const Snapshot& now = flight.cairn[step];
  draw_world(page, camera, now, {.names = {"", ""}});
  draw_parabola(page, camera, flight);
  draw_trail(page, camera, first(flight.explicit_euler, step), path_style(theme.jacobi, step));
  draw_trail(page, camera, first(flight.semi_implicit, step), path_style(theme.si, step));
  const ArrowScale scale = velocity_scale(camera, story);
  draw_velocity(page, camera, scale, now);
  draw_scale_key(page, scale, {page.area().x, page.area().y + page.area().height});
  draw_metre(page, camera);
}

void draw_errors(Page& page, const Rect& rect, const Story& story, int step) {
  const Flight& flight = story.flight;
  const int last = step <= first_steps ? first_steps : flight.thrown.steps;  // at first all would be one dot
  const double most = std::max(1.15 * std::abs(height_above(flight, flight.explicit_euler, last)), 1e-9);
  Plot plot = {.title = "height above the exact parabola (m)"};
  plot.x = {.title = "t (s)", .min = 0, .max = flight.time[last]};
  plot.y = {.title = "", .min = -most, .max = most};
  plot.series.push_back(error_series(flight, flight.explicit_euler, step, "explicit", page.theme().jacobi));
  plot.series.push_back(error_series(flight, flight.semi_implicit, step, "semi-implicit", page.theme().si));
  plot.goals.push_back({.y = 0, .text = "exact"});
  plot.cursor = flight.time[step];
  draw_plot(page, rect, plot);
}

}  // namespace cairn::one_body
