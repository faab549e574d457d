// Quantities over time as a chart: a panel for each unit.
#include <fmt/format.h>

#include <map>

#include "lessons/sandbox/charts.hpp"
#include "render/plot.hpp"
#include "render/solver_style.hpp"

namespace cairn::sandbox {
namespace {

constexpr int most_curves = 4;  // of a panel
constexpr int most_panels = 4;
constexpr double panel_height = 260;  // [px]
constexpr double margin = 100;        // [px] of the page above and below

/// Tracks of one unit beside each other, as many as a panel takes.
List<List<const Track*>> panels_of(const List<Track>& tracks) {
  List<List<const Track*>> panels;
  std::map<std::string, int> open;  // the panel of a unit that still takes curves
  for (const Track& track : tracks) {
    const auto found = open.find(track.unit);
    if (found != open.end() && panels[found->second].size() < most_curves) {
      panels[found->second].push_back(&track);
      continue;
    }
    open[track.unit] = panels.size();
    panels.push_back({&track});
  }
  return panels;
}

render::Plot plot_of(const List<const Track*>& tracks, const List<double>& times,
                     const render::Theme& theme) {
  const List<render::SeriesStyle> styles = render::neutral_styles(theme);
  const std::string unit = tracks.front()->unit.empty() ? "" : " (" + tracks.front()->unit + ")";
  render::Plot plot{.x = {.title = "t (s)"}};
  if (tracks.size() == 1) {
    plot.y.title = unmarked(tracks.front()->name) + unit;
  } else {
    plot.y.title = tracks.front()->unit;
  }
  for (int i = 0; i < tracks.size(); ++i) {
    const std::string name = tracks.size() == 1 ? "" : unmarked(tracks[i]->name);
    plot.series.push_back(
        {.name = name, .style = styles[i], .x = times, .y = tracks[i]->values, .markers = tracks.size() > 1});
  }
  return plot;
}

}  // namespace

std::string draw_tracks(const TrackChart& chart, const render::Theme& theme,
                        const std::optional<render::Letters>& svg) {
  const List<List<const Track*>> panels = panels_of(chart.tracks);
  if (panels.empty() || panels.size() > most_panels)
    throw render::RenderError(
        fmt::format("a chart of tracks takes 1 to {} panels, of {} curves of one unit each, got {}",
                    most_panels, most_curves, panels.size()));
  render::Page page(1280, static_cast<int>(panel_height * panels.size() + 2 * margin), theme);
  render::SvgDrawing drawing(svg.value_or(render::Letters::outlines));
  if (svg) page.canvas().record(&drawing);
  page.begin({.number = "", .title = chart.title, .state = chart.state});
  const render::Rect area = page.area();
  const double height = area.height / panels.size();
  for (int i = 0; i < panels.size(); ++i) {
    const render::Rect rect = {area.x, area.y + i * height, area.width, height - 8};
    draw_plot(page, rect, plot_of(panels[i], chart.times, theme));
  }
  if (!svg) {
    const List<std::uint8_t> bytes = render::encode_png(page.canvas().read());
    return {bytes.begin(), bytes.end()};
  }
  page.canvas().record(nullptr);
  const render::Rect all = {0, 0, double{1} * page.canvas().width(), double{1} * page.canvas().height()};
  return drawing.file(all, theme.background, chart.title);
}

}  // namespace cairn::sandbox
