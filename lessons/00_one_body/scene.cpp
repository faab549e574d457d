// Lesson 00. The flight so far, where its three methods are, and how far they miss.
#include "lesson.hpp"

namespace cairn::one_body {

namespace {

constexpr int first_steps = 5;  // that have the plot of errors to themselves

/// All of the flight with the whole box at both ends, and room for arrows and labels.
Camera camera_of(const Rect& rect, const Story& story) {
  Aabb<double> seen = render::bounds_of(story.flight.cairn);
  for (const Vec2<double>& point : story.flight.explicit_euler) {
    const Vec2<double> half(1, 1);  // the box, and the arrow beyond it
    seen.lower = seen.lower.cwiseMin(point - half);
    seen.upper = seen.upper.cwiseMax(point + half);
  }
  return fit(rect, seen);
}

/// A level or upright length, with its text at its right.
void measure(Page& page, const Point& from, const Point& to, const std::string& text) {
  draw_length(page, from, to, {.width = page.sizes().axis, .color = page.theme().text});
  const TextStyle style = page.value();
  page.canvas().text({std::max(from.x(), to.x()) + 9, (from.y() + to.y() + 0.7 * style.size) / 2}, text,
                     style);
}

void draw_velocity(Page& page, const Camera& camera, const Story& story, const SnapshotBody& box) {
  double fastest = 0;  // [m/s] of the whole flight: one scale for all arrows
  for (const Snapshot& snapshot : story.flight.cairn)
    fastest = std::max(fastest, snapshot.bodies[{1}].velocity.head<2>().norm());
  // The fastest arrow is a little longer than the box is wide.
  const double longest = 1.1 * camera.scale;
  const ArrowScale scale = {.pixels_per_unit = longest / fastest, .longest = longest, .unit = "m/s"};
  const Vec2<double> velocity = box.velocity.head<2>();
  draw_arrow(page, camera, scale,
             {.kind = ArrowKind::velocity, .tail = box.pose.position, .value = velocity});
  const Point tip =
      camera.project(box.pose.position) + scale.pixels_per_unit * Point(velocity.x(), -velocity.y());
  TextStyle style = page.value();
  style.halo = page.theme().background;
  const std::string text = fixed(velocity.norm(), 2) + " m/s";
  const double width = page.canvas().text_width(text, style);
  const double size = style.size;
  page.place_text({tip + Point(-width - 18, -4), tip + Point(-width / 2, -2 * size),
                   tip + Point(14, size / 3), tip + Point(-width / 2, size + 14)},
                  camera.viewport, text, style);
  draw_scale_key(page, scale, {camera.viewport.x, camera.viewport.y + camera.viewport.height});
}

/// The last points of a path.
Span<const Vec2<double>> end_of(const List<Vec2<double>>& path, int step, int count) {
  const int first = std::max(0, step - count);
  return {path.data() + first, step - first + 1};
}

void draw_line(Page& page, const Camera& camera, Span<const Vec2<double>> path, const Stroke& stroke) {
  List<Point> points;
  for (const Vec2<double>& point : path) points.push_back(camera.project(point));
  page.canvas().polyline(points, stroke);
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

/// Where the three methods are, so much larger that their errors are seen as lengths.
void draw_enlarged(Page& page, const Camera& scene, const Flight& flight, int step) {
  const double error = height_above(flight, flight.explicit_euler, step);
  if (!(error > 0)) return;
  const Rect& view = scene.viewport;
  Camera camera = {.viewport = {view.x + 0.74 * view.width, view.y, 0.26 * view.width, 0.34 * view.height}};
  camera.scale = 0.26 * camera.viewport.height / error;
  const std::string times = fmt::format("{} times as large", fixed(camera.scale / scene.scale, 0));
  camera.viewport = page.panel(camera.viewport, times);
  // The three ends stand at the left, their lengths at the right.
  const double half_width = 0.5 * camera.viewport.width / camera.scale;
  camera.center = flight.exact[step] + Vec2<double>(0.4 * half_width, 0);
  const double thin = page.sizes().axis;
  const Point exact = camera.project(flight.exact[step]), aside(24, 0);
  page.canvas().push_clip(camera.viewport);
  draw_line(page, camera, end_of(flight.exact, step, 3), {.width = thin, .color = page.theme().exact.color});
  for (const auto& [path, style] : {std::pair{&flight.explicit_euler, explicit_style(page)},
                                    std::pair{&flight.semi_implicit, semi_implicit_style(page)}}) {
    draw_line(page, camera, end_of(*path, step, 3),
              {.width = page.sizes().curve, .color = style.color, .dash = style.dash});
    const Point end = camera.project((*path)[step]);
    draw_marker(page.canvas(), end, style.marker, 1.4 * page.sizes().marker, style.color);
    measure(page, exact + aside, end + aside, significant(error, 3) + " m");
  }
  page.canvas().pop_clip();
}

/// The starting height, to which the exact parabola comes back.
void draw_start(Page& page, const Camera& camera, const Flight& flight) {
  const Vec2<double> beside(0.62, 0);  // off the box and its tick
  page.canvas().line(camera.project(flight.exact.front() + beside), camera.project(flight.exact.back()),
                     {.width = page.sizes().axis, .color = page.theme().secondary_text, .dash = {8, 6}});
}

Series error_series(const Flight& flight, const List<Vec2<double>>& path, int step, const std::string& name,
                    const SeriesStyle& style) {
  Series series = {.name = name, .style = style};
  for (int i = 0; i <= step; ++i) series.add(flight.time[i], height_above(flight, path, i));
  return series;
}

}  // namespace

SeriesStyle semi_implicit_style(const Page& page) { return render::neutral_styles(page.theme())[1]; }
SeriesStyle explicit_style(const Page& page) { return render::neutral_styles(page.theme())[2]; }

void draw_scene(Page& page, const Rect& rect, const Story& story, const SceneLook& look) {
  const Camera camera = camera_of(rect, story);
  const Flight& flight = story.flight;
  List<Snapshot> earlier;
  for (int ghost = 0; ghost < 7; ++ghost) {
    const int at = ghost * flight.thrown.steps / 7;
    if (at < look.step) earlier.push_back(flight.cairn[at]);
  }
  draw_ghosts(page, camera, earlier);
  const Snapshot& now = flight.cairn[look.step];
  draw_world(page, camera, now, {.names = {"", ""}});
  if (look.step == flight.thrown.steps) draw_start(page, camera, flight);
  draw_line(page, camera, flight.exact, {.width = page.sizes().axis, .color = page.theme().exact.color});
  draw_trail(page, camera, end_of(flight.explicit_euler, look.step, look.step),
             path_style(explicit_style(page), look.step));
  draw_trail(page, camera, end_of(flight.semi_implicit, look.step, look.step),
             path_style(semi_implicit_style(page), look.step));
  draw_enlarged(page, camera, flight, look.step);
  if (look.velocity) draw_velocity(page, camera, story, now.bodies[{1}]);
  // How long a metre is, because the errors are lengths.
  const Point right(rect.x + rect.width - 48, rect.y + rect.height - 6);
  measure(page, right - Point(camera.scale, 0), right, "1 m");
}

void draw_errors(Page& page, const Rect& rect, const Story& story, int step) {
  const Flight& flight = story.flight;
  const int last = step <= first_steps ? first_steps : flight.thrown.steps;  // at first all would be one dot
  const double most = std::max(1.15 * std::abs(height_above(flight, flight.explicit_euler, last)), 1e-9);
  Plot plot = {.title = "height above the exact parabola (m)",
               .x = {.title = "t (s)", .min = 0, .max = flight.time[last]},
               .y = {.min = -most, .max = most}};
  plot.series.push_back(
      error_series(flight, flight.explicit_euler, step, "position first", explicit_style(page)));
  plot.series.push_back(
      error_series(flight, flight.semi_implicit, step, "velocity first", semi_implicit_style(page)));
  plot.goals.push_back({.y = 0, .text = "exact"});
  if (step < last) plot.cursor = flight.time[step];
  draw_plot(page, rect, plot);
}

}  // namespace cairn::one_body
