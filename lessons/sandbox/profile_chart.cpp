// Performance profiles, as steps: a step up at every ratio that a solver reaches.
#include "lessons/sandbox/charts.hpp"

#include <fmt/format.h>

#include "render/plot.hpp"

namespace cairn::sandbox {
namespace {

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
