// The cells of a map of the atlas.
#include "lessons/sandbox/atlas_cells.hpp"

#include <algorithm>
#include <cmath>

#include "math/list.hpp"
#include "render/lint.hpp"
#include "render/text_layout.hpp"

namespace cairn::sandbox {
namespace {

using render::Point;
using render::Rect;

render::TextStyle boundary_style(const render::Page& page) {
  render::TextStyle style = page.tick();
  style.size = 13;
  style.bold = true;
  style.align = render::Align::center;
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
  const render::TextStyle style = boundary_style(page);
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

}  // namespace

double AtlasGrid::left(int x) const { return std::round(box.x + box.width * x / columns()); }

double AtlasGrid::top(int y) const {
  return std::round(box.y + box.height * (1 - static_cast<double>(y) / static_cast<double>(rows())));
}

render::Color class_color(const render::Theme& theme, AtlasClass ending) {
  switch (ending) {
    case AtlasClass::holds:
      return theme.active_a;
    case AtlasClass::strained:
      return theme.active_b;
    case AtlasClass::failed:
      return theme.normal;
    case AtlasClass::exploded:
      return theme.text;
    case AtlasClass::refused:
      return theme.static_body;
    case AtlasClass::not_run:
      break;
  }
  return theme.panel;
}

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

}  // namespace cairn::sandbox
