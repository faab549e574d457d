// Draws anti-aliased shapes and text, offscreen. Coordinates are pixels, x right, y DOWN, in double. On a
// sharp canvas each is `scale` pixels of the image wide: lengths, widths and sizes of type stay what they
// are.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include <cairn/math/list.hpp>
#include <cairn/math/math.hpp>

namespace cairn::render {

using Point = Vec2<double>;  // [px]

/// Straight (not premultiplied) sRGB, 0..1.
struct Color {
  float r = 0, g = 0, b = 0, a = 1;
};

/// 0xRRGGBB, opaque.
Color rgb(std::uint32_t hex);
/// The same colour at another opacity.
Color faded(Color color, double opacity);

/// Nothing is drawn in this colour.
inline constexpr Color transparent = {0, 0, 0, 0};

struct Rect {
  double x = 0, y = 0, width = 0, height = 0;  // [px], x and y of the top left corner
};

/// Fill and outline of one shape, drawn together. The outline is centred on the edge.
struct Paint {
  Color fill = transparent;
  Color outline = transparent;
  double outline_width = 0;  // [px]
};

/// A stroke; `dash` alternates lengths drawn and left out [px], empty: solid.
struct Stroke {
  double width = 1;  // [px]
  Color color = {};
  List<double> dash = {};
};

/// Whole pixels of an image.
struct ImageSize {
  int width = 0;
  int height = 0;
};

enum class Align { left, center, right };

struct TextStyle {
  double size = 16;  // [px], the em; never scaled with the frame
  Color color = {};
  bool bold = false;
  bool mono = false;
  Align align = Align::left;
  Color halo = transparent;  // a soft rim behind the glyphs, for text over lines
};

/// What was written where: for layout checks that need no golden image.
struct TextBox {
  std::string text = {};
  Rect rect = {};
  TextStyle style = {};
};

/// 8-bit RGB, top row first.
struct Image {
  int width = 0;
  int height = 0;
  List<std::uint8_t> pixels = {};  // width * height * 3
};

/// No context, no font, no file: the message says which, and what to do.
struct RenderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class SvgDrawing;

/// One drawing surface with a GL context of its own, used from one thread.
/// Coordinates that are not finite or absurdly large draw nothing and harm nothing else.
class Canvas {
 public:
  /// An image of width * scale by height * scale, to the nearest pixel.
  /// @throws RenderError when no OSMesa or EGL context can be made, std::invalid_argument for sizes that are
  /// not positive or a scale that is not between 0.5 and 4.
  Canvas(int width, int height, double scale = 1);
  /// An image of exactly this size, `scale` pixels of it to one of the canvas. @throws as above
  Canvas(const ImageSize& image, double scale);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  int width() const;
  int height() const;
  double scale() const;

  /// Begins a new frame: forgets everything drawn, clips and text boxes.
  void clear(Color background);

  void line(const Point& from, const Point& to, const Stroke& stroke);
  void polyline(Span<const Point> points, const Stroke& stroke);
  void circle(const Point& center, double radius, const Paint& paint);
  /// Convex, either turning sense; `rounding` grows it by a radius on all sides.
  void polygon(Span<const Point> points, const Paint& paint, double rounding = 0);
  void rect(const Rect& rect, const Paint& paint, double corner_radius = 0);
  /// All points within `radius` of the segment.
  void capsule(const Point& from, const Point& to, double radius, const Paint& paint);
  /// Parallel lines at 45 degrees inside a convex polygon, `pitch` px apart horizontally.
  void hatch(Span<const Point> points, const Stroke& stroke, double pitch);

  /// Markup: `v_{rel}` and `x^{2}` (or one character without braces) set sub- and superscripts; `\_` and `\^`
  /// are literal. Variables are slanted (render/variables.hpp). `at` is the baseline at the left end, centre
  /// or right end, by style.align.
  void text(const Point& at, std::string_view markup, const TextStyle& style);
  double text_width(std::string_view markup, const TextStyle& style) const;

  /// Nothing is drawn outside the clip (the intersection of all that are pushed).
  void push_clip(const Rect& rect);
  void pop_clip();

  /// From now on `drawing` takes every shape as well, and is cleared with the canvas; null: none does.
  void record(SvgDrawing* drawing);

  /// Everything written since clear().
  Span<const TextBox> text_boxes() const;

  /// Draws what is pending and reads the frame back.
  Image read();

  /// Draws what is pending and puts the frame on the page of a browser.
  void show();

  /// "osmesa", "egl" or "webgl".
  std::string backend() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cairn::render
