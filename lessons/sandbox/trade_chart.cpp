// Plots: work against error, every setting a dot and the best of each solver a curve; and performance
// profiles, a step up at every ratio that a solver reaches.
#include "lessons/sandbox/charts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/plot.hpp"
#include "render/solver_style.hpp"

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
  if (!chart.is_of_sweeps) {
    plot.cloud = places_of(chart.points);
    plot.front = places_of(front_of(chart.points));
  }
  const List<render::SeriesStyle> styles =  // of scenes, where it is of sweeps
      chart.is_of_sweeps ? render::neutral_styles(theme) : solver_styles(chart.curves, theme);
  for (int i = 0; i < chart.curves.size(); ++i) {
    const std::string& solver = chart.curves[i];
    const render::SeriesStyle& style = styles[i % styles.size()];
    List<TradePoint> own;
    std::copy_if(chart.points.begin(), chart.points.end(), std::back_inserter(own),
                 [&](const TradePoint& point) { return point.solver == solver; });
    const render::Places places = places_of(chart.is_of_sweeps ? own : front_of(own));
    plot.series.push_back({.name = solver_label(solver), .style = style, .x = places.x, .y = places.y});
  }
  if (!chart.labels_all) return plot;
  for (const TradePoint& point : front_of(chart.points)) {
    plot.labels.push_back({point.work, point.error, unmarked(brief(point.setting))});
  }
  return plot;
}

constexpr double most_times = 1000;  // tau, at the right end of the axis

/// The corners of its steps.
render::Series profile_steps(const PerformanceProfile& profile, const render::SeriesStyle& style) {
  render::Series series{.name = solver_label(profile.solver), .style = style, .markers = false};
  double share = profile.share(1);
  const auto corner = [&](double times) {
    series.x.push_back(times);
    series.y.push_back(share);
  };
  corner(1);
  for (const double ratio : profile.ratios) {
    if (!(ratio > 1) || !(ratio <= most_times)) continue;
    corner(ratio);
    share = profile.share(ratio);
    corner(ratio);
  }
  corner(most_times);
  return series;
}

}  // namespace

render::Image draw_trade_chart(const TradeChart& chart, const render::Theme& theme) {
  render::Page page(1280, 720, theme);
  page.begin({.number = "", .title = chart.title, .state = fmt::format("{} settings", chart.points.size())});
  const render::Rect area = place_note(page, chart.note);
  draw_plot(page, area, plot_of(chart, theme));
  return page.canvas().read();
}

render::Image draw_profile_chart(const ProfileChart& chart, const render::Theme& theme) {
  render::Page page(1280, 720, theme);
  const int problems = chart.profiles.empty() ? 0 : chart.profiles.front().ratios.size();
  page.begin({.number = "", .title = chart.title, .state = fmt::format("{} problems", problems)});
  const render::Rect area = place_note(page, chart.note);
  render::Plot plot{
      .x = {.title = "← closer to the best    row updates, in multiples τ of the least of any solver",
            .scale = render::AxisScale::logarithmic,
            .min = 1,
            .max = most_times},
      .y = {.title = "share of problems solved    higher is better ↑", .min = 0, .max = 1}};
  List<std::string> solvers;
  for (const PerformanceProfile& profile : chart.profiles) solvers.push_back(profile.solver);
  const List<render::SeriesStyle> styles = solver_styles(solvers, theme);
  for (int i = 0; i < solvers.size(); ++i) plot.series.push_back(profile_steps(chart.profiles[i], styles[i]));
  draw_plot(page, area, plot);
  return page.canvas().read();
}

}  // namespace cairn::sandbox
