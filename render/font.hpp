// Glyphs of the four fonts inside the program, drawn once each at their exact size in pixels.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include <cairn/math/list.hpp>

namespace cairn::render {

enum class Face { regular, bold, mono, mono_bold };

/// A drawable sign: fonts differ in what they hold, so a glyph names the face it was found in.
struct GlyphName {
  Face face = Face::regular;
  int index = 0;  // 0: the box that stands for a missing sign
  bool slanted = false;
};

/// The glyph of a code point in the face, else in the regular face, else the missing sign of the face.
GlyphName find_glyph(Face face, char32_t code_point);

/// How far the pen moves [px] at an em of `size` px.
double advance(const GlyphName& glyph, double size);
/// Its outline as the path of an SVG file, in units of the font, y up; "" for a sign without ink.
std::string glyph_outline(const GlyphName& glyph);
/// The length of one unit of the font at an em of `size` px [px].
double units_to_pixels(const GlyphName& glyph, double size);

/// What one bitmap is of.
struct GlyphKey {
  GlyphName name = {};
  double size = 0;  // [px]
  int phase = 0;    // quarters of a pixel to the right
  int rim = 0;      // [px], zero: the glyph itself; else the halo of that reach
};

/// A bitmap in the atlas, and where its top left corner lies from the pen's pixel.
struct Glyph {
  int texel_x = 0, texel_y = 0;
  int width = 0, height = 0;  // zero: nothing to draw
  int left = 0, top = 0;
};

/// Bitmaps side by side in one 8-bit square, made when first asked for.
class GlyphAtlas {
 public:
  /// For pictures of so many pixels to one of theirs: large enough for the glyphs of a frame.
  explicit GlyphAtlas(double scale);

  /// Null when the atlas is full: draw what is pending, call clear() and ask again.
  const Glyph* find(const GlyphKey& key);
  void clear();

  /// [px]
  int side() const { return side_; }
  const List<std::uint8_t>& texels() const { return texels_; }
  /// Counts the changes of the texels.
  int version() const { return version_; }

 private:
  bool place(Glyph& glyph);

  int side_;
  List<std::uint8_t> texels_;
  std::unordered_map<std::uint64_t, Glyph> glyphs_ = {};
  int shelf_x_ = 0;  // the next free texel of the lowest shelf
  int shelf_y_ = 0;
  int shelf_height_ = 0;
  int version_ = 0;
};

}  // namespace cairn::render
