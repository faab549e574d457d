// Work against error, as a picture: every setting a dot, the best of each solver a curve.
#include "lessons/sandbox/trade_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/plot.hpp"
#include "render/text_layout.hpp"

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

/// That of its family.
render::SeriesStyle family_style(const std::string& solver, const render::Theme& theme) {
  if (solver == "si") return theme.si;
  if (solver == "box2d") return theme.box2d;
  if (solver.rfind("jacobi", 0) == 0) return theme.jacobi;
  if (solver.rfind("pgs", 0) == 0 || solver == "block") return theme.pgs;
  return theme.exact;
}

}  // namespace

List<render::SeriesStyle> solver_styles(const List<std::string>& solvers, const render::Theme& theme) {
  List<render::SeriesStyle> free = {theme.exact, theme.jacobi, theme.pgs, theme.si, theme.box2d};
  const auto take = [&free](const render::SeriesStyle& style) {
    const int before = free.size();
    erase_if(free, [&](const auto& other) { return other.marker == style.marker; });
    return free.size() < before;
  };
  List<render::SeriesStyle> styles;
  List<int> without;  // one of their own
  for (int i = 0; i < solvers.size(); ++i) {
    styles.push_back(family_style(solvers[i], theme));
    if (!take(styles.back())) without.push_back(i);
  }
  for (const int i : without) {
    styles[i] = free.front();
    take(styles[i]);
  }
  return styles;
}

std::string solver_label(const std::string& solver) {
  if (solver == "si") return "SI";
  if (solver == "box2d") return "Box2D";
  return solver.rfind("pgs", 0) == 0 ? "PGS" + solver.substr(3) : solver;
}

std::string unmarked(const std::string& text) {
  std::string plain;
  for (const char c : text) plain += c == '_' ? std::string("\\_") : std::string(1, c);
  return plain;
}

render::Rect place_note(render::Page& page, const std::string& note) {
  const render::Rect area = page.area();
  if (note.empty()) return area;
  const double size = page.secondary().size;
  const int lines = render::wrapped(page.canvas(), note, area.width, page.secondary()).size();
  const double height = (render::leading * (static_cast<double>(lines) - 1) + 1.8) * size;
  page.paragraph({area.x, area.y + area.height - height + 1.5 * size}, area.width, note, page.secondary());
  return {area.x, area.y, area.width, area.height - height};
}

render::Image draw_trade_chart(const TradeChart& chart, const render::Theme& theme) {
  render::Page page(chart.width, chart.height, theme);
  page.begin({.number = "", .title = chart.title, .state = fmt::format("{} settings", chart.points.size())});
  const render::Rect area = place_note(page, chart.note);
  draw_plot(page, area, plot_of(chart, theme));
  return page.canvas().read();
}

}  // namespace cairn::sandbox
