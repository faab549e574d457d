// Reads marked-up text and places its glyphs on a line.
#pragma once

#include <string_view>

#include <cairn/math/list.hpp>
#include "render/font.hpp"

namespace cairn::render {

struct PlacedGlyph {
  GlyphName name = {};
  double size = 0;             // the em [px]
  double x = 0;                // of the pen, from the start of the line [px]
  double drop = 0;             // of the base line, downwards [px]
  std::string_view sign = {};  // the UTF-8 that it was set from, within the markup
};

struct GlyphLine {
  List<PlacedGlyph> glyphs = {};
  double width = 0;  // [px]
};

/// Subscripts and superscripts are set at 78 %; one of each at the same place stand above each other.
/// Variables are slanted (render/variables.hpp).
GlyphLine lay_out(std::string_view markup, double size, Face face);

/// Takes the first code point off a UTF-8 text; U+FFFD for one byte that is not UTF-8. The text must not be
/// empty.
char32_t take_code_point(std::string_view& text);

}  // namespace cairn::render
