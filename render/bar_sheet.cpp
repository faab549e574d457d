// The layout of a bar chart.
#include "render/bar_sheet.hpp"

#include <algorithm>
#include <cmath>

#include "render/text_layout.hpp"

namespace cairn::render {
namespace {

constexpr double largest_pitch = 84;      // [px] more would tear few rows apart
constexpr double largest_thickness = 46;  // [px]
constexpr double text_gap = 8;            // [px] between a text and what it belongs to

BarRange range_of(const BarChart& chart) {
  BarRange range;
  const auto include = [&range](double value) {
    if (!std::isfinite(value)) return;
    range = {std::min(range.low, value), std::max(range.high, value)};
  };
  for (const Bar& bar : chart.bars) {
    include(bar.before);
    include(end_of(bar));
    include(bar.exact.value_or(0));
  }
  if (chart.largest > 0) range.high = chart.largest;
  if (chart.smallest < 0) range.low = chart.smallest;
  if (!(range.high > range.low)) range.high = range.low + 1;
  return range;
}

// As few as show every exact value as precisely as `decimals` would: 30, 20, 10 need none.
int decimals_of_exact(const BarChart& chart) {
  for (int decimals = 0; decimals < chart.decimals; ++decimals) {
    const auto shown = [&](const Bar& bar) {
      const double scaled = (has_exact(bar) ? *bar.exact : 0) * std::pow(10, decimals);
      return std::abs(scaled - std::round(scaled)) < 0.5 * std::pow(10, decimals - chart.decimals);
    };
    if (std::all_of(chart.bars.begin(), chart.bars.end(), shown)) return decimals;
  }
  return chart.decimals;
}

// The key "| exact": beside the title if there is room, else in a line of its own, which it takes from
// `room`.
void write_key(const BarSheet& sheet, const Rect& rect, Rect& room) {
  Page& page = sheet.page;
  Canvas& canvas = page.canvas();
  TextStyle style = page.secondary();
  const double width = canvas.text_width(sheet.chart.exact, style) + text_gap;
  const bool beside =
      !sheet.chart.title.empty() &&
      canvas.text_width(sheet.chart.title, page.secondary()) + width + 3 * text_gap < room.width;
  const double line = 1.75 * style.size;
  const double top = beside ? rect.y + page.sizes().padding : room.y;
  const double baseline = std::round(top + 0.85 * style.size);
  const double right = room.x + room.width;
  style.align = Align::right;
  canvas.text({right, baseline}, sheet.chart.exact, style);
  const double x = std::round(right - width);
  canvas.line({x, baseline + 0.15 * style.size}, {x, baseline - 0.85 * style.size},
              {.width = page.compact() ? 2.0 : 3.0, .color = page.theme().exact.color});
  if (beside) return;
  room.y += line;
  room.height = std::max(0.0, room.height - line);
}

double widest_name(const BarSheet& sheet) {
  TextStyle style = bar_text(sheet);
  style.bold = true;  // the active row's
  double width = 0;
  for (const Bar& bar : sheet.chart.bars)
    width = std::max(width, sheet.page.canvas().text_width(bar.name, style));
  return std::ceil(width);
}

// What may be written to the left of the range's begin.
double widest_negative(const BarSheet& sheet) {
  double width = 0;
  for (const Bar& bar : sheet.chart.bars) {
    if (!has_exact(bar) || *bar.exact >= 0) continue;
    width =
        std::max(width, sheet.page.canvas().text_width(exact_number(sheet, bar), bar_text(sheet)) + text_gap);
  }
  return std::ceil(width);
}

// What may be written to the right of the range's end.
double widest_number(const BarSheet& sheet) {
  const Canvas& canvas = sheet.page.canvas();
  const int decimals = sheet.chart.decimals;
  const bool dense = !has_room_between(sheet, added_text(sheet).size);
  double widest = 0;
  for (const Bar& bar : sheet.chart.bars) {
    double width = 0;
    const auto add = [&](const std::string& text, const TextStyle& style) {
      width += canvas.text_width(text, style) + 2 * text_gap;
    };
    if (has_exact(bar)) add(exact_note(sheet, bar), bar_text(sheet));
    if (beyond(sheet, end_of(bar))) add(fixed(end_of(bar), decimals), bar_text(sheet));
    if (dense && bar.active) add(fixed(bar.added, decimals, Sign::always), added_text(sheet));
    widest = std::max(widest, width);
  }
  return std::ceil(widest);
}

// Of a column of values: the same for all numbers of usual length, so that bars keep their place.
double column_width(const BarSheet& sheet) {
  const Canvas& canvas = sheet.page.canvas();
  TextStyle style = bar_text(sheet);
  style.bold = true;
  double widest = canvas.text_width("| 000", style);
  for (const Bar& bar : sheet.chart.bars) {
    widest = std::max(widest, canvas.text_width(column_number(sheet, end_of(bar)), style));
    if (has_exact(bar))
      widest = std::max(widest, canvas.text_width("| " + column_number(sheet, *bar.exact), style));
  }
  return std::ceil(widest) + text_gap;
}

void divide(BarSheet& sheet) {
  const bool has_columns = sheet.chart.digits > 0;
  if (has_columns) sheet.room.height -= 1.5 * sheet.page.tick().size;
  const Rect& room = sheet.room;
  const double count = sheet.chart.bars.size();
  sheet.pitch = std::min(largest_pitch, room.height / count);
  const double part = sheet.pitch >= 24 ? 0.55 : 0.7;
  sheet.thickness = std::clamp(std::floor(part * sheet.pitch), 2.0, largest_thickness);
  sheet.text_size = std::clamp(std::floor(sheet.pitch / 1.2), 12.0, sheet.page.value().size);
  sheet.names = std::min(widest_name(sheet), 0.4 * room.width);
  sheet.column = has_columns ? std::min(column_width(sheet), 0.2 * room.width) : 0;
  const double negative = has_columns ? 0 : std::min(widest_negative(sheet), 0.2 * room.width);
  const double left = sheet.names + 2 * text_gap + negative;
  const double right = has_columns ? 2 * sheet.column : std::min(widest_number(sheet), 0.35 * room.width);
  const double height = sheet.pitch * count;
  sheet.plot = {std::round(room.x + left), room.y + (room.height - height) / 2,
                std::max(1.0, std::floor(room.width - left - right)), height};
}

}  // namespace

bool has_exact(const Bar& bar) { return bar.exact.has_value() && std::isfinite(*bar.exact); }

bool has_value(const Bar& bar) { return !std::isnan(bar.before) && !std::isnan(end_of(bar)); }

bool beyond(const BarSheet& sheet, double value) {
  const double slack = 1e-9 * (sheet.range.high - sheet.range.low);
  return value > sheet.range.high + slack || value < sheet.range.low - slack;
}

double x_of(const BarSheet& sheet, double value) {
  const double part = (value - sheet.range.low) / (sheet.range.high - sheet.range.low);
  return sheet.plot.x + sheet.plot.width * std::clamp(part, 0.0, 1.0);
}

double middle_of(const BarSheet& sheet, int row) {
  return std::round(sheet.plot.y + sheet.pitch * (row + 0.5));
}

Rect part_of(const BarSheet& sheet, int row, double from, double to) {
  const double a = x_of(sheet, from);
  const double b = x_of(sheet, to);
  return {std::min(a, b), middle_of(sheet, row) - sheet.thickness / 2, std::abs(b - a), sheet.thickness};
}

bool has_room_between(const BarSheet& sheet, double size) {
  return sheet.pitch - sheet.thickness >= cap_height * size + 4;
}

TextStyle bar_text(const BarSheet& sheet) {
  TextStyle style = sheet.page.value();
  style.size = sheet.text_size;
  style.color = sheet.page.theme().text;
  return style;
}

TextStyle added_text(const BarSheet& sheet) {
  TextStyle style = bar_text(sheet);
  style.bold = true;
  if (!sheet.page.compact() && has_room_between(sheet, large_text)) {
    style.size = std::max(style.size, large_text);
    style.color = sheet.color;
  }
  return style;
}

std::string column_number(const BarSheet& sheet, double value) {
  const double largest = std::max(sheet.range.high, -sheet.range.low);
  const double least = std::pow(10, std::floor(std::log10(largest)) - 3);  // what a column tells apart
  if (std::abs(value) < 1e3 * largest) value = least * std::round(value / least);
  const double size = std::abs(value);
  const int whole = size >= 1 && size < 1e5 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  return significant(value, std::max(sheet.chart.digits, whole));
}

std::string exact_number(const BarSheet& sheet, const Bar& bar) {
  return fixed(bar.exact.value_or(0), sheet.decimals);
}

std::string exact_note(const BarSheet& sheet, const Bar& bar) {
  const std::string note = "| " + exact_number(sheet, bar);
  if (!beyond(sheet, bar.exact.value_or(0))) return note;
  return *bar.exact > 0 ? note + " →" : "← " + note;
}

BarSheet lay_out_bars(Page& page, const Rect& rect, const BarChart& chart) {
  BarSheet sheet = {.page = page, .chart = chart};
  sheet.color = chart.color.a > 0 ? chart.color : page.theme().normal;
  sheet.room = page.panel(rect, chart.title);
  if (std::any_of(chart.bars.begin(), chart.bars.end(), has_exact)) write_key(sheet, rect, sheet.room);
  sheet.range = range_of(chart);
  sheet.decimals = decimals_of_exact(chart);
  if (!chart.bars.empty()) divide(sheet);
  return sheet;
}

}  // namespace cairn::render
