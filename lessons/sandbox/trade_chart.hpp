// The chart of work against error.
#pragma once

#include <string>

#include "math/list.hpp"
#include "render/image.hpp"
#include "render/page.hpp"
#include "render/theme.hpp"
#include "study/work_precision.hpp"

namespace cairn::sandbox {

struct TradeChart {
  std::string title = {};  // "stack10: 10 boxes, frozen in its 1st step"
  std::string work = {};   // of the axes, with units
  std::string error = {};
  std::string note = {};  // one sentence below the chart
  List<TradePoint> points = {};
  List<std::string> curves = {};  // at most 4 solvers, by name, that get a curve; the others are dots
  bool labels_all = false;        // every point of the front with its setting, where there is room
  int width = 1280;               // [px]
  int height = 720;
};

/// The looks of at most 5 solvers' curves: their own, or what is left where two have the same.
List<render::SeriesStyle> solver_styles(const List<std::string>& solvers, const render::Theme& theme);
/// The name beside a curve.
std::string solver_label(const std::string& solver);
/// The text for pictures, where _ alone would begin a subscript.
std::string unmarked(const std::string& text);
/// A paragraph at the bottom of an area; what is left above it.
render::Rect place_note(render::Page& page, const std::string& note);

/// @throws render::RenderError when nothing can be drawn.
render::Image draw_trade_chart(const TradeChart& chart, const render::Theme& theme);

}  // namespace cairn::sandbox
