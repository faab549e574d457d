// The layout of a bar chart: which value is where. Shared by what draws bars and what writes beside them.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "render/bars.hpp"

namespace cairn::render {

struct BarRange {
  double low = 0;   // at the left end
  double high = 1;  // at the right end
};

/// The chart on its page, and which places are taken.
struct BarSheet {
  Page& page;
  const BarChart& chart;
  Color color = {};  // of what is added
  Rect room = {};    // [px] inside the panel, below its title
  Rect plot = {};    // [px] between the two ends of the range, all rows
  BarRange range = {};
  double names = 0;      // [px] width of the names, at the left of the room
  double pitch = 0;      // [px] from row to row
  double thickness = 0;  // [px] of a bar
  double text_size = 0;  // [px]
  int decimals = 0;      // of exact values
  double column = 0;     // [px] width of a column of values, where there are any
  List<Rect> taken = {};
};

/// Draws the panel with its title and key and divides what is left.
BarSheet lay_out_bars(Page& page, const Rect& rect, const BarChart& chart);
/// Names, exact values, the active row's addition, values of bars that are cut: each where nothing else
/// stands.
void write_bar_texts(BarSheet& sheet);

/// Where a bar ends now.
inline double end_of(const Bar& bar) { return bar.before + bar.added; }
bool has_exact(const Bar& bar);
/// Neither end is "not a number".
bool has_value(const Bar& bar);
/// Outside the range, rounding aside.
bool beyond(const BarSheet& sheet, double value);
/// Inside the plot, whatever the value.
double x_of(const BarSheet& sheet, double value);
double middle_of(const BarSheet& sheet, int row);
/// The bar between two values, either of which may be the larger.
Rect part_of(const BarSheet& sheet, int row, double from, double to);

/// Whether text of this size fits between the bars of two rows.
bool has_room_between(const BarSheet& sheet, double size);

TextStyle bar_text(const BarSheet& sheet);
/// Of the active row's addition. In its colour only where that is large enough to be read.
TextStyle added_text(const BarSheet& sheet);
/// A value of a chart with columns.
std::string column_number(const BarSheet& sheet, double value);
std::string exact_number(const BarSheet& sheet, const Bar& bar);
/// The number for a place away from its tick: "| 30", and "| 30 →" where the tick is beyond the range.
std::string exact_note(const BarSheet& sheet, const Bar& bar);

}  // namespace cairn::render
