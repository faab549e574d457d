// Where all pucks stop that start in one place with one speed.
#include "lesson.hpp"

namespace cairn::top_view {

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
  page.canvas().polyline(rim, {.width = 1.5, .color = page.theme().si.color, .dash = page.theme().si.dash});
  page.canvas().polyline(diamond, {.width = 1.5, .color = page.theme().box2d.color});
  const double radius = page.sizes().marker;
  for (int i = 0; i < count; ++i) {
    const Direction& direction = all.directions[i];
    const Point circle = camera.project(direction.circle);
    const Point square = camera.project(direction.square);
    page.canvas().line(start, circle, thin);
    page.canvas().line(circle, square, {.width = 1.5, .color = page.theme().inactive, .dash = {4, 3}});
    draw_marker(page.canvas(), circle, page.theme().si.marker, radius, page.theme().si.color);
    draw_marker(page.canvas(), square, page.theme().box2d.marker, radius, page.theme().box2d.color);
  }
  for (const bool is_circle : {true, false}) {  // in the corners at the right, where no puck stops
    const Point at = camera.project({0.7 * distance, (is_circle ? 0.96 : -0.96) * distance});
    const SeriesStyle& style = is_circle ? page.theme().si : page.theme().box2d;
    draw_marker(page.canvas(), at, style.marker, radius, style.color);
    page.canvas().text({at.x() + 2 * radius, at.y() + radius}, is_circle ? "circle" : "square", page.label());
  }
}

/// Something about where a puck stops, as a share of v^2 / 2 mu g.
using Measure = double (*)(const Vec2<double>& place);

/// The measure of the square over the direction in degrees, by its formula.
Series formula_series(const Page& page, Measure measure) {
  SeriesStyle thin = page.theme().exact;
  thin.marker = Marker::none;
  Series series{.style = thin, .markers = false};
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
  Series series{.style = style, .line = is_line, .markers = !is_line};
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
          slides_series(page.theme().si, all, count, &Direction::circle, measure),
          slides_series(page.theme().box2d, all, count, &Direction::square, measure)};
}

double length_of(const Vec2<double>& place) { return place.norm(); }
double direction_of(const Vec2<double>& place) { return std::atan2(place.y(), place.x()) * 180 / pi; }

}  // namespace

void draw_directions(Page& page, const Slides& all, int count) {
  const List<Rect> parts = in_columns(page, {0.46, {0.54, {0.5, 0.5}}});
  draw_stops(page, parts[0], all, count);
  Plot length{.title = "distance to the stop / (v²/2μg), the curve by formula"};
  length.x = {.title = "direction of the start (°)", .min = 0, .max = 90};
  length.y = {.title = "", .min = 0.6, .max = 1.1};
  length.series = over_direction(page, all, count, length_of);
  length.goals = {{std::sqrt(0.5), "1/√2"}};
  draw_plot(page, parts[1], length);
  Plot angle{.title = "direction of the stop (°), the curve by formula"};
  angle.x = length.x;
  angle.y = {.title = "", .min = 0, .max = 90};
  angle.series = over_direction(page, all, count, direction_of);
  draw_plot(page, parts[2], angle);
}

}  // namespace cairn::top_view
