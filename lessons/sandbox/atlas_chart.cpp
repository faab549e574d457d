// A page of the atlas: panels, axes, legend.
#include "lessons/sandbox/atlas_chart.hpp"

#include <algorithm>
#include <cmath>

#include "lessons/sandbox/atlas_cells.hpp"
#include "math/check.hpp"
#include "render/lint.hpp"
#include "render/text_layout.hpp"

namespace cairn::sandbox {
namespace {

using render::Align;
using render::Rect;
using render::TextStyle;

constexpr int panels_in_a_row = 4;
constexpr double small_type = 13;  // [px] of findings, rules and axes
constexpr double edge = 12;        // [px] free inside a panel
constexpr double gap = 10;         // [px] between panels
constexpr double panel_height = 317;
constexpr int head_height = 66;  // [px] above the first row and below the last

TextStyle small_style(const render::Page& page, Align align = Align::left) {
  return {.size = small_type, .color = page.theme().secondary_text, .align = align};
}

TextStyle name_style(const render::Page& page) {
  return {.size = 16, .color = page.theme().text, .bold = true};
}

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

void frame_panel(render::Page& page, const Rect& rect) {
  const Rect frame = {std::floor(rect.x) + 0.5, std::floor(rect.y) + 0.5, std::floor(rect.width) - 1,
                      std::floor(rect.height) - 1};
  page.canvas().rect(frame,
                     {.fill = page.theme().panel, .outline = page.theme().frame_line, .outline_width = 1});
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
    page.canvas().text({grid.box.x - 6, render::baseline_around(middle, small_type)}, map.y.labels[y],
                       small_style(page, Align::right));
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
    TextStyle name = name_style(page);
    name.size = 15;
    canvas.text({left + 34, base}, rule.name, name);
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

AtlasPicture draw_atlas(const AtlasSheet& sheet, const render::Theme& theme) {
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
