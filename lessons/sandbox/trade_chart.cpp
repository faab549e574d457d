// Work against error, as a picture: every setting a dot, the best of each solver a curve.
#include "lessons/sandbox/charts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/plot.hpp"

namespace cairn::sandbox {
namespace {

/// What no other point of the list beats, from the least work to the most.
List<TradePoint> front_of(List<TradePoint> points) {
  std::stable_sort(points.begin(), points.end(), [](const TradePoint& a, const TradePoint& b) {
    return a.work < b.work || (a.work == b.work && a.error < b.error);
  });
  List<TradePoint> front;
  for (const TradePoint& point : points) {
    if (front.empty() || point.error < front.back().error) front.push_back(point);
  }
  return front;
}

render::Places places_of(const List<TradePoint>& points) {
  render::Places places;
  for (const TradePoint& point : points) {
    places.x.push_back(point.work);
    places.y.push_back(point.error);
  }
  return places;
}

/// The setting without what all of a chart have.
std::string brief(std::string setting) {
  for (const std::string common : {", relaxed", ", double"}) {
    const std::size_t at = setting.find(common);
    if (at != std::string::npos) setting.erase(at, common.size());
  }
  return setting;
}

render::Plot plot_of(const TradeChart& chart, const render::Theme& theme) {
  render::Plot plot{.x = {.title = chart.work, .scale = render::AxisScale::logarithmic},
                    .y = {.title = chart.error, .scale = render::AxisScale::logarithmic}};
  plot.cloud = places_of(chart.points);
  plot.front = places_of(front_of(chart.points));
  const List<render::SeriesStyle> styles = solver_styles(chart.curves, theme);
  for (int i = 0; i < chart.curves.size(); ++i) {
    const std::string& solver = chart.curves[i];
    List<TradePoint> own;
    std::copy_if(chart.points.begin(), chart.points.end(), std::back_inserter(own),
                 [&](const TradePoint& point) { return point.solver == solver; });
    const render::Places places = places_of(front_of(own));
    plot.series.push_back({.name = solver_label(solver), .style = styles[i], .x = places.x, .y = places.y});
  }
  if (!chart.labels_all) return plot;
  for (const TradePoint& point : front_of(chart.points)) {
    plot.labels.push_back({point.work, point.error, unmarked(brief(point.setting))});
  }
  return plot;
}

}  // namespace

render::Image draw_trade_chart(const TradeChart& chart, const render::Theme& theme) {
  render::Page page(1280, 720, theme);
  page.begin({.number = "", .title = chart.title, .state = fmt::format("{} settings", chart.points.size())});
  const render::Rect area = place_note(page, chart.note);
  draw_plot(page, area, plot_of(chart, theme));
  return page.canvas().read();
}

}  // namespace cairn::sandbox
