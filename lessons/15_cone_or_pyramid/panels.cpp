// The table from above with both pucks, and the plane of the friction forces with both limits.
#include "lesson.hpp"

namespace cairn::top_view {

namespace {

/// Both pucks on one table.
Snapshot both_pucks(const Slides& all, int k) {
  Snapshot both = all.circle.steps[k].snapshot;
  both.bodies.push_back(all.square.steps[k].snapshot.bodies[{1}]);
  return both;
}

void draw_path(Page& page, const Camera& camera, const Slide& slide, int k, const SeriesStyle& style) {
  List<Vec2<double>> path;
  for (int i = 0; i <= k; ++i) path.push_back(slide.steps[i].place);
  draw_trail(page, camera, path, {.color = style.color, .dash = style.dash});
}

void draw_puck_arrows(Page& page, const Camera& camera, const Slides& all, const SlideStep& step) {
  const double distance = all.settings.distance() * camera.scale;  // [px]
  const ArrowScale newtons{.pixels_per_unit = 0.16 * distance / all.settings.limit(), .longest = distance};
  const ArrowScale speeds{.pixels_per_unit = 0.3 * distance / all.settings.speed(), .longest = distance};
  if (step.velocity.norm() > 1e-9 * all.settings.speed()) {
    draw_arrow(page, camera, speeds,
               {.kind = ArrowKind::velocity, .tail = step.place, .value = step.velocity});
  }
  if (step.lambda.norm() > 1e-9 * all.settings.limit()) {
    draw_arrow(page, camera, newtons,
               {.kind = ArrowKind::friction, .tail = step.place, .value = step.lambda});
  }
}

/// The table with a line at every round metre or part of one.
Camera draw_floor(Page& page, const Rect& rect, const Slides& all) {
  const double distance = all.settings.distance();
  const Vec2<double> end = all.settings.velocity / all.settings.speed() * distance;
  const Aabb<double> seen = {{-0.26 * distance, -0.2 * distance},
                             {end.x() + 0.26 * distance, end.y() + 0.1 * distance}};
  const List<double> xs = render::round_ticks(-2 * distance, 2 * distance, 16);
  const double spacing = xs[1] - xs[0];
  const Rect inside = page.panel(rect, fmt::format("the table from above, grid {} m", significant(spacing)));
  const Camera camera = fit(inside, seen);
  const Stroke stroke{.width = 1, .color = page.theme().grid};
  page.canvas().push_clip(inside);
  for (const double at : xs) {
    page.canvas().line(camera.project({at, -2 * distance}), camera.project({at, 2 * distance}), stroke);
    page.canvas().line(camera.project({-2 * distance, at}), camera.project({2 * distance, at}), stroke);
  }
  page.canvas().pop_clip();
  return camera;
}

/// A puck in the colour of its limit, with the name of that beside it while it moves.
void draw_puck(Page& page, const Camera& camera, const Slides& all, int k, bool is_circle) {
  const SeriesStyle style = limit_style(page, is_circle);
  const double radius = all.settings.puck_radius() * camera.scale;
  const Slide& slide = is_circle ? all.circle : all.square;
  const Point at = camera.project(slide.steps[k].place);
  page.canvas().circle(
      at, radius,
      {.fill = style.color, .outline = page.theme().outline, .outline_width = page.sizes().outline});
  if (k + 1 == slide.steps.size()) return;
  TextStyle text = name_style(page, page.label().size, style.color);
  if (!is_circle) text.align = Align::right;
  const double beside = (is_circle ? 1 : -1) * (1.3 * radius + 4);
  page.place_text({{at.x() + beside, at.y() + 0.35 * text.size}, {at.x(), at.y() + radius + 1.2 * text.size}},
                  camera.viewport, is_circle ? "circle" : "square", text);
}

/// Where both pucks were, in their colours.
void draw_earlier(Page& page, const Camera& camera, const Slides& all, int k) {
  const int ghosts = 6, last = all.circle.steps.size() - 1;
  for (const bool is_circle : {true, false}) {
    const Slide& slide = is_circle ? all.circle : all.square;
    for (int i = 0; i * last / ghosts < k && i < ghosts; ++i)
      page.canvas().circle(
          camera.project(slide.steps[i * last / ghosts].place), all.settings.puck_radius() * camera.scale,
          {.outline = limit_style(page, is_circle).color, .outline_width = page.sizes().ghost});
  }
}

/// Axes, the square dashed and the circle in one piece.
void draw_limit_lines(Page& page, const Camera& camera, double limit, double reach) {
  const Stroke axis{.width = 1, .color = page.theme().inactive};
  page.canvas().line(camera.project({-reach, 0}), camera.project({reach, 0}), axis);
  page.canvas().line(camera.project({0, -reach}), camera.project({0, reach}), axis);
  const double width = page.sizes().curve;
  List<Point> corners;
  for (const Vec2<double>& corner : {Vec2<double>(-1, -1), Vec2<double>(1, -1), Vec2<double>(1, 1),
                                     Vec2<double>(-1, 1), Vec2<double>(-1, -1)}) {
    corners.push_back(camera.project(limit * corner));
  }
  const SeriesStyle square = limit_style(page, false);
  page.canvas().polyline(corners, {.width = width, .color = square.color, .dash = square.dash});
  List<Point> rim;
  for (int i = 0; i <= 96; ++i)
    rim.push_back(camera.project({limit * std::cos(i * pi / 48), limit * std::sin(i * pi / 48)}));
  page.canvas().polyline(rim, {.width = width, .color = limit_style(page, true).color});
}

void name_limits(Page& page, const Camera& camera, double limit) {
  const double size = page.tick().size;
  const Point corner = camera.project({-limit, limit});
  page.canvas().text({corner.x(), corner.y() - 8}, "square",
                     name_style(page, size, limit_style(page, false).color));
  TextStyle circle = aligned(name_style(page, size, limit_style(page, true).color), Align::right);
  page.canvas().text(camera.project({0.66 * limit, -0.64 * limit}), "circle", circle);
  TextStyle tick = aligned(page.tick(), Align::right);
  page.canvas().text(camera.project({limit, 0}) - Point(8, 6), fmt::format("μ λ_{{n}} = {:g} N", limit),
                     tick);
}

}  // namespace

SeriesStyle limit_style(const Page& page, bool is_circle) {
  return render::neutral_styles(page.theme())[is_circle ? 0 : 1];
}

TextStyle name_style(const Page& page, double size, const Color& color) {
  return {.size = std::max(size, render::large_text),  // or colours would be too pale
          .color = color,
          .bold = true,
          .halo = page.theme().panel};
}

Camera draw_table(Page& page, const Rect& rect, const Slides& all, int k) {
  const Camera camera = draw_floor(page, rect, all);
  draw_earlier(page, camera, all, k);
  draw_path(page, camera, all.circle, k, limit_style(page, true));
  draw_path(page, camera, all.square, k, limit_style(page, false));
  if (k == 0) draw_world(page, camera, both_pucks(all, k), {.numbers = false});
  for (const Slide* slide : {&all.circle, &all.square}) {
    if (k > 0) draw_puck(page, camera, all, k, slide == &all.circle);
    draw_puck_arrows(page, camera, all, slide->steps[k]);
  }
  return camera;
}

void draw_dimension(Page& page, const Camera& camera, const Vec2<double>& end, double aside,
                    const List<std::string>& lines, const Color& color) {
  const Point from = camera.project({0, 0}), to = camera.project(end);
  const Point along = (to - from).normalized(), across(-along.y(), along.x());
  draw_length(page, from + aside * across, to + aside * across, {.width = 2, .color = color});
  TextStyle style =
      aligned(name_style(page, page.sizes().title, color), aside > 0 ? Align::left : Align::right);
  Point at = 0.5 * (from + to) + (aside + (aside > 0 ? 14 : -14)) * across;
  if (aside < 0) at.y() -= 1.4 * style.size * (lines.size() - 1);  // clear of the line, which leans right
  for (const std::string& line : lines) {
    page.canvas().text(at, line, style);
    at.y() += 1.4 * style.size;
  }
}

Camera draw_limits(Page& page, const Rect& rect, const Slides& all, const Forces& forces) {
  const Rect inside = page.panel(rect, "friction λ and its limits (N)");
  const double limit = all.settings.limit();
  const double reach = 1.3 * limit;
  const Camera camera = fit(inside, {{-reach, -reach}, {reach, reach}});
  draw_limit_lines(page, camera, limit, reach);
  const double speed = forces.velocity.norm();
  if (speed > 1e-9 * all.settings.speed()) {
    const Vec2<double> along = forces.velocity / speed;
    page.canvas().line(camera.project({0, 0}), camera.project(-reach * along),
                       {.width = 1.5, .color = page.theme().velocity, .dash = {6, 5}});
    TextStyle against = page.label();
    against.halo = page.theme().panel;
    page.canvas().text(camera.project(-0.75 * reach * along) + Point(12, 0), "against v", against);
  }
  const ArrowScale scale{.pixels_per_unit = camera.scale, .longest = 1e4, .unit = "N"};
  for (const Vec2<double>& force : forces.grey) {
    draw_arrow(page, camera, scale, {.kind = ArrowKind::inactive, .value = force, .active = false});
  }
  for (const Vec2<double>& force : forces.active) {
    if (!(force.norm() > 1e-9 * limit)) continue;
    draw_arrow(page, camera, scale, {.kind = ArrowKind::friction, .value = force});
  }
  name_limits(page, camera, limit);
  return camera;
}

// Where all pucks stop that start in one place with one speed.

namespace {

/// Where all pucks stop that start in one place with one speed.
void draw_stops(Page& page, const Rect& rect, const Slides& all, int count) {
  const Rect inside = page.panel(rect, "where the pucks stop, by direction");
  const double distance = all.settings.distance();
  const double reach = 1.12 * distance;
  const Camera camera = fit(inside, {{-reach, -reach}, {reach, reach}});
  const Stroke thin{.width = 1, .color = page.theme().inactive};
  const Point start = camera.project({0, 0});
  List<Point> rim;
  List<Point> diamond;
  for (int i = 0; i <= 96; ++i) {
    const Vec2<double> along(std::cos(i * pi / 48), std::sin(i * pi / 48));
    rim.push_back(camera.project(stopping_distance(all.settings, all.settings.speed()) * along));
    diamond.push_back(camera.project(stop_on_rails(all.settings, all.settings.speed() * along)));
  }
  page.canvas().polyline(rim, {.width = 1.5, .color = limit_style(page, true).color});
  const SeriesStyle square_style = limit_style(page, false);
  page.canvas().polyline(diamond, {.width = 1.5, .color = square_style.color, .dash = square_style.dash});
  const double radius = page.sizes().marker;
  for (int i = 0; i < count; ++i) {
    const Direction& direction = all.directions[i];
    const Point circle = camera.project(direction.circle);
    const Point square = camera.project(direction.square);
    page.canvas().line(start, circle, thin);
    page.canvas().line(circle, square, {.width = 1.5, .color = page.theme().inactive, .dash = {4, 3}});
    draw_marker(page.canvas(), circle, limit_style(page, true).marker, radius, limit_style(page, true).color);
    draw_marker(page.canvas(), square, limit_style(page, false).marker, radius,
                limit_style(page, false).color);
  }
  for (const bool is_circle : {true, false}) {  // in the corners at the right, where no puck stops
    const Point at = camera.project({0.7 * distance, (is_circle ? 0.96 : -0.96) * distance});
    const SeriesStyle style = limit_style(page, is_circle);
    draw_marker(page.canvas(), at, style.marker, radius, style.color);
    page.canvas().text({at.x() + 2 * radius, at.y() + radius}, is_circle ? "circle" : "square", page.label());
  }
}

/// Something about where a puck stops, as a share of v^2 / 2 mu g.
using Measure = double (*)(const Vec2<double>& place);

/// The measure of the square over the direction in degrees, by its formula.
Series formula_series(const Page& page, Measure measure) {
  SeriesStyle style = limit_style(page, false);
  style.marker = Marker::none;
  Series series{.name = "square", .style = style, .markers = false};
  for (int i = 0; i <= 90; ++i) {
    const double c = std::cos(i * pi / 180);
    const double s = std::sin(i * pi / 180);
    series.add(i, measure({c * c, s * s}));
  }
  return series;
}

/// The measure of the slides that were made, from 0 to 90 degrees.
Series slides_series(const SeriesStyle& style, const Slides& all, int count, Vec2<double> Direction::*stop,
                     Measure measure) {
  // The circle's are a line, as they would cover the square's along the axes.
  const bool is_line = stop == &Direction::circle;
  Series series{.name = is_line ? "circle" : "", .style = style, .line = is_line, .markers = !is_line};
  for (int i = 0; i < std::min(count, 7); ++i) {
    const Direction& direction = all.directions[i];
    series.x.push_back(direction.degrees);
    // Half a step is what semi-implicit Euler lags behind.
    const Vec2<double> place = direction.*stop + 0.5 * all.settings.dt * direction.velocity;
    series.y.push_back(measure(place / all.settings.distance()));
  }
  return series;
}

List<Series> over_direction(const Page& page, const Slides& all, int count, Measure measure) {
  return {formula_series(page, measure),
          slides_series(limit_style(page, true), all, count, &Direction::circle, measure),
          slides_series(limit_style(page, false), all, count, &Direction::square, measure)};
}

double length_of(const Vec2<double>& place) { return place.norm(); }
double direction_of(const Vec2<double>& place) { return std::atan2(place.y(), place.x()) * 180 / pi; }

}  // namespace

void draw_directions(Page& page, const Slides& all, int count) {
  const List<Rect> parts = in_columns(page, {0.46, {0.54, {0.5, 0.5}}});
  draw_stops(page, parts[0], all, count);
  Plot length{.title = "distance to the stop / (v²/2μg)"};
  length.x = {.title = "direction of the start (°)", .min = 0, .max = 90};
  length.y = {.title = "", .min = 0.6, .max = 1.1};
  length.series = over_direction(page, all, count, length_of);
  length.goals = {{std::sqrt(0.5), "1/√2"}};
  draw_plot(page, parts[1], length);
  Plot angle{.title = "direction of the stop (°)"};
  angle.x = length.x;
  angle.y = {.title = "", .min = 0, .max = 90};
  angle.series = over_direction(page, all, count, direction_of);
  draw_plot(page, parts[2], angle);
}

}  // namespace cairn::top_view
