// The parts of a plot, for its own source files only: axes, curves and labels in pixels.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "render/plot.hpp"

namespace cairn::render {

struct Range {
  double min = 0;
  double max = 1;
};

/// One axis on the page: which value is where, and what its ticks say.
struct AxisView {
  AxisScale scale = AxisScale::linear;
  Range range = {};
  double from = 0;  // [px] where range.min is
  double to = 1;    // [px] where range.max is
  List<double> ticks = {};
  List<std::string> labels = {};

  double pixel(double value) const;
};

/// Where everything of a plot is.
struct PlotFrame {
  Rect panel = {};  // what may be written in
  Rect box = {};    // between the axes: no curve leaves it
  AxisView x = {};
  AxisView y = {};

  Point pixel(double x_value, double y_value) const { return {x.pixel(x_value), y.pixel(y_value)}; }
};

/// One series on the page.
struct Curve {
  List<List<Point>> pieces = {};  // what is inside the box; more than one where it left or had a gap
  List<Point> points = {};        // the data inside the box
};

/// Whether a value has a place on such an axis.
bool plottable(double value, AxisScale scale);

/// From the axis where it is given, else from the values; never empty.
Range range_of(const Axis& axis, const List<double>& values);
/// Widened to the next tick, where the axis leaves that free.
Range widened(const Range& range, const Axis& axis, int count);
/// Ticks and their labels for the axis's range.
void set_ticks(AxisView& axis, int count);

/// `gutter`: the width kept free right of the box [px].
PlotFrame lay_out(const Page& page, const Rect& panel, const Plot& plot, double gutter);
/// Grid, box, ticks and titles.
void draw_axes(Page& page, const PlotFrame& frame, const Plot& plot);

Curve curve_of(const PlotFrame& frame, const Series& series);
/// Draws all curves, then all markers, and notes the curves for lint().
void draw_curves(Page& page, const PlotFrame& frame, const Plot& plot, const List<Curve>& curves);

/// The cloud and the front.
void draw_background(Page& page, const PlotFrame& frame, const Plot& plot);

/// A marker in any paint; a tick is a line in the outline's colour.
void paint_marker(Canvas& canvas, const Point& at, Marker marker, double radius, const Paint& paint);

/// How the name of a series is written: in its colour where the type is large enough to be read in it.
TextStyle series_label(const Page& page, const Series& series);
/// The width needed right of the box for the names of curves that reach its right end [px].
double gutter_width(const Page& page, const PlotFrame& frame, const Plot& plot, const List<Curve>& curves);
void draw_goals(Page& page, const PlotFrame& frame, const Plot& plot);
/// Texts of the goals and names of the series, each where it stands on no curve and no other text.
void draw_plot_labels(Page& page, const PlotFrame& frame, const Plot& plot, const List<Curve>& curves);

/// The places nearest to `wanted` that are `distance` apart, in the same order, between low and high if they
/// fit.
List<double> moved_apart(const List<double>& wanted, double distance, double low, double high);

/// Whether the curve or one of its points is in the rectangle.
bool meets(const Curve& curve, const Rect& rect);

}  // namespace cairn::render
