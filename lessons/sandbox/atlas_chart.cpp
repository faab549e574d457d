// A map of the stability atlas: cells in their classes, the line around what holds, panels, axes, legend.
#include <algorithm>
#include <cmath>

#include "lessons/sandbox/charts.hpp"
#include <cairn/math/check.hpp>
#include "render/lint.hpp"
#include "render/text_layout.hpp"

namespace cairn::sandbox {
namespace {

using render::Align;
using render::Point;
using render::Rect;
using render::TextStyle;

/// One panel of a sheet on its page; y grows upwards.
struct AtlasGrid {
  const AtlasSheet& sheet;
  int panel = 0;
  Rect box = {};  // [px] of all cells

  int columns() const { return sheet.map.x.values.size(); }
  int rows() const { return sheet.map.y.values.size(); }
  bool one_row() const { return sheet.map.panels[panel].ignores_y; }
  AtlasClass ending(int x, int y) const { return sheet.cell(panel, x, y).ending; }
  double left(int x) const { return std::round(box.x + box.width * x / columns()); }
  double top(int y) const {
    return std::round(box.y + box.height * (1 - static_cast<double>(y) / static_cast<double>(rows())));
  }
};

render::Color class_color(const render::Theme& theme, AtlasClass ending) {
  const List<render::Color> colors = {theme.active_a, theme.active_b,    theme.normal,
                                      theme.text,     theme.static_body, theme.panel};
  return colors[static_cast<int>(ending)];
}

TextStyle boundary_style(const render::Page& page) {
  TextStyle style = page.tick();
  style.size = 13;
  style.bold = true;
  style.align = Align::center;
  style.halo = class_color(page.theme(), AtlasClass::holds);
  style.color = render::ink_on(style.halo);
  return style;
}

void draw_star(render::Canvas& canvas, const Point& middle, double radius, const render::Stroke& stroke) {
  for (const double angle : {0.0, 1.0, 2.0}) {
    const Point arm(radius * std::cos(pi * (angle / 3 + 0.5)), radius * std::sin(pi * (angle / 3 + 0.5)));
    canvas.line(middle - arm, middle + arm, stroke);
  }
}

/// Cells side by side that hold, in one row.
struct Run {
  int first = 0;
  int count = 0;
};

Run longest_run(const AtlasGrid& grid, int y) {
  Run best, run;
  for (int x = 0; x < grid.columns(); ++x) {
    if (grid.ending(x, y) != AtlasClass::holds) {
      run = {x + 1, 0};
      continue;
    }
    run.count += 1;
    if (run.count > best.count) best = run;
  }
  return best;
}

/// In the longest run of all rows, the middle one of several.
void write_boundary_name(render::Page& page, const AtlasGrid& grid) {
  List<int> best;
  int longest = 0;
  for (int y = 0; y < grid.rows(); ++y) {
    const int count = longest_run(grid, y).count;
    if (count > longest) best.clear();
    if (count > 0 && count >= longest) best.push_back(y);
    longest = std::max(longest, count);
  }
  if (best.empty()) return;
  const int y = best[best.size() / 2];
  const Run run = longest_run(grid, y);
  const double left = grid.left(run.first), right = grid.left(run.first + run.count);
  const TextStyle style = boundary_style(page);
  const std::string& name = grid.sheet.map.classes[0].name;
  if (page.canvas().text_width(name, style) + 10 > right - left) return;
  const double middle =
      grid.one_row() ? grid.box.y + grid.box.height / 2 : (grid.top(y) + grid.top(y + 1)) / 2;
  page.canvas().text({(left + right) / 2, render::baseline_around(middle, style.size)}, name, style);
}

/// Whether the two are on two sides of the boundary.
bool differ(AtlasClass a, AtlasClass b) {
  if (a == AtlasClass::not_run || b == AtlasClass::not_run) return false;
  return (a == AtlasClass::holds) != (b == AtlasClass::holds);
}

List<std::pair<Point, Point>> boundary_lines(const AtlasGrid& grid) {
  List<std::pair<Point, Point>> lines;
  for (int x = 0; x < grid.columns(); ++x) {
    for (int y = 0; y < grid.rows(); ++y) {
      const double left = grid.left(x), right = grid.left(x + 1), low = grid.top(y), high = grid.top(y + 1);
      if (x + 1 < grid.columns() && differ(grid.ending(x, y), grid.ending(x + 1, y)))
        lines.push_back({{right, low}, {right, high}});
      if (y + 1 < grid.rows() && differ(grid.ending(x, y), grid.ending(x, y + 1)))
        lines.push_back({{left, high}, {right, high}});
    }
  }
  return lines;
}

/// A cell in the colour of its class, and its sign: none, one stroke, a cross, a star, a hatch.
void draw_class(render::Page& page, const Rect& rect, AtlasClass ending) {
  render::Canvas& canvas = page.canvas();
  const render::Color fill = class_color(page.theme(), ending);
  canvas.rect(rect, {.fill = fill});
  const Point middle(rect.x + rect.width / 2, rect.y + rect.height / 2);
  const double radius = std::min({0.28 * rect.width, 0.28 * rect.height, 5.0});
  const render::Stroke stroke{.width = 1.5, .color = render::ink_on(fill)};
  if (ending == AtlasClass::strained || ending == AtlasClass::failed)
    canvas.line(middle + Point(-radius, radius), middle + Point(radius, -radius), stroke);
  if (ending == AtlasClass::failed)
    canvas.line(middle + Point(-radius, -radius), middle + Point(radius, radius), stroke);
  if (ending == AtlasClass::exploded) draw_star(canvas, middle, 1.2 * radius, stroke);
  if (ending == AtlasClass::refused) {
    const List<Point> corners = {{rect.x, rect.y},
                                 {rect.x + rect.width, rect.y},
                                 {rect.x + rect.width, rect.y + rect.height},
                                 {rect.x, rect.y + rect.height}};
    canvas.hatch(corners, {.width = 1.5, .color = page.theme().static_hatch}, 7);
  }
}

void draw_atlas_cells(render::Page& page, const AtlasGrid& grid) {
  for (int x = 0; x < grid.columns(); ++x) {
    for (int y = 0; y < grid.rows(); ++y) {
      if (grid.one_row() && y > 0) break;
      const double top = grid.one_row() ? grid.box.y : grid.top(y + 1);
      const double bottom = grid.one_row() ? grid.box.y + grid.box.height : grid.top(y);
      const Rect cell = {grid.left(x), top, grid.left(x + 1) - grid.left(x), bottom - top};
      draw_class(page, {cell.x, cell.y, cell.width - 1, cell.height - 1}, grid.ending(x, y));
    }
  }
}

/// A step line between what holds and what does not, with the class's name on the side that holds.
void draw_atlas_boundary(render::Page& page, const AtlasGrid& grid) {
  const List<std::pair<Point, Point>> lines = boundary_lines(grid);
  // A rim first, so that the line is seen beside the darkest cells too.
  const render::Stroke rim{.width = 6, .color = page.theme().panel};
  const render::Stroke line{.width = 3, .color = page.theme().text};
  for (const render::Stroke& stroke : {rim, line}) {
    for (const auto& ends : lines) page.canvas().line(ends.first, ends.second, stroke);
  }
  write_boundary_name(page, grid);
}

constexpr int panels_in_a_row = 4;
constexpr double edge = 12;  // [px] free inside a panel
constexpr double gap = 10;   // [px] between panels
constexpr double panel_height = 317;
constexpr int head_height = 66;  // [px] above the first row and below the last

/// With the legend behind the panels.
int rows_of(int panels) { return panels / panels_in_a_row + 1; }

/// Slots from left to right and down; the legend has what the panels leave of the last row.
List<Rect> slots(const render::Page& page, int panels) {
  const double width = page.canvas().width() - 2 * page.sizes().margin;
  List<Rect> all;
  // In whole pixels, so that the same text in two panels has the same pixels, and the file stays small.
  const double each = std::floor((width - gap * (panels_in_a_row - 1)) / panels_in_a_row);
  for (int i = 0; i <= panels; ++i) {
    const auto column = static_cast<double>(i % panels_in_a_row);
    const auto row = static_cast<double>(i / panels_in_a_row);
    all.push_back({page.sizes().margin + column * (each + gap), page.area().y + row * (panel_height + gap),
                   each, panel_height});
  }
  all.back().width = page.sizes().margin + width - all.back().x;
  return all;
}

void write_x_axis(render::Page& page, const AtlasGrid& grid) {
  const AtlasMap& map = grid.sheet.map;
  TextStyle style = small_style(page, Align::center);
  const double base = grid.box.y + grid.box.height + 15;
  for (int x = 0; x < grid.columns(); ++x) {
    const bool headline = map.reading != AtlasReading::up_to_x && x == map.headline;
    style.bold = headline;
    style.color = headline ? page.theme().text : page.theme().secondary_text;
    const std::string& label = map.x.labels[x];
    if (!label.empty()) page.canvas().text({(grid.left(x) + grid.left(x + 1)) / 2, base}, label, style);
  }
  page.canvas().text({grid.box.x + grid.box.width / 2, base + 18}, map.x.title,
                     small_style(page, Align::center));
}

void write_y_axis(render::Page& page, const AtlasGrid& grid, double left) {
  const AtlasMap& map = grid.sheet.map;
  page.canvas().text({left, grid.box.y - 7}, grid.one_row() ? "exact: it has no sweeps" : "↑ " + map.y.title,
                     small_style(page));
  if (grid.one_row()) return;
  for (int y = 0; y < grid.rows(); ++y) {
    const double middle = (grid.top(y) + grid.top(y + 1)) / 2;
    page.canvas().text({grid.box.x - 6, render::baseline_around(middle, small_style(page).size)},
                       map.y.labels[y], small_style(page, Align::right));
  }
}

double widest_y_label(const render::Page& page, const AtlasMap& map) {
  double width = 0;
  for (const std::string& label : map.y.labels)
    width = std::max(width, page.canvas().text_width(label, small_style(page)));
  return width;
}

std::string finding_line(const AtlasSheet& sheet, int panel) {
  const std::string finding = panel_finding(sheet, panel);
  if (sheet.map.reading == AtlasReading::up_to_x) return finding;
  return shortest(sheet.map.x.values[sheet.map.headline]) + ": " + finding;
}

void draw_panel(render::Page& page, const AtlasSheet& sheet, int panel, const Rect& rect) {
  frame_panel(page, rect);
  render::Canvas& canvas = page.canvas();
  const double left = rect.x + edge, width = rect.width - 2 * edge;
  canvas.text({left, rect.y + 24}, sheet.map.panels[panel].title, name_style(page));
  const std::string finding = finding_line(sheet, panel);
  const TextStyle style = small_style(page);
  double base = rect.y + 44;
  for (const std::string& line : render::wrapped(canvas, finding, width, style)) {
    canvas.text({left, base}, line, style);
    base += 17;
  }
  const double top = std::round(base + 11), beside = std::ceil(widest_y_label(page, sheet.map)) + 8;
  const double columns = static_cast<double>(sheet.map.x.values.size());
  const double wide = columns * std::floor((width - beside) / columns);
  const AtlasGrid grid{sheet, panel, {left + beside, top, wide, rect.y + rect.height - 44 - top}};
  draw_atlas_cells(page, grid);
  draw_atlas_boundary(page, grid);
  write_x_axis(page, grid);
  write_y_axis(page, grid, left);
}

void draw_legend(render::Page& page, const AtlasSheet& sheet, const Rect& rect) {
  render::Canvas& canvas = page.canvas();
  const double left = rect.x + edge, width = rect.width - 2 * edge;
  double base = rect.y + 24;
  for (int i = 0; i < atlas_classes; ++i) {
    const AtlasRule& rule = sheet.map.classes[i];
    if (rule.name.empty()) continue;
    const Rect swatch = {left, base - 14, 24, 18};
    draw_class(page, swatch, static_cast<AtlasClass>(i));
    canvas.rect(swatch, {.outline = page.theme().frame_line, .outline_width = 1});
    canvas.text({left + 34, base}, rule.name, name_style(page, 15));
    const TextStyle style = small_style(page);
    for (const std::string& line : render::wrapped(canvas, rule.rule, width - 34, style)) {
      base += 17;
      canvas.text({left + 34, base}, line, style);
    }
    base += 25;
  }
  page.paragraph({left, base + 6}, width,
                 sheet.map.what + " The thick line bounds the first of these classes.", small_style(page));
}

}  // namespace

PanelPicture draw_atlas(const AtlasSheet& sheet, const render::Theme& theme) {
  const auto rows = static_cast<double>(rows_of(sheet.map.panels.size()));
  const int height = head_height + static_cast<int>(rows * (panel_height + gap));
  render::Page page(1280, height, theme);
  page.begin({.number = "", .title = sheet_finding(sheet), .state = ""});
  const List<Rect> places = slots(page, sheet.map.panels.size());
  for (int panel = 0; panel < sheet.map.panels.size(); ++panel) draw_panel(page, sheet, panel, places[panel]);
  draw_legend(page, sheet, places.back());
  return {page.canvas().read(), render::lint(page)};
}

}  // namespace cairn::sandbox
