// A frame in vectors: what a canvas draws, as SVG.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"
#include "render/markup.hpp"

namespace cairn::render {

/// What becomes of letters: outlines look the same wherever the file is opened; text can be searched and
/// edited, in the fonts of whoever opens it, stretched to the width that it has here.
enum class Letters { outlines, text };

/// Takes the shapes that a Canvas draws (Canvas::record) and writes them as SVG 1.1. Coordinates are pixels
/// of the canvas; what is not usable() is left out.
class SvgDrawing {
 public:
  explicit SvgDrawing(Letters letters = Letters::outlines) : letters_(letters) {}

  /// Forgets everything drawn.
  void clear();
  void polyline(Span<const Point> points, const Stroke& stroke);
  void polygon(Span<const Point> points, const Paint& paint, double rounding);
  void capsule(const Point& from, const Point& to, double radius, const Paint& paint);
  void rect(const Rect& rect, const Paint& paint, double corner_radius);
  void hatch(Span<const Point> points, const Stroke& stroke, double pitch);
  /// `start`: the pen at the left end of the base line; `rim`: how far the halo reaches [px].
  void text(const Point& start, const GlyphLine& line, double rim, const TextStyle& style);
  void push_clip(const Rect& rect);
  void pop_clip();

  /// The whole file: the part of the frame inside `view`, on a background that may be transparent. `alt` says
  /// what the picture shows.
  std::string file(const Rect& view, Color background, std::string_view alt) const;

 private:
  /// The name of a glyph's outline in the file.
  std::string outline_of(const GlyphName& name);
  /// One layer of a line, glyphs or halos: `look` has its attributes.
  void write(const Point& start, const GlyphLine& line, const std::string& look, double rim);
  /// The line as one element of text, over its halo.
  void write_text(const Point& start, const GlyphLine& line, double rim, const TextStyle& style);

  Letters letters_;
  std::string definitions_ = {};
  std::string shapes_ = {};
  std::map<std::tuple<Face, int, bool>, std::string> outlines_ = {};  // name by glyph
  int clips_ = 0;                                                     // made so far
  int open_ = 0;                                                      // not yet taken back
};

}  // namespace cairn::render
