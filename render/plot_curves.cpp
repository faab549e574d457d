// The curves of a plot and their markers.
#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/math/list.hpp>
#include "render/plot_parts.hpp"
#include "render/rects.hpp"

namespace cairn::render {
namespace {

constexpr int markers_of_curve = 6;
constexpr int all_marked = 16;  // a curve with so few points shows every one of them

// Goes on with the last piece where it ended, or begins another.
void append(List<List<Point>>& pieces, const LineSegment& segment) {
  if (pieces.empty() || pieces.back().back() != segment.from) {
    pieces.emplace_back();
    pieces.back().push_back(segment.from);
  }
  pieces.back().push_back(segment.to);
}

// Evenly along the curve; each series begins at another place, so that curves that coincide are told apart.
List<Point> marked_points(const Curve& curve, int series) {
  const List<Point>& points = curve.points;
  if (points.size() <= all_marked) return points;
  List<double> along = {0};
  for (int i = 1; i < points.size(); ++i) along.push_back(along.back() + (points[i] - points[i - 1]).norm());
  List<Point> marked;
  int next = 0;
  for (int i = 0; i < markers_of_curve; ++i) {
    const double part = i + 0.15 + 0.2 * series;
    const double wanted = along.back() * part / markers_of_curve;
    while (next + 1 < points.size() && std::abs(along[next + 1] - wanted) <= std::abs(along[next] - wanted))
      ++next;
    if (marked.empty() || marked.back() != points[next]) marked.push_back(points[next]);
  }
  return marked;
}

bool is_near(const List<Point>& drawn, const Point& at, double distance) {
  return std::any_of(drawn.begin(), drawn.end(),
                     [&](const Point& other) { return (other - at).norm() < distance; });
}

void draw_markers(Page& page, const Series& series, const List<Point>& points, bool is_choice,
                  List<Point>& drawn) {
  const double radius = page.sizes().marker;
  const Paint solid{.fill = series.style.color, .outline = page.theme().panel, .outline_width = 1};
  const Paint hollow{.outline = series.style.color, .outline_width = 0.6 * page.sizes().curve};
  const List<Point> earlier = drawn;
  const auto is_taken = [&](const Point& at) { return is_near(earlier, at, 1.5 * radius); };
  const bool all_taken = std::all_of(points.begin(), points.end(), is_taken);
  for (const Point& at : points) {
    // A marker upon another curve's marker goes around it. A curve does without it where its markers are a
    // choice.
    const bool taken = is_taken(at);
    if (taken && series.line && !all_taken && is_choice) continue;
    const bool around = taken && (is_choice || !series.line);
    paint_marker(page.canvas(), at, series.style.marker, around ? 1.6 * radius : radius,
                 around ? hollow : solid);
    drawn.push_back(at);
  }
}

}  // namespace

bool meets(const Curve& curve, const Rect& rect) {
  for (const List<Point>& piece : curve.pieces) {
    for (int i = 1; i < piece.size(); ++i) {
      LineSegment segment{piece[i - 1], piece[i]};
      if (clip(segment, rect)) return true;
    }
  }
  return std::any_of(curve.points.begin(), curve.points.end(),
                     [&](const Point& p) { return contains(rect, p); });
}

Curve curve_of(const PlotFrame& frame, const Series& series) {
  Curve curve;
  const double none = std::numeric_limits<double>::quiet_NaN();
  Point before(none, none);
  for (int i = 0; i < series.x.size(); ++i) {
    if (!plottable(series.x[i], frame.x.scale) || !plottable(series.y[i], frame.y.scale)) {
      before = {none, none};
      continue;
    }
    const Point point = frame.pixel(series.x[i], series.y[i]);
    if (contains(frame.box, point)) curve.points.push_back(point);
    if (series.line && before.allFinite()) {
      LineSegment segment{before, point};
      if (clip(segment, frame.box)) append(curve.pieces, segment);
    }
    before = point;
  }
  return curve;
}

void draw_background(Page& page, const PlotFrame& frame, const Plot& plot) {
  Canvas& canvas = page.canvas();
  canvas.push_clip(frame.box);
  const Series front{.x = plot.front.x, .y = plot.front.y};
  for (const List<Point>& piece : curve_of(frame, front).pieces) {
    canvas.polyline(piece, {.width = 4 * page.sizes().curve, .color = faded(page.theme().exact.color, 0.25)});
  }
  const Series cloud{.x = plot.cloud.x, .y = plot.cloud.y, .line = false};
  for (const Point& at : curve_of(frame, cloud).points) {
    canvas.circle(at, 0.5 * page.sizes().marker, {.fill = faded(page.theme().secondary_text, 0.5)});
  }
  canvas.pop_clip();
}

void draw_curves(Page& page, const PlotFrame& frame, const Plot& plot, const List<Curve>& curves) {
  Canvas& canvas = page.canvas();
  canvas.push_clip(frame.box);
  for (int i = 0; i < curves.size(); ++i) {
    const SeriesStyle& style = plot.series[i].style;
    for (const List<Point>& piece : curves[i].pieces) {
      canvas.polyline(piece, {.width = page.sizes().curve, .color = style.color, .dash = style.dash});
      page.note_curve(piece);
    }
  }
  List<Point> drawn;
  for (int i = 0; i < curves.size(); ++i) {
    const Series& series = plot.series[i];
    const bool lone = series.line && curves[i].points.size() == 1;  // a line of one point would not be seen
    if (!series.markers && series.line && !lone) continue;
    Series shown{.style = series.style, .line = series.line};
    if ((!series.line || lone) && shown.style.marker == Marker::none) shown.style.marker = Marker::circle;
    draw_markers(page, shown, series.line ? marked_points(curves[i], i) : curves[i].points,
                 series.line && curves[i].points.size() > all_marked, drawn);
  }
  canvas.pop_clip();
}

void paint_marker(Canvas& canvas, const Point& at, Marker marker, double radius, const Paint& paint) {
  const Point right(radius, 0);
  const Point down(0, radius);
  List<Point> corners;
  switch (marker) {
    case Marker::none:
      return;
    case Marker::circle:
      canvas.circle(at, radius, paint);
      return;
    case Marker::tick: {
      const bool filled = paint.fill.a > 0;
      canvas.line(at - 1.3 * down, at + 1.3 * down,
                  {.width = 2, .color = filled ? paint.fill : paint.outline});
      return;
    }
    // Sized so that all of them look equally large.
    case Marker::square:
      corners = {at - 0.9 * right - 0.9 * down, at + 0.9 * right - 0.9 * down, at + 0.9 * right + 0.9 * down,
                 at - 0.9 * right + 0.9 * down};
      break;
    case Marker::triangle:
      corners = {at - 1.3 * down, at + 1.15 * right + 0.75 * down, at - 1.15 * right + 0.75 * down};
      break;
    case Marker::diamond:
      corners = {at - 1.3 * down, at + 1.3 * right, at + 1.3 * down, at - 1.3 * right};
      break;
  }
  canvas.polygon(corners, paint);
}

void draw_marker(Canvas& canvas, const Point& at, Marker marker, double radius, Color color) {
  paint_marker(canvas, at, marker, radius, {.fill = color});
}

}  // namespace cairn::render
