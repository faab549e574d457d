// The words in a plot: names of the curves at their ends, texts of the goal lines.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <cairn/math/list.hpp>
#include "render/lint.hpp"
#include "render/plot_parts.hpp"
#include "render/rects.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr double leader = 14;   // [px] from the box to the marker of a name
constexpr double air = 8;       // [px] from that marker to the name, and behind it
constexpr double together = 3;  // [px] less than this apart, ends are one place

struct EndLabel {
  int series = 0;
  Point end = {0, 0};  // of the curve
};

// The end further right: most curves begin at the left, but not all.
Point end_of(const Curve& curve) {
  List<Point> ends;
  for (const List<Point>& piece : curve.pieces) ends.insert(ends.end(), {piece.front(), piece.back()});
  if (!curve.points.empty()) ends.insert(ends.end(), {curve.points.front(), curve.points.back()});
  return *std::max_element(ends.begin(), ends.end(),
                           [](const Point& a, const Point& b) { return a.x() < b.x() + 1e-6; });
}

bool is_empty(const Curve& curve) { return curve.points.empty() && curve.pieces.empty(); }

// So far from the right end of the box, a curve has its name beside it: but not in a plot with a cursor,
// whose curves grow from frame to frame while names should stand still.
bool ends_early(const PlotFrame& frame, const Plot& plot, const Curve& curve) {
  return !plot.cursor && frame.box.x + frame.box.width - end_of(curve).x() > 0.15 * frame.box.width;
}

/// Texts inside the box keep clear of curves, goal lines, cursors and each other.
struct Inside {
  const PlotFrame& frame;
  const Plot& plot;
  const List<Curve>& curves;
  List<Rect> taken = {};
};

bool is_free(const Inside& inside, const Rect& rect) {
  if (!contains(inside.frame.box, rect)) return false;
  for (const Curve& curve : inside.curves) {
    if (meets(curve, inset(rect, -4))) return false;
  }
  for (const GoalLine& goal : inside.plot.goals) {
    const double y = inside.frame.y.pixel(goal.y);
    if (y >= rect.y && y <= rect.y + rect.height) return false;
  }
  for (const std::optional<double>& line : {inside.plot.cursor, inside.plot.now}) {
    if (!line || !plottable(*line, inside.frame.x.scale)) continue;
    const double x = inside.frame.x.pixel(*line);
    if (x >= rect.x - 4 && x <= rect.x + rect.width + 4) return false;
  }
  return std::none_of(inside.taken.begin(), inside.taken.end(),
                      [&](const Rect& r) { return overlap(r, rect); });
}

/// From a point to the nearest one of a curve [px].
double distance_to(const Curve& curve, const Point& from) {
  double least = 1e9;
  const auto look = [&](const List<Point>& points) {
    for (int i = 1; i < points.size(); ++i) {
      const Point along = points[i] - points[i - 1];
      const double share = along.squaredNorm() > 0
                               ? std::clamp((from - points[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0)
                               : 0;
      least = std::min(least, (points[i - 1] + share * along - from).norm());
    }
  };
  for (const List<Point>& piece : curve.pieces) look(piece);
  for (const Point& point : curve.points) least = std::min(least, (point - from).norm());
  return least;
}

/// Whether this place is nearer to another curve than to its own: then it would name that one.
bool names_another(const Inside& inside, int series, const Rect& rect) {
  const Point middle(rect.x + rect.width / 2, rect.y + rect.height / 2);
  const double own = distance_to(inside.curves[series], middle);
  for (int i = 0; i < inside.curves.size(); ++i) {
    if (i != series && distance_to(inside.curves[i], middle) < own - 1) return true;
  }
  return false;
}

bool write_inside(Page& page, Inside& inside, const List<Point>& places, const std::string& text,
                  const TextStyle& style) {
  for (const Point& at : places) {
    const Rect rect = text_rect(page.canvas(), at, text, style);
    if (!is_free(inside, rect)) continue;
    page.canvas().text(at, text, style);
    inside.taken.push_back(rect);
    return true;
  }
  return false;
}

void write_goal(Page& page, Inside& inside, const GoalLine& goal) {
  const Rect& box = inside.frame.box;
  TextStyle style = page.tick();
  style.color = page.theme().text;
  const double width = page.canvas().text_width(goal.text, style);
  const double line = inside.frame.y.pixel(goal.y);
  List<Point> places;
  for (int step = 0; step <= 8; ++step) {
    const double x = box.x + box.width - 10 - width - step * (box.width - 20 - width) / 8;
    places.emplace_back(x, line - 0.45 * style.size);
    places.emplace_back(x, line + 1.15 * style.size);
  }
  if (write_inside(page, inside, places, goal.text, style)) return;
  style.halo = page.theme().panel;  // where every place is crossed by a curve
  page.canvas().text(places.front(), goal.text, style);
  inside.taken.push_back(text_rect(page.canvas(), places.front(), goal.text, style));
}

// Whether the name could be written where the curve ends, inside the box, or else beside a point before that.
bool write_at_end(Page& page, Inside& inside, const EndLabel& label) {
  const Series& series = inside.plot.series[label.series];
  const TextStyle style = series_label(page, series);
  const double width = page.canvas().text_width(series.name, style);
  const double gap = page.sizes().marker + air;
  List<Point> beside = {label.end};
  const List<Point>& points = inside.curves[label.series].points;
  for (const int part : {4, 3, 2, 1}) {
    if (!points.empty()) beside.push_back(points[part * (points.size() - 1) / 5]);
  }
  List<Point> places;
  for (const Point& at : beside) {
    for (const double left : {at.x() + gap, at.x() - gap - width}) {
      for (const double rise : {0.35, -0.4, 1.1, -1.1, 1.8})
        places.emplace_back(left, at.y() + rise * style.size);
    }
  }
  const auto names_other = [&](const Point& at) {
    return names_another(inside, label.series, text_rect(page.canvas(), at, series.name, style));
  };
  places.erase(std::remove_if(places.begin(), places.end(), names_other), places.end());
  return write_inside(page, inside, places, series.name, style);
}

/// Right of its point, else left, above or below; not at all where it would stand on something.
void write_beside(Page& page, Inside& inside, const PointLabel& label) {
  const PlotFrame& frame = inside.frame;
  if (!plottable(label.x, frame.x.scale) || !plottable(label.y, frame.y.scale)) return;
  const Point at = frame.pixel(label.x, label.y);
  TextStyle style = page.tick();
  style.halo = page.theme().panel;  // over the grid
  const double width = page.canvas().text_width(label.text, style);
  const double gap = page.sizes().marker + air;
  List<Point> places;
  for (const double rise : {0.35, -0.6, 1.3, -1.6, 2.3}) {
    for (const double left : {at.x() + gap, at.x() - gap - width, at.x() - width / 2}) {
      places.emplace_back(left, at.y() + rise * style.size);
    }
  }
  write_inside(page, inside, places, label.text, style);
}

void write_in_gutter(Page& page, const PlotFrame& frame, const Series& series, const Point& end, double y) {
  Canvas& canvas = page.canvas();
  const TextStyle style = series_label(page, series);
  const double edge = frame.box.x + frame.box.width;
  const Point mark(edge + leader + page.sizes().marker, y);
  if (edge - end.x() < 1.5 * leader) {
    canvas.line(end, mark, {.width = 1.5, .color = faded(series.style.color, 0.7)});
  }
  if (series.markers) {
    draw_marker(canvas, mark, series.style.marker, page.sizes().marker, series.style.color);
  } else {
    const Point half(page.sizes().marker, 0);
    canvas.line(mark - half, mark + half, {.width = page.sizes().curve, .color = series.style.color});
  }
  canvas.text({mark.x() + page.sizes().marker + air, baseline_around(y, style.size)}, series.name, style);
}

List<EndLabel> end_labels(const Plot& plot, const List<Curve>& curves) {
  List<EndLabel> labels;
  for (int i = 0; i < curves.size(); ++i) {
    if (!plot.series[i].name.empty() && !is_empty(curves[i])) labels.push_back({i, end_of(curves[i])});
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const EndLabel& a, const EndLabel& b) { return a.end.y() < b.end.y(); });
  // Where curves end together, their names stand in the order of the series.
  for (int first = 0, next = 0; first < labels.size(); first = next) {
    do ++next;
    while (next < labels.size() && labels[next].end.y() - labels[next - 1].end.y() < together);
    std::sort(labels.begin() + first, labels.begin() + next,
              [](const EndLabel& a, const EndLabel& b) { return a.series < b.series; });
  }
  return labels;
}

}  // namespace

TextStyle series_label(const Page& page, const Series& series) {
  TextStyle style = page.label();
  style.color = page.theme().text;
  if (page.compact()) return style;
  style.size = std::max(style.size, 18.0);
  style.bold = true;
  const Theme& theme = page.theme();
  const bool readable = std::min(contrast(series.style.color, theme.panel),
                                 contrast(series.style.color, theme.background)) >= 3;
  if (readable) style.color = series.style.color;
  return style;
}

double gutter_width(const Page& page, const PlotFrame& frame, const Plot& plot, const List<Curve>& curves) {
  double width = page.sizes().tick;  // half of the last tick's label
  for (const EndLabel& label : end_labels(plot, curves)) {
    const Series& series = plot.series[label.series];
    const double text = page.canvas().text_width(series.name, series_label(page, series));
    width = std::max(width, leader + 2 * page.sizes().marker + air + text + 2);
  }
  return std::min(width, 0.5 * frame.panel.width);
}

List<double> moved_apart(const List<double>& wanted, double distance, double low, double high) {
  // Without the distances the places need only be in order: the nearest such places are means of groups.
  struct Group {
    double mean = 0;
    double size = 0;
  };
  List<Group> groups;
  for (int i = 0; i < wanted.size(); ++i) {
    Group group{wanted[i] - i * distance, 1};
    while (!groups.empty() && groups.back().mean > group.mean) {
      const Group& last = groups.back();
      const double size = last.size + group.size;
      group = {(last.mean * last.size + group.mean * group.size) / size, size};
      groups.pop_back();
    }
    groups.push_back(group);
  }
  const double spread = wanted.empty() ? 0 : (wanted.size() - 1) * distance;
  const double top = std::max(low, high - spread);
  List<double> places;
  for (const Group& group : groups) {
    for (double i = 0; i < group.size; ++i) {
      places.push_back(std::clamp(group.mean, low, top) + places.size() * distance);
    }
  }
  return places;
}

void draw_goals(Page& page, const PlotFrame& frame, const Plot& plot) {
  Canvas& canvas = page.canvas();
  canvas.push_clip(frame.box);
  for (const GoalLine& goal : plot.goals) {
    if (!plottable(goal.y, frame.y.scale)) continue;
    const double y = std::round(frame.y.pixel(goal.y)) + 0.5;
    canvas.line({frame.box.x, y}, {frame.box.x + frame.box.width, y},
                {.width = 1.5, .color = page.theme().text, .dash = {6, 4}});
  }
  canvas.pop_clip();
}

void draw_plot_labels(Page& page, const PlotFrame& frame, const Plot& plot, const List<Curve>& curves) {
  Inside inside{.frame = frame, .plot = plot, .curves = curves};
  for (const GoalLine& goal : plot.goals) {
    const double y = plottable(goal.y, frame.y.scale) ? frame.y.pixel(goal.y) : -1;
    const bool shown = y >= frame.box.y && y <= frame.box.y + frame.box.height;
    if (shown && !goal.text.empty()) write_goal(page, inside, goal);
  }
  // Names that have no place at the end of their curve stand at the top, as in a legend.
  List<EndLabel> in_gutter, at_edge;
  for (const EndLabel& label : end_labels(plot, curves)) {
    const bool is_early = ends_early(frame, plot, curves[label.series]);
    if (is_early && write_at_end(page, inside, label)) continue;
    (is_early ? in_gutter : at_edge).push_back(label);
  }
  List<double> wanted(in_gutter.size(), frame.box.y);
  for (const EndLabel& label : at_edge) {
    in_gutter.push_back(label);
    wanted.push_back(label.end.y());
  }
  for (const PointLabel& label : plot.labels) write_beside(page, inside, label);
  const double height = 1.3 * series_label(page, {}).size;
  const List<double> places =
      moved_apart(wanted, height, frame.box.y + height / 2, frame.box.y + frame.box.height - height / 2);
  for (int i = 0; i < in_gutter.size(); ++i) {
    write_in_gutter(page, frame, plot.series[in_gutter[i].series], in_gutter[i].end, places[i]);
  }
}

}  // namespace cairn::render
