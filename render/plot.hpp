// Charts: axes with round ticks, linear or logarithmic, series labelled at their ends.
#pragma once

#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include "render/page.hpp"

namespace cairn::render {

enum class AxisScale { linear, logarithmic };

struct Axis {
  std::string title = {};  // with its unit: "t (s)"
  AxisScale scale = AxisScale::linear;
  std::optional<double> min = {};  // from the data if not given
  std::optional<double> max = {};
};

struct Series {
  std::string name = {};  // written at its right end, moved apart from the others
  SeriesStyle style = {};
  List<double> x = {};
  List<double> y = {};  // NaN leaves a gap; on a log axis what is not > 0 is left out
  bool line = true;
  bool markers = true;  // a few, evenly spread

  /// One more point.
  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// A horizontal dashed line with its text: "1 % goal".
struct GoalLine {
  double y = 0;
  std::string text = {};
};

/// Points that belong together: where x and y are.
struct Places {
  List<double> x = {};
  List<double> y = {};
};

/// What is written beside a point, where there is room for it.
struct PointLabel {
  double x = 0;
  double y = 0;
  std::string text = {};
};

struct Plot {
  std::string title = {};
  Axis x = {};
  Axis y = {};
  List<Series> series = {};  // at most 4
  List<GoalLine> goals = {};
  std::optional<double> cursor = {};  // a vertical line at this x
  std::optional<double> now = {};     // the same, and what of the curves is beyond it is pale: their future
  Places cloud = {};                  // small and faint, behind everything: all that was tried
  Places front = {};                  // a wide and faint line behind the curves: what nothing tried beats
  List<PointLabel> labels = {};
};

/// A curve over 0, 1, 2, ...: what each step or sweep has left.
Series over_steps(const std::string& name, const SeriesStyle& style, const List<double>& y);

/// A panel with the plot. Nothing is drawn outside its axes.
/// @throws std::invalid_argument for more than 4 series, or x and y of different length.
void draw_plot(Page& page, const Rect& rect, const Plot& plot);

/// Round numbers (1, 2 or 5 times a power of ten) inside [min, max], at most `count` of them.
List<double> round_ticks(double min, double max, int count);
/// Powers of ten inside [min, max], thinned to at most `count`.
List<double> decade_ticks(double min, double max, int count);

void draw_marker(Canvas& canvas, const Point& at, Marker marker, double radius, Color color);

}  // namespace cairn::render
