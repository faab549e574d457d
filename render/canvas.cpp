// The canvas: gathers shapes and text into a batch, and draws the batch when the frame is read.
#include "render/canvas.hpp"

#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>
#include "render/batch.hpp"
#include "render/font.hpp"
#include "render/markup.hpp"
#include "render/rects.hpp"
#include "render/shapes.hpp"
#include "render/surface.hpp"
#include "render/svg.hpp"

namespace cairn::render {
namespace {

constexpr double least_text = 1;       // [px]
constexpr double greatest_text = 400;  // [px]
constexpr int enough = 200000;         // vertices; then they are drawn before more are gathered

Face face_of(const TextStyle& style) {
  if (style.mono) {
    return style.bold ? Face::mono_bold : Face::mono;
  }
  return style.bold ? Face::bold : Face::regular;
}

bool drawable(const TextStyle& style) { return style.size >= least_text && style.size <= greatest_text; }

/// How far the halo reaches beyond the glyphs [px of the image].
int halo_reach(const TextStyle& style, double scale) {
  return style.halo.a > 0 ? static_cast<int>(std::lround(scale * std::clamp(0.16 * style.size, 2.0, 5.0)))
                          : 0;
}

Paint scaled(Paint paint, double by) {
  paint.outline_width *= by;
  return paint;
}

Stroke scaled(Stroke stroke, double by) {
  stroke.width *= by;
  for (double& length : stroke.dash) length *= by;
  return stroke;
}

List<Point> scaled(Span<const Point> points, double by) {
  List<Point> scaled;
  for (const Point& point : points) scaled.push_back(by * point);
  return scaled;
}

int image_pixels(int pixels, double scale) { return static_cast<int>(std::lround(scale * pixels)); }

/// How many pixels of the canvas an image has room for, up to round-off.
int whole_pixels(int image_pixels, double scale) {
  return static_cast<int>(std::floor(image_pixels / scale + 1e-6));
}

void check_size(int width, int height, double scale) {
  require(width > 0, "Canvas", "width", "positive px", width);
  require(height > 0, "Canvas", "height", "positive px", height);
  require(scale >= 0.5 && scale <= 4, "Canvas", "scale", "from 0.5 to 4", scale);
}

/// Box of a capsule; a point gives a disk.
Box capsule_box(const Point& from, const Point& to, double radius) {
  const Point span = to - from;
  const double length = span.norm();
  Box box = {.center = 0.5 * (from + to), .half_length = 0.5 * length, .radius = radius};
  if (length > 0) {
    box.axis = span / length;
  }
  return box;
}

}  // namespace

struct Canvas::Impl {
  Impl(int w, int h, const ImageSize& image, double s)
      : width(w),
        height(h),
        scale(s),
        frame{0, 0, image.width, image.height},
        atlas(s),
        surface(frame.right, frame.bottom, atlas.side()),
        batch(frame.right, frame.bottom) {}

  int width;
  int height;
  double scale;     // px of the image to one of the canvas
  PixelRect frame;  // the image
  GlyphAtlas atlas;
  Surface surface;
  Batch batch;
  List<PixelRect> clips = {};
  List<TextBox> boxes = {};
  SvgDrawing* drawing = nullptr;  // that takes every shape, too
  Color background = {1, 1, 1, 1};
  bool begun = false;  // whether the frame's background has been drawn

  void flush() {
    if (!begun) {
      surface.clear(background);
      begun = true;
    }
    surface.draw(batch, atlas);
    batch.clear();
  }
  void flush_if_full() {
    if (batch.vertices().size() > enough) {
      flush();
    }
  }
  void use_clip() { batch.set_clip(clips.empty() ? frame : clips.back()); }

  const Glyph& glyph(const GlyphKey& key) {
    const Glyph* found = atlas.find(key);
    if (found == nullptr) {
      flush();
      atlas.clear();
      found = atlas.find(key);
    }
    static constexpr Glyph nothing = {};
    return found == nullptr ? nothing : *found;
  }

  /// Draws one layer of a line, glyphs or halos, and returns the rectangle that its bitmaps cover: all in px
  /// of the image.
  Rect write(const GlyphLine& line, const Point& start, int rim, const Color& color) {
    Rect covered = {start.x(), start.y(), line.width, 0};
    bool first = true;
    for (const PlacedGlyph& placed : line.glyphs) {
      const double quarters = std::floor(4 * (start.x() + placed.x) + 0.5);
      const int pixel_x = static_cast<int>(std::floor(quarters / 4));
      const int pixel_y = static_cast<int>(std::lround(start.y() + placed.drop));
      const int phase = static_cast<int>(quarters) - 4 * pixel_x;
      const Glyph& bitmap = glyph({placed.name, placed.size, phase, rim});
      if (bitmap.width == 0) {
        continue;
      }
      const int left = pixel_x + bitmap.left;
      const int top = pixel_y + bitmap.top;
      add_glyph(batch, {left, top, left + bitmap.width, top + bitmap.height}, bitmap.texel_x, bitmap.texel_y,
                color);
      const Rect box = {double(left), double(top), double(bitmap.width), double(bitmap.height)};
      covered = united(first ? Rect{covered.x, box.y, covered.width, 0} : covered, box);
      first = false;
    }
    return covered;
  }
};

Canvas::Canvas(int width, int height, double scale) {
  check_size(width, height, scale);
  const ImageSize image = {image_pixels(width, scale), image_pixels(height, scale)};
  impl_ = std::make_unique<Impl>(width, height, image, scale);
}

Canvas::Canvas(const ImageSize& image, double scale) {
  check_size(image.width, image.height, scale);
  impl_ = std::make_unique<Impl>(whole_pixels(image.width, scale), whole_pixels(image.height, scale), image,
                                 scale);
}

Canvas::~Canvas() = default;

int Canvas::width() const { return impl_->width; }
int Canvas::height() const { return impl_->height; }
double Canvas::scale() const { return impl_->scale; }

void Canvas::clear(Color background) {
  impl_->background = background;
  impl_->begun = false;
  impl_->batch.clear();
  impl_->clips.clear();
  impl_->boxes.clear();
  impl_->use_clip();
  if (impl_->drawing != nullptr) impl_->drawing->clear();
}

void Canvas::line(const Point& from, const Point& to, const Stroke& stroke) {
  polyline(FixedList<Point, 2>{from, to}, stroke);
}

void Canvas::record(SvgDrawing* drawing) { impl_->drawing = drawing; }

void Canvas::polyline(Span<const Point> points, const Stroke& stroke) {
  if (impl_->drawing != nullptr) impl_->drawing->polyline(points, stroke);
  const double scale = impl_->scale;
  add_polyline(impl_->batch, scaled(points, scale), scaled(stroke, scale));
  impl_->flush_if_full();
}

void Canvas::circle(const Point& center, double radius, const Paint& paint) {
  capsule(center, center, radius, paint);
}

void Canvas::polygon(Span<const Point> points, const Paint& paint, double rounding) {
  if (impl_->drawing != nullptr) impl_->drawing->polygon(points, paint, rounding);
  const double scale = impl_->scale;
  add_polygon(impl_->batch, scaled(points, scale), scaled(paint, scale), scale * rounding);
  impl_->flush_if_full();
}

void Canvas::rect(const Rect& rect, const Paint& paint, double corner_radius) {
  const double radius = std::min(corner_radius, 0.5 * std::min(rect.width, rect.height));
  const Point center(rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height);
  const Point half(0.5 * rect.width, 0.5 * rect.height);
  if (radius > 0) {
    const double scale = impl_->scale;
    if (impl_->drawing != nullptr) impl_->drawing->rect(rect, paint, radius);
    add_box(impl_->batch,
            {.center = scale * center,
             .half_length = scale * (half.x() - radius),
             .half_width = scale * (half.y() - radius),
             .radius = scale * radius},
            scaled(paint, scale));
    impl_->flush_if_full();
  } else if (rect.width > 0 && rect.height > 0) {
    polygon(FixedList<Point, 4>{center - half, center + Point(half.x(), -half.y()), center + half,
                                center + Point(-half.x(), half.y())},
            paint);
  }
}

void Canvas::capsule(const Point& from, const Point& to, double radius, const Paint& paint) {
  if (impl_->drawing != nullptr) impl_->drawing->capsule(from, to, radius, paint);
  const double scale = impl_->scale;
  add_box(impl_->batch, capsule_box(scale * from, scale * to, scale * radius), scaled(paint, scale));
  impl_->flush_if_full();
}

void Canvas::hatch(Span<const Point> points, const Stroke& stroke, double pitch) {
  if (impl_->drawing != nullptr) impl_->drawing->hatch(points, stroke, pitch);
  const double scale = impl_->scale;
  add_hatch(impl_->batch, scaled(points, scale), scaled(stroke, scale), scale * pitch);
  impl_->flush_if_full();
}

void Canvas::text(const Point& at, std::string_view markup, const TextStyle& style) {
  if (!usable(at) || !drawable(style)) {
    return;
  }
  const double scale = impl_->scale;
  const GlyphLine line = lay_out(markup, scale * style.size, face_of(style));
  Point start = scale * at;
  if (style.align != Align::left) {
    start.x() -= style.align == Align::center ? 0.5 * line.width : line.width;
  }
  const int rim = halo_reach(style, scale);
  if (impl_->drawing != nullptr)
    impl_->drawing->text(start / scale, lay_out(markup, style.size, face_of(style)), rim / scale,
                         style);
  if (rim > 0) impl_->write(line, start, rim, style.halo);
  const Rect covered = scaled(impl_->write(line, start, 0, style.color), 1 / scale);
  impl_->boxes.push_back({.text = std::string(markup), .rect = covered, .style = style});
  impl_->flush_if_full();
}

double Canvas::text_width(std::string_view markup, const TextStyle& style) const {
  return drawable(style) ? lay_out(markup, style.size, face_of(style)).width : 0;
}

void Canvas::push_clip(const Rect& rect) {
  const PixelRect& frame = impl_->frame;
  const PixelRect pushed = pixels_of(scaled(rect, impl_->scale), frame.right, frame.bottom);
  impl_->clips.push_back(intersection(impl_->clips.empty() ? frame : impl_->clips.back(), pushed));
  impl_->use_clip();
  if (impl_->drawing != nullptr) impl_->drawing->push_clip(rect);
}

void Canvas::pop_clip() {
  if (impl_->clips.empty()) {
    throw std::logic_error("Canvas::pop_clip: there is no clip to take back");
  }
  impl_->clips.pop_back();
  impl_->use_clip();
  if (impl_->drawing != nullptr) impl_->drawing->pop_clip();
}

Span<const TextBox> Canvas::text_boxes() const { return impl_->boxes; }

Image Canvas::read() {
  impl_->flush();
  return impl_->surface.read();
}

void Canvas::show() {
  impl_->flush();
  impl_->surface.show();
}

std::string Canvas::backend() const { return impl_->surface.backend(); }

}  // namespace cairn::render
