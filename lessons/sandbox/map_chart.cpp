// The map of settings: panels, cells, legend.
#include "lessons/sandbox/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/lint.hpp"
#include "render/text_layout.hpp"

namespace cairn::sandbox {
namespace {

using render::Align;
using render::Rect;
using render::TextStyle;

const List<double> map_goals = {0.03, 0.01, 0.003, 0.001, 0.0001};  // [m], from below
const std::string stepped_scene = "length 10";                      // whose frequencies have a panel

constexpr double map_gap = 10, panel_edge = 12, map_panel_height = 300, cell_type = 12;
constexpr int map_head = 58, map_foot = 100;  // [px] above the panels and below

/// A column of a panel: a number, and the runs among which the cheapest is looked for.
struct MapColumn {
  std::string label = {};
  const List<MapRow>* runs = nullptr;
  int frequency = 0;  // of all runs that count; 0: any
};

struct MapPanel {
  std::string title = {};
  std::string axis = {};
  List<MapColumn> columns = {};
};

/// The cheapest run of the column for the error; nullptr if none comes to it.
const MapRow* best_in(const MapColumn& column, double goal) {
  return cheapest(*column.runs, goal, [&](const MapRow& run) {
    return column.frequency == 0 || run.frequency == column.frequency;
  });
}

/// In how many cells of the panels each solver is the cheapest, in the order of map_solvers.
List<int> cells_won(const List<MapPanel>& panels) {
  List<int> won(map_solvers.size(), 0);
  for (const MapPanel& panel : panels) {
    for (const MapColumn& column : panel.columns) {
      for (const double goal : map_goals) {
        const MapRow* const best = best_in(column, goal);
        for (int i = 0; i < map_solvers.size(); ++i) won[i] += best && best->solver == map_solvers[i] ? 1 : 0;
      }
    }
  }
  return won;
}

/// ": newton in 38 of 40": what the panel found.
std::string finding_of(const MapPanel& panel) {
  const List<int> won = cells_won({panel});
  const int most = static_cast<int>(std::max_element(won.begin(), won.end()) - won.begin());
  return fmt::format(": {} in {} of {}", solver_label(map_solvers[most]), won[most],
                     panel.columns.size() * map_goals.size());
}

std::string column_label(double value) {
  return value < 1e4 ? fmt::format("{:g}", value) : fmt::format("10^{{{:.0f}}}", std::log10(value));
}

List<MapPanel> map_panels(const MapTable& table) {
  List<MapPanel> panels;
  for (const MapFamily& family : map_families()) {
    MapPanel panel{.title = family.title, .axis = family.axis};
    for (const List<MapRow>& runs : table.scenes) {
      if (runs.front().family != family.name) continue;
      panel.columns.push_back({column_label(runs.front().value), &runs});
    }
    if (!panel.columns.empty()) panels.push_back(panel);
  }
  for (const List<MapRow>& runs : table.scenes) {
    if (runs.front().scene != stepped_scene) continue;
    panels.push_back({.title = "A swinging chain of ten links", .axis = "steps a second"});
    for (const int frequency : {30, 60, 120, 240})
      panels.back().columns.push_back({std::to_string(frequency), &runs, frequency});
  }
  return panels;
}

/// Areas have neither dash nor marker: what shares a colour with SI is paler.
render::Color solver_color(const render::Page& page, const std::string& solver) {
  if (solver == "block") return page.theme().active_b;
  const List<render::SeriesStyle> styles = solver_styles(map_solvers, page.theme());
  return styles[static_cast<int>(std::find(map_solvers.begin(), map_solvers.end(), solver) -
                                 map_solvers.begin())]
      .color;
}

/// "60 Hz ×4" over "10 soft".
void write_setting(render::Page& page, const Rect& cell, const MapRow& run, render::Color fill) {
  const TextStyle style{
      .size = cell_type, .color = render::ink_on(fill), .align = Align::center, .halo = fill};
  const double x = cell.x + cell.width / 2, y = cell.y + cell.height / 2;
  const std::string substeps = run.substeps > 1 ? fmt::format(" ×{}", run.substeps) : "";
  const std::string policy = run.policy == "relaxed"         ? ""
                             : run.policy == "split impulse" ? " S"
                             : run.policy == "baumgarte"     ? " B"
                                                             : " " + run.policy;
  page.canvas().text({x, y - 3}, fmt::format("{} Hz{}", run.frequency, substeps), style);
  page.canvas().text({x, y + 12}, std::to_string(run.sweeps) + policy, style);
}

void draw_cell(render::Page& page, const Rect& cell, const MapColumn& column, double goal) {
  const MapRow* const best = best_in(column, goal);
  if (best == nullptr) {
    page.canvas().rect(cell, {.outline = page.theme().frame_line, .outline_width = 1});
    TextStyle style{.size = cell_type, .color = page.theme().secondary_text, .align = Align::center};
    page.canvas().text({cell.x + cell.width / 2, cell.y + cell.height / 2 + 4}, "none", style);
    return;
  }
  const render::Color fill = solver_color(page, best->solver);
  page.canvas().rect(cell, {.fill = fill});
  write_setting(page, cell, *best, fill);
}

void draw_map_panel(render::Page& page, const MapPanel& panel, const Rect& rect) {
  frame_panel(page, rect);
  page.canvas().text({rect.x + panel_edge, rect.y + 24}, panel.title + finding_of(panel), name_style(page));
  page.canvas().text({rect.x + panel_edge, rect.y + 45}, "↑ error wanted", small_style(page));
  const double left = rect.x + panel_edge + 58, top = rect.y + 54;
  const double width = std::floor((rect.width - 2 * panel_edge - 58) / panel.columns.size());
  const double height = std::floor((rect.height - 54 - 46) / map_goals.size());
  const double bottom = top + height * map_goals.size();
  for (int row = 0; row < map_goals.size(); ++row) {
    const double y = bottom - height * (row + 1);
    page.canvas().text({left - 6, render::baseline_around(y + height / 2, small_style(page).size)},
                       fmt::format("{:g} mm", 1000 * map_goals[row]), small_style(page, Align::right));
    for (int i = 0; i < panel.columns.size(); ++i)
      draw_cell(page, {left + width * i, y, width - 1, height - 1}, panel.columns[i], map_goals[row]);
  }
  for (int i = 0; i < panel.columns.size(); ++i)
    page.canvas().text({left + width * (i + 0.5), bottom + 16}, panel.columns[i].label,
                       small_style(page, Align::center));
  page.canvas().text({left + width * panel.columns.size() / 2, bottom + 35}, panel.axis,
                     small_style(page, Align::center));
}

/// The solvers that are somewhere the cheapest, with their colours; the others by name.
void draw_map_legend(render::Page& page, const List<MapPanel>& panels, double y) {
  double x = page.sizes().margin;
  const TextStyle name = name_style(page, 15);
  const List<int> won = cells_won(panels);
  std::string nowhere;
  for (int i = 0; i < map_solvers.size(); ++i) {
    if (won[i] == 0) {
      nowhere += " Nowhere the cheapest: " + solver_label(map_solvers[i]) + ".";
      continue;
    }
    page.canvas().rect({x, y, 24, 18}, {.fill = solver_color(page, map_solvers[i])});
    page.canvas().text({x + 32, y + 14}, solver_label(map_solvers[i]), name);
    x += 32 + page.canvas().text_width(solver_label(map_solvers[i]), name) + 28;
  }
  page.paragraph(
      {page.sizes().margin, y + 40}, page.canvas().width() - 2 * page.sizes().margin,
      "A cell names the setting that needs the least counted work for the error at its left: steps a second, "
      "× substeps; below them sweeps (of newton: linear systems), and the policy where it is not relaxed: "
      "B Baumgarte, S split impulse, soft. "
      "None: every setting that was tried has a larger error, falls, gains energy, or takes too long. A "
      "title says which solver fills the most of its cells." +
          nowhere,
      small_style(page));
}

}  // namespace

PanelPicture draw_map(const MapTable& table, const render::Theme& theme) {
  const List<MapPanel> panels = map_panels(table);
  const int rows = (panels.size() + 1) / 2;
  const double body = rows * (map_panel_height + map_gap);
  render::Page page(1280, map_head + static_cast<int>(body) + map_foot, theme);
  page.begin({.number = "", .title = "The cheapest setting for each error", .state = ""});
  const double margin = page.sizes().margin;
  const double width = std::floor((page.canvas().width() - 2 * margin - map_gap) / 2);
  for (int i = 0; i < panels.size(); ++i) {
    const Rect rect = {margin + (i % 2) * (width + map_gap),
                       map_head + (i / 2) * (map_panel_height + map_gap), width, map_panel_height};
    draw_map_panel(page, panels[i], rect);
  }
  draw_map_legend(page, panels, map_head + body + 4);
  return {page.canvas().read(), render::lint(page)};
}

}  // namespace cairn::sandbox
