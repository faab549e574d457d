// A table in a panel: the first column left-aligned, numbers right-aligned in mono, the active row lit.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/page.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {

namespace {

/// How the table is set in the room there is.
struct TableLayout {
  TextStyle cell = {};
  TextStyle head = {};
  double row_height = 0;
  List<double> widths = {};  // of the columns, without the gaps
  double gap = 0;            // between columns
  int first = 0;             // row shown
  int shown = 0;             // rows
  bool fits = false;
};

int column_count(const TableView& table) {
  int count = table.header.size();
  for (const List<std::string>& row : table.rows) count = std::max(count, row.size());
  return count;
}

double sum_of(const List<double>& widths) {
  double sum = 0;
  for (const double width : widths) sum += width;
  return sum;
}

/// The widths that the cells ask for; when they are too much for the room, all are cut by the same part.
void set_widths(const Canvas& canvas, const Rect& room, const TableView& table, TableLayout& layout) {
  layout.widths.assign(column_count(table), 0);
  const auto widen = [&](const List<std::string>& cells, const TextStyle& style) {
    for (int i = 0; i < cells.size(); ++i) {
      layout.widths[i] = std::max(layout.widths[i], canvas.text_width(cells[i], style));
    }
  };
  widen(table.header, layout.head);
  for (const List<std::string>& row : table.rows) widen(row, layout.cell);
  const double size = layout.cell.size;
  const double gaps = std::max(layout.widths.size() - 1, 0);
  const double left_over = room.width - sum_of(layout.widths);
  // Far apart, the eye loses the row; too close, two numbers look like one.
  layout.gap = gaps > 0 ? std::clamp(left_over / gaps, 0.8 * size, 3.5 * size) : 0;
  const double excess = gaps * layout.gap - left_over;
  layout.fits = excess <= 0;
  if (layout.fits) return;
  const double part = std::max(0.0, 1 - excess / sum_of(layout.widths));
  for (double& width : layout.widths) width *= part;
}

TableLayout table_layout(const Page& page, const Rect& room, const TableView& table, double size,
                         double pitch) {
  TableLayout layout;
  layout.cell = page.value();
  layout.head = page.secondary();
  layout.cell.size = layout.head.size = size;
  set_widths(page.canvas(), room, table, layout);
  layout.row_height = std::round(pitch * size);
  const double head_rows = table.header.empty() ? 0 : 1;
  const double fitting = std::floor(room.height / layout.row_height) - head_rows;
  layout.shown = static_cast<int>(std::min<double>(table.rows.size(), std::max(0.0, fitting)));
  layout.first = table.rows.size() - layout.shown;
  if (table.active_row >= 0) layout.first = std::min(layout.first, table.active_row);
  layout.fits = layout.fits && layout.shown == table.rows.size();
  return layout;
}

/// Type shrinks before rows are left out.
TableLayout best_layout(const Page& page, const Rect& room, const TableView& table, double growth) {
  for (double size = std::round(growth * page.value().size); size > page.sizes().smallest; --size) {
    for (const double pitch : {1.9, 1.6, 1.4}) {
      const TableLayout layout = table_layout(page, room, table, size, pitch);
      if (layout.fits) return layout;
    }
  }
  const TableLayout airy = table_layout(page, room, table, page.sizes().smallest, 1.6);
  return airy.fits ? airy : table_layout(page, room, table, page.sizes().smallest, 1.3);
}

void draw_row(Canvas& canvas, const Point& start, const List<std::string>& cells, const TableLayout& layout,
              TextStyle style, int text_columns) {
  double x = start.x();
  for (int i = 0; i < cells.size(); ++i) {
    const double width = layout.widths[i];
    if (cells[i].empty()) {
      x += width + layout.gap;
      continue;
    }
    const bool is_text = i < text_columns;
    style.align = is_text ? Align::left : Align::right;
    const Point at(is_text ? x : x + width, start.y());
    // Half a pixel more: the width was summed up in another order.
    canvas.text(at, ellipsized(canvas, cells[i], width + 0.5, style), style);
    x += width + layout.gap;
  }
}

/// A bar at the left edge tells the active row without its colour.
void light_row(Page& page, const Rect& row) {
  page.canvas().rect(row, {.fill = page.theme().active_b});
  page.canvas().rect({row.x, row.y, 3, row.height}, {.fill = page.theme().text});
}

}  // namespace

void Page::table(const Rect& rect, std::string_view title, const TableView& table, double growth) {
  const Rect room = panel(rect, title);
  if (column_count(table) == 0) return;
  const TableLayout layout = best_layout(*this, room, table, growth);
  const double used = sum_of(layout.widths) + layout.gap * (layout.widths.size() - 1);
  const double middle = std::round(baseline_around(layout.row_height / 2, layout.cell.size));
  double y = std::round(room.y);
  if (!table.header.empty()) {
    draw_row(canvas_, {room.x, y + middle}, table.header, layout, layout.head, table.text_columns);
    y += layout.row_height;
    canvas_.line({room.x, y - 0.5}, {room.x + used, y - 0.5},
                 {.width = 1, .color = theme_.frame_line, .dash = {}});
  }
  for (int i = layout.first; i < layout.first + layout.shown; ++i) {
    const double beside = 0.5 * sizes_.padding;
    if (i == table.active_row) {
      light_row(*this, {room.x - beside, y, used + 2 * beside, layout.row_height});
    }
    const bool hidden_above = i == layout.first && i > 0 && layout.shown > 2 && i != table.active_row;
    const List<std::string> more = {"⋮"};
    draw_row(canvas_, {room.x, y + middle}, hidden_above ? more : table.rows[i], layout, layout.cell,
             table.text_columns);
    y += layout.row_height;
  }
}

}  // namespace cairn::render
