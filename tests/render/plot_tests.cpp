// Charts: ticks, where points land, what may be drawn where, and words that meet nothing.
#include "render/pictures.hpp"
#include "render/plot.hpp"
#include "render/plot_parts.hpp"

namespace {

using cairn::List;
using namespace cairn::render;

constexpr double not_plottable = std::numeric_limits<double>::quiet_NaN();

const SeriesStyle red_line = {.color = rgb(0xFF0000), .dash = {}, .marker = Marker::circle};
const SeriesStyle blue_line = {.color = rgb(0x0000FF), .dash = {}, .marker = Marker::circle};

/// The pixels of nearly this colour: how many, where, and their middle.
struct ColoredPixels {
  int count = 0;
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
  double x = 0, y = 0;  // [px] mean of the pixels' centres
};

ColoredPixels pixels_of_color(const Image& image, const Color& color) {
  ColoredPixels found;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (sum_off(image, x, y, color) > 90) continue;
      found.count += 1;
      found.left = std::min(found.left, x), found.right = std::max(found.right, x);
      found.top = std::min(found.top, y), found.bottom = std::max(found.bottom, y);
      found.x += x + 0.5, found.y += y + 0.5;
    }
  }
  if (found.count > 0) found.x /= found.count, found.y /= found.count;
  return found;
}

constexpr Rect plot_rect = {20, 40, 600, 300};

/// With the plot on it, if there is one.
struct PlotPage : Page {
  PlotPage() : Page(640, 360, light_theme()) { begin({.title = "Plot"}); }
  explicit PlotPage(const Plot& plot) : PlotPage() { draw_plot(*this, plot_rect, plot); }
};

/// Where the axes of a plot without names are: the panel is drawn on a page of its own.
PlotFrame frame_without_names(const Plot& plot) {
  PlotPage page;
  return lay_out(page, page.panel(plot_rect, plot.title), plot, page.sizes().tick);
}

Plot unit_plot() {
  Plot plot;
  plot.x = {.title = "t (s)", .min = 0, .max = 1};
  plot.y = {.title = "x (m)", .min = 0, .max = 1};
  return plot;
}

List<Series> series_that_end_together(const Theme& theme) {
  List<Series> all;
  for (const SeriesStyle& style : {theme.pgs, theme.si, theme.box2d, theme.jacobi}) {
    Series series{.name = "series " + std::to_string(all.size()), .style = style};
    for (int i = 0; i <= 20; ++i) {
      series.x.push_back(i);
      series.y.push_back(2 + 0.001 * all.size() * i);
    }
    all.push_back(series);
  }
  return all;
}

Plot convergence_plot(const Theme& theme) {
  Plot plot;
  plot.x.title = "sweeps";
  plot.y = {.title = "largest |λ − λ*| / 100 N", .scale = AxisScale::logarithmic, .min = 1e-4};
  plot.goals.push_back({.y = 0.01, .text = "1 % goal"});
  const List<std::pair<std::string, double>> rates = {
      {"PGS", 0.975}, {"SI", 0.975}, {"SOR", 0.78}, {"Jacobi", 0.99}};
  const List<SeriesStyle> styles = {theme.pgs, theme.si, theme.box2d, theme.jacobi};
  for (int k = 0; k < rates.size(); ++k) {
    Series series{.name = rates[k].first, .style = styles[k]};
    for (int i = 0; i <= 60; ++i) {
      series.x.push_back(i);
      series.y.push_back(std::pow(rates[k].second, i));
    }
    plot.series.push_back(series);
  }
  return plot;
}

}  // namespace

TEST_CASE("a point lands where its share of the axes is") {
  Plot plot = unit_plot();
  plot.series.push_back({.style = red_line, .x = {0.25}, .y = {0.7}});
  const PlotFrame frame = frame_without_names(plot);
  PlotPage page(plot);
  const ColoredPixels dot = pixels_of_color(page.canvas().read(), red_line.color);
  const double rim = 2 * page.sizes().marker;
  REQUIRE(dot.count > 10);
  CHECK(dot.x == doctest::Approx(frame.box.x + rim + 0.25 * (frame.box.width - 2 * rim)).epsilon(0.002));
  CHECK(dot.y == doctest::Approx(frame.box.y + rim + 0.3 * (frame.box.height - 2 * rim)).epsilon(0.002));
}

TEST_CASE("a curve never paints outside its axes") {
  Plot plot = unit_plot();
  Series wild{.style = red_line};
  for (int i = -20; i <= 60; ++i) {
    wild.x.push_back(i * 0.025);
    wild.y.push_back(i % 3 == 0 ? 1e30 : 3 * std::sin(i));
  }
  plot.series.push_back(wild);
  const PlotFrame frame = frame_without_names(plot);
  PlotPage page(plot);
  const ColoredPixels curve = pixels_of_color(page.canvas().read(), red_line.color);
  CHECK(curve.count > 500);
  CHECK(curve.left >= frame.box.x - 1);
  CHECK(curve.right <= frame.box.x + frame.box.width);
  CHECK(curve.top >= frame.box.y - 1);
  CHECK(curve.bottom <= frame.box.y + frame.box.height);
}

TEST_CASE("a value that is not a number leaves a gap in its curve") {
  Plot plot = unit_plot();
  Series broken{
      .style = red_line, .x = {0, 0.2, 0.4, 0.6, 0.8, 1}, .y = {0.5, 0.5, not_plottable, 0.5, 0.5, 0.5}};
  broken.markers = false;
  plot.series.push_back(broken);
  PlotPage page(plot);
  REQUIRE(page.curves().size() == 2);
  const double from = page.curves()[0].back().x();
  const double to = page.curves()[1].front().x();
  const Image image = page.canvas().read();
  const int y = static_cast<int>(page.curves()[0].back().y());
  for (double x = from + 4; x < to - 4; ++x) {
    const int at = 3 * (y * 640 + static_cast<int>(x));
    REQUIRE(image.pixels[at + 1] > 128);  // red has no green
  }
}

TEST_CASE("names at the ends of curves that end together do not overlap") {
  for (const int height : {360, 720}) {
    Page page(height * 16 / 9, height, dark_theme());
    page.begin({.title = "Plot"});
    Plot plot;
    plot.x.title = "t (s)";
    plot.y.title = "x (m)";
    plot.series = series_that_end_together(page.theme());
    draw_plot(page, page.area(), plot);
    CHECK(lint(page) == List<std::string>{});
    int names = 0;
    for (const TextBox& box : page.canvas().text_boxes()) names += box.text.rfind("series ", 0) == 0 ? 1 : 0;
    CHECK(names == 4);
  }
}

TEST_CASE("no title, tick or text of a plot stands upon its curves") {
  for (const int height : {360, 720}) {
    Page page(height * 16 / 9, height, light_theme());
    page.begin({.title = "Plot"});
    draw_plot(page, page.area(), convergence_plot(page.theme()));
    CHECK(lint(page) == List<std::string>{});
    CHECK(page.curves().size() == 4);
  }
}

TEST_CASE("of two curves that coincide both are seen by their markers") {
  Plot plot = unit_plot();
  for (const SeriesStyle& style : {red_line, blue_line}) {
    Series series{.style = style};
    for (int i = 0; i <= 100; ++i) {
      series.x.push_back(0.01 * i);
      series.y.push_back(0.5);
    }
    plot.series.push_back(series);
  }
  PlotPage page(plot);
  const double radius = page.sizes().marker;
  // Six markers each, less their rims; the blue curve covers part of the red ones' neighbourhood, not the
  // markers.
  const int least = static_cast<int>(6 * 0.5 * cairn::pi * radius * radius);
  CHECK(pixels_of_color(page.canvas().read(), red_line.color).count > least);
  CHECK(pixels_of_color(page.canvas().read(), blue_line.color).count > least);
}

TEST_CASE("a curve of few points shows each of them, also where another curve has one") {
  Plot plot = unit_plot();
  plot.series.push_back({.style = red_line, .x = {0.1, 0.5, 0.9}, .y = {0.5, 0.5, 0.5}});
  plot.series.push_back({.style = blue_line, .x = {0.1, 0.5, 0.9}, .y = {0.5, 0.2, 0.2}});
  PlotPage page(plot);
  const ColoredPixels blue = pixels_of_color(page.canvas().read(), blue_line.color);
  const double first = frame_without_names(plot).x.pixel(0.1);
  CHECK(std::abs(blue.left - (first - page.sizes().marker)) <= 1.5);  // its rim is a pixel of the panel
}

TEST_CASE("a name never stands nearer to another curve than to its own") {
  Plot plot = unit_plot();  // both end early; left of the lower one's end runs the upper one
  plot.series.push_back({.name = "upper", .style = red_line, .x = {0, 0.6}, .y = {0.62, 0.62}});
  plot.series.push_back({.name = "lower", .style = blue_line, .x = {0, 0.6}, .y = {0.5, 0.5}});
  PlotPage page(plot);
  const PlotFrame frame = frame_without_names(plot);
  for (const TextBox& box : page.canvas().text_boxes()) {
    if (box.text != "upper" && box.text != "lower") continue;
    const double middle = box.rect.y + box.rect.height / 2;
    const double upper = std::abs(middle - frame.y.pixel(0.62)),
                 lower = std::abs(middle - frame.y.pixel(0.5));
    CHECK((box.text == "upper") == (upper < lower));
  }
}

TEST_CASE("a name inside a plot keeps off the line that says where we are") {
  Plot plot = unit_plot();
  plot.series.push_back({.name = "error", .style = red_line, .x = {0, 0.5}, .y = {0.9, 0.1}});
  plot.now = 0.55;
  PlotPage page(plot);
  const double line = frame_without_names(plot).x.pixel(0.55);
  bool is_written = false;
  for (const TextBox& box : page.canvas().text_boxes()) {
    if (box.text != "error") continue;
    is_written = true;
    CHECK((box.rect.x > line || box.rect.x + box.rect.width < line));
  }
  CHECK(is_written);
}

TEST_CASE("data without extent, without points, or beyond all bounds is drawn all the same") {
  const double infinite = std::numeric_limits<double>::infinity();
  const List<List<double>> heights = {{},
                                      {2},
                                      {0, 0, 0},
                                      {5, 5, 5},
                                      {not_plottable, not_plottable},
                                      {1, infinite, 3},
                                      {-1e299, 1e299},
                                      {1e-299, 2e-299}};
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
    for (const List<double>& height : heights) {
      Plot plot;
      plot.y.scale = scale;
      Series series{.name = "x", .style = red_line, .y = height};
      for (int i = 0; i < height.size(); ++i) series.x.push_back(i);
      plot.series.push_back(series);
      PlotPage page(plot);
      CHECK(lint(page) == List<std::string>{});
      const bool has_points =
          std::any_of(height.begin(), height.end(), [&](double y) { return plottable(y, scale); });
      CHECK((pixels_of_color(page.canvas().read(), red_line.color).count > 0) == has_points);
    }
  }
}

TEST_CASE("a plot refuses five series, and coordinates without a partner") {
  PlotPage page;
  Plot plot;
  plot.series.resize(5);
  CHECK_THROWS_WITH_AS(draw_plot(page, plot_rect, plot), "draw_plot: series must be at most 4, got 5",
                       std::invalid_argument);
  plot.series.resize(1);
  plot.series[0].x = {1, 2};
  plot.series[0].y = {1};
  CHECK_THROWS_WITH_AS(draw_plot(page, plot_rect, plot), "draw_plot: x must be as long as y, got 2 and 1",
                       std::invalid_argument);
}

TEST_CASE("a plot of four solvers looks as it did") {
  Page page(640, 360, light_theme());
  page.begin({.number = "18", .title = "Speed against accuracy", .state = "one cold step"});
  draw_plot(page, page.area(), convergence_plot(page.theme()));
  cairn::test::check_golden("plot_light", page.canvas().read());
}
