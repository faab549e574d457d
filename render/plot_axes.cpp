// Where the axes of a plot are on its panel, and how they are drawn.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/plot_parts.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr double tick_gap = 8;  // [px] between the box and what is written at its ticks

// Room inside the box around the range, so that curves along its ends are seen whole.
double rim(const Page& page) { return 2 * page.sizes().marker; }

double widest(const Page& page, const List<std::string>& texts) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, page.canvas().text_width(text, page.tick()));
  return width;
}

List<double> values_of(const Plot& plot, const List<double> Series::*member) {
  List<double> values;
  const auto add = [&](const Series& series) {
    // Only points that can be shown: both of their coordinates count.
    for (int i = 0; i < series.x.size(); ++i) {
      if (!plottable(series.x[i], plot.x.scale) || !plottable(series.y[i], plot.y.scale)) continue;
      values.push_back((series.*member)[i]);
    }
  };
  for (const Series& series : plot.series) add(series);
  for (const Places* places : {&plot.cloud, &plot.front}) add({.x = places->x, .y = places->y});
  return values;
}

TextStyle title_style(const Page& page) {
  TextStyle style = page.label();
  style.size = std::max(page.sizes().tick, std::min(style.size, page.sizes().label));
  return style;
}

int count_for(double length, double pitch, int most) {
  return std::clamp(static_cast<int>(length / pitch), 2, most);
}

// As many as can be read, starting from how wide the labels turn out.
void set_horizontal_ticks(const Page& page, AxisView& axis) {
  const double length = axis.to - axis.from;
  int count = count_for(length, 4 * page.sizes().tick, 11);
  set_ticks(axis, count);
  while (count > 2 && axis.ticks.size() * (widest(page, axis.labels) + 20) > length) {
    set_ticks(axis, --count);
  }
}

double pixel_of(const AxisView& axis, int tick) { return std::round(axis.pixel(axis.ticks[tick])); }

void draw_grid(Page& page, const PlotFrame& frame) {
  Canvas& canvas = page.canvas();
  const Rect& box = frame.box;
  const Stroke grid{.width = page.sizes().grid, .color = page.theme().grid};
  for (int i = 0; i < frame.x.ticks.size(); ++i) {
    const double x = pixel_of(frame.x, i) + 0.5;
    canvas.line({x, box.y}, {x, box.y + box.height}, grid);
  }
  for (int i = 0; i < frame.y.ticks.size(); ++i) {
    const double y = pixel_of(frame.y, i) + 0.5;
    canvas.line({box.x, y}, {box.x + box.width, y}, grid);
  }
  canvas.rect(box, {.outline = page.theme().secondary_text, .outline_width = page.sizes().axis});
}

void write_ticks(Page& page, const PlotFrame& frame) {
  Canvas& canvas = page.canvas();
  const Rect& box = frame.box;
  TextStyle style = page.tick();
  const double base = box.y + box.height + tick_gap + 0.8 * style.size;
  const Stroke mark{.width = page.sizes().axis, .color = page.theme().secondary_text};
  style.align = Align::center;
  for (int i = 0; i < frame.x.ticks.size(); ++i) {
    const double x = pixel_of(frame.x, i) + 0.5;
    canvas.line({x, box.y + box.height}, {x, box.y + box.height + 4}, mark);
    canvas.text({x, base}, frame.x.labels[i], style);
  }
  style.align = Align::right;
  for (int i = 0; i < frame.y.ticks.size(); ++i) {
    const double y = pixel_of(frame.y, i) + 0.5;
    canvas.line({box.x - 4, y}, {box.x, y}, mark);
    canvas.text({box.x - tick_gap, baseline_around(y, style.size)}, frame.y.labels[i], style);
  }
}

void write_titles(Page& page, const PlotFrame& frame, const Plot& plot) {
  Canvas& canvas = page.canvas();
  const Rect& box = frame.box;
  TextStyle style = title_style(page);
  if (!plot.y.title.empty()) {
    canvas.text({frame.panel.x, box.y - 0.7 * style.size}, plot.y.title, style);
  }
  if (plot.x.title.empty()) return;
  const double bottom = frame.panel.y + frame.panel.height;
  style.align = Align::center;
  canvas.text({box.x + box.width / 2, bottom - 0.25 * style.size}, plot.x.title, style);
}

}  // namespace

PlotFrame lay_out(const Page& page, const Rect& panel, const Plot& plot, double gutter) {
  PlotFrame frame{.panel = panel};
  const double tick = page.sizes().tick;
  const double title = title_style(page).size;
  const double top = plot.y.title.empty() ? 0.6 * tick : (plot.title.empty() ? 1.9 : 1.4) * title;
  const double bottom = tick_gap + 1.1 * tick + (plot.x.title.empty() ? 0 : 1.4 * title);
  frame.box.y = std::round(panel.y + top) + 0.5;
  frame.box.height = std::max(std::round(panel.height - top - bottom), 24.0);

  frame.y.scale = plot.y.scale;
  List<double> heights = values_of(plot, &Series::y);
  for (const GoalLine& goal : plot.goals) heights.push_back(goal.y);
  const int count = count_for(frame.box.height, 2.6 * tick, 8);
  frame.y.range = widened(range_of(plot.y, heights), plot.y, count);
  set_ticks(frame.y, count);
  frame.y.from = frame.box.y + frame.box.height - rim(page);
  frame.y.to = frame.box.y + rim(page);

  // Plots below each other begin at the same place, unless their labels are long.
  const double labels = std::max(widest(page, frame.y.labels), 2.5 * tick);
  frame.box.x = std::round(panel.x + labels + tick_gap) + 0.5;
  frame.box.width = std::max(std::round(panel.x + panel.width - gutter - frame.box.x), 24.0);
  frame.x.scale = plot.x.scale;
  frame.x.range = range_of(plot.x, values_of(plot, &Series::x));
  frame.x.from = frame.box.x + rim(page);
  frame.x.to = frame.box.x + frame.box.width - rim(page);
  set_horizontal_ticks(page, frame.x);
  return frame;
}

void draw_axes(Page& page, const PlotFrame& frame, const Plot& plot) {
  draw_grid(page, frame);
  write_ticks(page, frame);
  write_titles(page, frame, plot);
}

}  // namespace cairn::render
