// Bars for impulses: what a row has given so far, what it gives now, and what it should have given.
#pragma once

#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include "render/page.hpp"

namespace cairn::render {

struct Bar {
  std::string name = {};  // "row 2"
  double before = 0;      // drawn grey
  double added = 0;       // drawn in the chart's colour, outlined and hatched; one of opposite sign
                          // is taken back from the end of the grey part: not filled, with a head
  std::optional<double> exact = {};  // a black tick with its value
  bool active = false;               // its new part carries the value, such as "+3.75"
};

struct BarChart {
  std::string title = {};       // with the unit: "accumulated λ (N)"
  std::string exact = "exact";  // what the black ticks are
  List<Bar> bars = {};
  double largest = 0;         // the value at the right end; 0: from the data
  double smallest = 0;        // the value at the left end, not above 0; 0: from the data
  Color color = transparent;  // of what is added; transparent: the theme's normal force
  int decimals = 2;
  int digits = 0;  // above 0: values stand in two columns at the right, of bars and of ticks, with so many
                   // digits, to a thousandth of the range; and numbers below the two ends of the range
};

/// Where the bars of a chart are, for those who point at them.
struct BarPlaces {
  Rect rows = {};    // [px] all of them from top to bottom, with their names
  Rect plot = {};    // [px] between the two ends of the range
  double low = 0;    // the value at its left end
  double high = 0;   // and at its right end
  double pitch = 0;  // [px] from row to row
};

/// A panel with horizontal bars from top to bottom. A bar beyond the range is cut, marked "//" and has its
/// value at the cut. In rows less high than text only so many names and values are written as fit, the active
/// row's first.
BarPlaces draw_bars(Page& page, const Rect& rect, const BarChart& chart);

}  // namespace cairn::render
