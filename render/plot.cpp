// Charts: the order in which a plot is drawn. Curves lie upon the grid, words upon nothing.
#include "render/plot.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <cairn/math/check.hpp>
#include "render/plot_parts.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr int most_series = 4;  // more cannot be told apart

void check_places(const Places& places, const char* field) {
  require(places.x.size() == places.y.size(), "draw_plot", field, "of as many x as y",
          std::to_string(places.x.size()) + " and " + std::to_string(places.y.size()));
}

void check_plot(const Plot& plot) {
  require(plot.series.size() <= most_series, "draw_plot", "series", "at most 4", plot.series.size());
  for (const Series& series : plot.series) {
    require(series.x.size() == series.y.size(), "draw_plot", "x", "as long as y",
            std::to_string(series.x.size()) + " and " + std::to_string(series.y.size()));
  }
  check_places(plot.cloud, "cloud");
  check_places(plot.front, "front");
}

void draw_cursor(Page& page, const PlotFrame& frame, const std::optional<double>& cursor) {
  if (!cursor || !plottable(*cursor, frame.x.scale)) return;
  const double x = std::round(frame.x.pixel(*cursor)) + 0.5;
  const Rect& box = frame.box;
  page.canvas().push_clip(box);
  page.canvas().line({x, box.y}, {x, box.y + box.height},
                     {.width = page.sizes().axis, .color = page.theme().secondary_text});
  page.canvas().pop_clip();
}

/// A veil over everything beyond now: what is to come.
void draw_future(Page& page, const PlotFrame& frame, const std::optional<double>& now) {
  if (!now || !plottable(*now, frame.x.scale)) return;
  const Rect& box = frame.box;
  const double x = std::max(box.x, std::round(frame.x.pixel(*now)) + 0.5);
  const double width = box.x + box.width - x - page.sizes().axis;
  page.canvas().rect({x, box.y + 1, width, box.height - 2}, {.fill = faded(page.theme().panel, 0.6)});
}

List<Curve> curves_of(const PlotFrame& frame, const Plot& plot) {
  List<Curve> curves;
  for (const Series& series : plot.series) curves.push_back(curve_of(frame, series));
  return curves;
}

bool is_all_empty(const List<Curve>& curves) {
  for (const Curve& curve : curves) {
    if (!curve.points.empty() || !curve.pieces.empty()) return false;
  }
  return true;
}

}  // namespace

Series over_steps(const std::string& name, const SeriesStyle& style, const List<double>& y) {
  Series series{.name = name, .style = style, .y = y};
  for (int k = 0; k < y.size(); ++k) series.x.push_back(k);
  return series;
}

void draw_plot(Page& page, const Rect& rect, const Plot& plot) {
  check_plot(plot);
  // Small panels have no room for a line of each.
  const bool is_tight = page.compact() && !plot.title.empty() && !plot.y.title.empty();
  Plot shown = plot;
  if (is_tight) shown.y.title.clear();
  const Rect panel = page.panel(rect, is_tight ? plot.title + " · " + plot.y.title : plot.title);
  // How wide the names need it to be is known once the curves are there.
  PlotFrame frame = lay_out(page, panel, shown, 0);
  frame = lay_out(page, panel, shown, gutter_width(page, frame, shown, curves_of(frame, shown)));
  const List<Curve> curves = curves_of(frame, shown);
  draw_axes(page, frame, shown);
  draw_background(page, frame, shown);
  draw_goals(page, frame, shown);
  draw_cursor(page, frame, shown.cursor);
  draw_curves(page, frame, shown, curves);
  draw_future(page, frame, shown.now);
  draw_cursor(page, frame, shown.now);
  draw_plot_labels(page, frame, shown, curves);
  if (!is_all_empty(curves) || !shown.goals.empty()) return;
  TextStyle style = page.secondary();
  style.align = Align::center;
  const Rect& box = frame.box;
  page.canvas().text({box.x + box.width / 2, baseline_around(box.y + box.height / 2, style.size)}, "no data",
                     style);
}

}  // namespace cairn::render
