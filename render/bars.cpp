// Bars for impulses. First everything that is drawn, then all text, each where it stands on nothing else.
#include "render/bars.hpp"

#include <algorithm>
#include <cmath>

#include "render/bar_sheet.hpp"
#include "render/lint.hpp"

namespace cairn::render {
namespace {

constexpr double cut_width = 14;  // [px] from the end of a cut bar to its mark "//"

List<Point> corners_of(const Rect& r) {
  List<Point> corners;
  corners.emplace_back(r.x, r.y);
  corners.emplace_back(r.x + r.width, r.y);
  corners.emplace_back(r.x + r.width, r.y + r.height);
  corners.emplace_back(r.x, r.y + r.height);
  return corners;
}

struct PieceLook {
  Color fill = {}, outline = {}, hatch = {};
};

// The outline lies inside, so that the piece is as long as its value; but no piece is too short to be seen.
void draw_piece(BarSheet& sheet, const Rect& piece, const PieceLook& look) {
  Canvas& canvas = sheet.page.canvas();
  const double width = std::min(sheet.page.sizes().outline, sheet.thickness / 4);
  if (piece.width < 3 * width) {
    if (piece.width < 0.05) return;                   // nothing, but for rounding
    const double shown = std::max(piece.width, 3.0);  // to the left: what comes next may be the exact value
    canvas.rect({piece.x + piece.width - shown, piece.y, shown, piece.height}, {.fill = sheet.color});
    return;
  }
  canvas.rect(piece, {.fill = look.fill});
  canvas.hatch(corners_of(piece), {.width = 1.5, .color = look.hatch}, sheet.page.sizes().hatch_pitch * 0.8);
  canvas.rect(inset(piece, width / 2), {.outline = look.outline, .outline_width = width});
}

// What is taken back stays as an empty, hatched piece with a head that points back.
void draw_taken_back(BarSheet& sheet, int row, double from, double to) {
  const Rect piece = part_of(sheet, row, from, to);
  const Color panel = sheet.page.theme().panel;
  draw_piece(sheet, piece, {.fill = panel, .outline = sheet.color, .hatch = faded(sheet.color, 0.8)});
  const double tip = x_of(sheet, to);
  const double direction = to < from ? -1 : 1;
  const double length = std::clamp(piece.width, 5.0, sheet.page.sizes().head_length);
  const double half = std::min(sheet.thickness * 0.35, length * 0.55);
  const double y = piece.y + piece.height / 2;
  const FixedList<Point, 3> head = {Point(tip, y), Point(tip - direction * length, y - half),
                                    Point(tip - direction * length, y + half)};
  sheet.page.canvas().polygon(head, {.fill = sheet.color});
}

// Coloured, outlined and hatched: two of the three are seen without colour.
void draw_given(BarSheet& sheet, int row, double from, double to) {
  draw_piece(sheet, part_of(sheet, row, from, to),
             {.fill = sheet.color,
              .outline = sheet.page.theme().outline,
              .hatch = faded(ink_on(sheet.color), 0.55)});
}

void draw_cut(BarSheet& sheet, double x, double y) {
  Canvas& canvas = sheet.page.canvas();
  const Point slant(4, -sheet.thickness / 2 - 3);
  const auto stroke = [&](double shift, double width, Color color) {
    const Point at(x + shift, y);
    canvas.line(at - slant, at + slant, {.width = width, .color = color});
  };
  stroke(0, 6, sheet.page.theme().panel);
  stroke(-3, 1.5, sheet.page.theme().text);
  stroke(3, 1.5, sheet.page.theme().text);
}

// So that text beside it does not touch it.
Rect widened(const Rect& bar) { return {bar.x - 4, bar.y, bar.width + 8, bar.height}; }

// What is filled, grey or coloured, is the value now.
void draw_bar(BarSheet& sheet, int row) {
  const Bar& bar = sheet.chart.bars[row];
  if (!has_value(bar)) return;
  const double end = end_of(bar);
  const Rect old = part_of(sheet, row, 0, bar.before);
  sheet.page.canvas().rect(old, {.fill = sheet.page.theme().inactive});
  sheet.taken.push_back(widened(old));
  sheet.taken.push_back(widened(part_of(sheet, row, bar.before, end)));
  const double longest = std::abs(bar.before) > std::abs(end) ? bar.before : end;
  const bool seen = !(beyond(sheet, bar.before) && beyond(sheet, end));
  const bool crosses = bar.before * end < 0;
  if (seen && bar.before * bar.added < 0) draw_taken_back(sheet, row, bar.before, crosses ? 0 : end);
  if (seen && (crosses || bar.before * bar.added > 0 || bar.before == 0) && bar.added != 0) {
    draw_given(sheet, row, crosses ? 0 : bar.before, end);
  }
  if (!beyond(sheet, longest)) return;
  draw_cut(sheet, x_of(sheet, longest) - std::copysign(cut_width, longest), middle_of(sheet, row));
}

double tick_reach(const BarSheet& sheet) { return std::min(sheet.thickness / 2 + 6, sheet.pitch / 2 - 1); }

void draw_exact(BarSheet& sheet, int row) {
  const Bar& bar = sheet.chart.bars[row];
  if (!has_exact(bar) || beyond(sheet, *bar.exact)) return;
  const double width = sheet.page.compact() ? 2 : 3;
  const double exact = x_of(sheet, *bar.exact);
  const double x = width == 2 ? std::round(exact) : std::floor(exact) + 0.5;  // whole pixels
  const double y = middle_of(sheet, row);
  const double reach = tick_reach(sheet);
  sheet.page.canvas().line({x, y - reach}, {x, y + reach},
                           {.width = width, .color = sheet.page.theme().exact.color});
  sheet.taken.push_back({x - width / 2 - 2, y - reach, width + 4, 2 * reach});
}

// Where every bar begins.
void draw_axis(BarSheet& sheet) {
  const double x = std::round(x_of(sheet, 0));
  const double bottom = sheet.plot.y + sheet.plot.height;
  sheet.page.canvas().line({x, sheet.plot.y}, {x, bottom},
                           {.width = sheet.page.sizes().axis, .color = sheet.page.theme().secondary_text});
  sheet.taken.push_back({x - 1, sheet.plot.y, 2, sheet.plot.height});
}

}  // namespace

BarPlaces draw_bars(Page& page, const Rect& rect, const BarChart& chart) {
  BarSheet sheet = lay_out_bars(page, rect, chart);
  if (chart.bars.empty()) return {};
  for (int row = 0; row < chart.bars.size(); ++row) draw_bar(sheet, row);
  draw_axis(sheet);
  for (int row = 0; row < chart.bars.size(); ++row) draw_exact(sheet, row);
  write_bar_texts(sheet);
  return {.rows = {sheet.room.x, sheet.plot.y, sheet.room.width, sheet.plot.height},
          .plot = sheet.plot,
          .low = sheet.range.low,
          .high = sheet.range.high,
          .pitch = sheet.pitch};
}

}  // namespace cairn::render
