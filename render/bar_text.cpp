// All text of a bar chart beside its title and key.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/bar_sheet.hpp"
#include "render/lint.hpp"
#include "render/rects.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr double number_gap = 6;  // [px] between a number and what it belongs to

bool within(const Rect& inner, const Rect& outer) {
  constexpr double slack = 4;  // [px] the text of a low first or last row may reach into the panel's padding
  return inner.x >= outer.x && inner.x + inner.width <= outer.x + outer.width && inner.y >= outer.y - slack &&
         inner.y + inner.height <= outer.y + outer.height + slack;
}

// Writes at the first place that is free.
// @returns whether there was one.
bool write(BarSheet& sheet, const List<Point>& places, const std::string& text, const TextStyle& style) {
  for (const Point& at : places) {
    const Rect rect = text_rect(sheet.page.canvas(), at, text, style);
    const auto in_the_way = [&rect](const Rect& other) { return overlap(rect, other); };
    if (!within(rect, sheet.room)) continue;
    if (std::any_of(sheet.taken.begin(), sheet.taken.end(), in_the_way)) continue;
    sheet.page.canvas().text(at, text, style);
    sheet.taken.push_back(
        {rect.x - 2 * number_gap, rect.y - 1, rect.width + 4 * number_gap, rect.height + 2});
    return true;
  }
  return false;
}

// Base lines above, then below the bar, ever further from x until `farthest` px, for centred text. None where
// the text would stand on the next row and seem to belong to it.
List<Point> over_and_under(const BarSheet& sheet, int row, double x, double size, double farthest) {
  List<Point> places;
  if (!has_room_between(sheet, size)) return places;
  const double y = middle_of(sheet, row);
  const double reach = sheet.thickness / 2 + 4;
  for (const double base : {y - reach - 0.06 * size, y + reach + cap_height * size}) {
    for (double shift = 0; shift <= farthest; shift += 2) {
      places.emplace_back(x - shift, base);
      places.emplace_back(x + shift, base);
    }
  }
  return places;
}

// In the middle of the row, from x to the right, not further than `reach` px.
List<Point> behind(const BarSheet& sheet, int row, double x, double size, double reach = 1e4) {
  List<Point> places;
  const double base = baseline_around(middle_of(sheet, row), size);
  const double right = std::min(x + reach, sheet.room.x + sheet.room.width);
  for (double at = x + number_gap; at < right; at += 2) places.emplace_back(at, base);
  return places;
}

TextStyle centered(TextStyle style) {
  style.align = Align::center;
  return style;
}

// @returns whether there was room for it.
bool write_name(BarSheet& sheet, int row) {
  const Bar& bar = sheet.chart.bars[row];
  TextStyle style = bar_text(sheet);
  style.align = Align::right;
  style.bold = bar.active;
  const double right = sheet.room.x + sheet.names;
  const Point at(right, baseline_around(middle_of(sheet, row), style.size));
  return write(sheet, {at}, ellipsized(sheet.page.canvas(), bar.name, sheet.names + 1, style), style);
}

// Beside the tick upon the grey part, in ink that reads there.
bool write_upon_bar(BarSheet& sheet, int row, double x, const std::string& number) {
  const Bar& bar = sheet.chart.bars[row];
  TextStyle style = bar_text(sheet);
  style.halo = sheet.page.theme().inactive;
  style.color = ink_on(style.halo);
  const double end = x_of(sheet, std::min(bar.before, end_of(bar)));
  const double left = x + number_gap;
  const double right = left + sheet.page.canvas().text_width(number, style);
  const bool covered = bar.before > 0 && x >= x_of(sheet, 0) && right <= end - number_gap / 2;
  if (!covered || sheet.thickness < cap_height * style.size + 4) return false;
  const Point at(left, baseline_around(middle_of(sheet, row), style.size));
  sheet.page.canvas().text(at, number, style);
  return true;
}

// Above or below the bar, where the tick ends.
bool write_beside_tick_end(BarSheet& sheet, int row, double x, const std::string& number) {
  TextStyle style = bar_text(sheet);
  for (const Point& at : over_and_under(sheet, row, x, style.size, 0)) {
    style.align = Align::left;
    if (write(sheet, {Point(at.x() + number_gap, at.y())}, number, style)) return true;
    style.align = Align::right;
    if (write(sheet, {Point(at.x() - number_gap, at.y())}, number, style)) return true;
  }
  return false;
}

// Beside the tick; where a bar covers that place above it; or behind the bar with a tick of its own.
void write_exact(BarSheet& sheet, int row) {
  const Bar& bar = sheet.chart.bars[row];
  if (!has_exact(bar)) return;
  TextStyle style = bar_text(sheet);
  const std::string number = exact_number(sheet, bar);
  const double x = x_of(sheet, *bar.exact);
  const double end = x_of(sheet, has_value(bar) ? std::max({0.0, bar.before, end_of(bar)}) : 0);
  const double base = baseline_around(middle_of(sheet, row), style.size);
  if (beyond(sheet, *bar.exact)) {
    write(sheet, behind(sheet, row, end, style.size), exact_note(sheet, bar), style);
    return;
  }
  style.align = *bar.exact < 0 ? Align::right : Align::left;
  if (write(sheet, {Point(x + (*bar.exact < 0 ? -number_gap : number_gap), base)}, number, style)) return;
  if (write_upon_bar(sheet, row, x, number)) return;
  if (write_beside_tick_end(sheet, row, x, number)) return;
  style.align = Align::left;
  write(sheet, behind(sheet, row, std::max(x, end), style.size, 4 * style.size), exact_note(sheet, bar),
        style);
}

// What is added now; behind everything else in rows with no room above the bar.
void write_added(BarSheet& sheet, int row) {
  const Bar& bar = sheet.chart.bars[row];
  if (!bar.active) return;
  const TextStyle style = added_text(sheet);
  const std::string number = fixed(bar.added, sheet.chart.decimals, Sign::always);
  const Rect piece = part_of(sheet, row, bar.before, end_of(bar));
  const double x = piece.x + piece.width / 2;
  if (write(sheet, over_and_under(sheet, row, x, style.size, 4 * style.size), number, centered(style)))
    return;
  write(sheet, behind(sheet, row, piece.x + piece.width, style.size), number, style);
}

// Whether every row has room for its own text.
bool rows_are_apart(const BarSheet& sheet) { return sheet.pitch >= 1.1 * sheet.text_size; }

// A cut bar, or one that could not be drawn, says why.
void write_value(BarSheet& sheet, int row) {
  const Bar& bar = sheet.chart.bars[row];
  const TextStyle style = bar_text(sheet);
  if (!has_value(bar)) {
    write(sheet, behind(sheet, row, x_of(sheet, 0), style.size), "not a number", style);
    return;
  }
  const double end = end_of(bar);
  if (!beyond(sheet, end)) return;
  const std::string number = fixed(end, sheet.chart.decimals);
  if (end > 0 && write(sheet, behind(sheet, row, x_of(sheet, end), style.size), number, style)) return;
  write(sheet, over_and_under(sheet, row, x_of(sheet, end), style.size, 4 * style.size), number,
        centered(style));
}

// The values at the right, in the same place whatever the bars are.
void write_columns(BarSheet& sheet) {
  Canvas& canvas = sheet.page.canvas();
  const double right = sheet.room.x + sheet.room.width;
  for (int row = 0; row < sheet.chart.bars.size(); ++row) {
    const Bar& bar = sheet.chart.bars[row];
    write_name(sheet, row);
    TextStyle style = bar_text(sheet);
    style.align = Align::right;
    const double base = baseline_around(middle_of(sheet, row), style.size);
    if (has_exact(bar)) canvas.text({right, base}, "| " + column_number(sheet, *bar.exact), style);
    style.bold = bar.active;
    const std::string now = has_value(bar) ? column_number(sheet, end_of(bar)) : "not a number";
    canvas.text({right - sheet.column, base}, now, style);
  }
}

// What the two ends of the range are, and 0.
void write_range(const BarSheet& sheet) {
  TextStyle style = sheet.page.tick();
  style.align = Align::center;
  const double base = sheet.plot.y + sheet.plot.height + 1.1 * style.size;
  const auto write_at = [&](double value) {
    sheet.page.canvas().text({x_of(sheet, value), base}, significant(value, 2), style);
  };
  write_at(0);
  write_at(sheet.range.high);
  if (x_of(sheet, 0) > sheet.plot.x + 4 * style.size) write_at(sheet.range.low);
}

}  // namespace

void write_bar_texts(BarSheet& sheet) {
  if (sheet.chart.digits > 0) {
    write_columns(sheet);
    write_range(sheet);
    return;
  }
  const List<Bar>& bars = sheet.chart.bars;
  List<int> order;  // the active row first: it is the one that must be read
  for (int row = 0; row < bars.size(); ++row) order.push_back(row);
  std::stable_partition(order.begin(), order.end(), [&bars](int row) { return bars[row].active; });
  List<int> readable;
  for (const int row : order) {
    if (write_name(sheet, row) || rows_are_apart(sheet)) readable.push_back(row);
  }
  const bool apart = has_room_between(sheet, added_text(sheet).size);
  for (const int row : readable) {
    write_value(sheet, row);
    if (apart) write_added(sheet, row);  // over its piece, and the exact value may not take that place
    write_exact(sheet, row);
    if (!apart) write_added(sheet, row);
  }
}

}  // namespace cairn::render
