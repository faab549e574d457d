// Glyph bitmaps by stb_truetype: exact area coverage, no hinting, four horizontal phases.
#include "render/font.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_truetype.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "render/canvas.hpp"

extern "C" {
extern const unsigned char cairn_font_regular[];
extern const unsigned char cairn_font_bold[];
extern const unsigned char cairn_font_mono[];
extern const unsigned char cairn_font_mono_bold[];
}

namespace cairn::render {
namespace {

constexpr int phases = 4;
constexpr int side_at_one = 1024;   // [px] of the atlas at scale 1
constexpr double slant = 0.2;       // how far a slanted sign leans to the right, for each unit of height
constexpr double slant_axis = 540;  // [units of the font] what is so high stays where it is

using Fonts = FixedList<stbtt_fontinfo, 4>;

Fonts open_fonts() {
  const FixedList<const unsigned char*, 4> files = {cairn_font_regular, cairn_font_bold, cairn_font_mono,
                                                    cairn_font_mono_bold};
  Fonts fonts = {};
  for (int i = 0; i < files.size(); ++i) {
    if (stbtt_InitFont(&fonts[i], files[i], 0) == 0) {
      throw RenderError("a font inside the program is damaged: build Cairn again");
    }
  }
  return fonts;
}

const stbtt_fontinfo& font_of(Face face) {
  static const Fonts fonts = open_fonts();
  return fonts[static_cast<int>(face)];
}

float scale_of(const stbtt_fontinfo& font, double size) {
  return stbtt_ScaleForMappingEmToPixels(&font, static_cast<float>(size));
}

std::uint64_t packed(const GlyphKey& key) {
  const std::uint64_t size = static_cast<std::uint64_t>(std::lround(64 * key.size));
  const std::uint64_t face = static_cast<std::uint64_t>(key.name.face);
  const std::uint64_t index = static_cast<std::uint64_t>(key.name.index) | std::uint64_t{key.name.slanted}
                                                                               << 19U;
  const std::uint64_t phase = static_cast<std::uint64_t>(key.phase);
  return (((size * 64 + static_cast<std::uint64_t>(key.rim)) * phases + phase) * 4 + face) << 20U | index;
}

short leaning(short x, short y) { return static_cast<short>(x + std::lround(slant * (y - slant_axis))); }

/// The outline of a sign, in units of its font.
struct GlyphShape {
  explicit GlyphShape(const GlyphName& glyph) {
    stbtt_vertex* found = nullptr;
    count = stbtt_GetGlyphShape(&font_of(glyph.face), glyph.index, &found);
    vertices.reset(found);
    for (int i = 0; glyph.slanted && i < count; ++i) {
      stbtt_vertex& vertex = found[i];
      vertex.x = leaning(vertex.x, vertex.y);
      vertex.cx = leaning(vertex.cx, vertex.cy);
      const short bend = vertex.type == STBTT_vcurve ? vertex.cx : vertex.x;
      least_x = std::min({least_x, vertex.x, bend});
      most_x = std::max({most_x, vertex.x, bend});
    }
  }

  int count = 0;
  short least_x = 32767, most_x = -32767;  // of a slanted sign
  std::unique_ptr<stbtt_vertex, decltype(&std::free)> vertices = {nullptr, &std::free};
};

/// A bitmap on its way into the atlas.
struct Bitmap {
  Glyph place = {};
  List<std::uint8_t> texels = {};
};

Bitmap draw_glyph(const GlyphKey& key) {
  const stbtt_fontinfo& font = font_of(key.name.face);
  const float scale = scale_of(font, key.size);
  const float shift = static_cast<float>(key.phase) / phases;
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  stbtt_GetGlyphBitmapBoxSubpixel(&font, key.name.index, scale, scale, shift, 0, &left, &top, &right,
                                  &bottom);
  const GlyphShape shape(key.name);
  if (key.name.slanted) {
    left = static_cast<int>(std::floor(scale * shape.least_x + shift));
    right = static_cast<int>(std::ceil(scale * shape.most_x + shift));
  }
  Bitmap bitmap;
  bitmap.place = {.width = right - left, .height = bottom - top, .left = left, .top = top};
  if (bitmap.place.width <= 0 || bitmap.place.height <= 0) {
    bitmap.place = {};
    return bitmap;
  }
  bitmap.texels.resize(bitmap.place.width * bitmap.place.height);
  stbtt__bitmap target = {.w = bitmap.place.width,
                          .h = bitmap.place.height,
                          .stride = bitmap.place.width,
                          .pixels = bitmap.texels.data()};
  stbtt_Rasterize(&target, 0.35F, shape.vertices.get(), shape.count, scale, scale, shift, 0, left, top, 1,
                  nullptr);
  return bitmap;
}

/// How much of the halo is left at a distance from the glyph: whole near it, fading over the last pixels.
double rim_strength(double distance, int reach) {
  return std::clamp(0.7 * (reach + 0.5 - distance), 0.0, 1.0);
}

/// Every texel of the glyph spreads to its neighbours; the strongest wins.
Bitmap draw_halo(const Bitmap& glyph, int reach) {
  Bitmap halo;
  if (glyph.place.width == 0) {
    return halo;
  }
  halo.place = {.width = glyph.place.width + 2 * reach,
                .height = glyph.place.height + 2 * reach,
                .left = glyph.place.left - reach,
                .top = glyph.place.top - reach};
  halo.texels.resize(halo.place.width * halo.place.height);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double strength = rim_strength(std::hypot(dx, dy), reach);
      for (int y = 0; strength > 0 && y < glyph.place.height; ++y) {
        for (int x = 0; x < glyph.place.width; ++x) {
          const double spread = strength * glyph.texels[y * glyph.place.width + x];
          const int at = (y + dy + reach) * halo.place.width + x + dx + reach;
          std::uint8_t& texel = halo.texels[at];
          texel = std::max(texel, static_cast<std::uint8_t>(std::lround(spread)));
        }
      }
    }
  }
  return halo;
}

}  // namespace

GlyphName find_glyph(Face face, char32_t code_point) {
  const int code = static_cast<int>(code_point);
  const int own = stbtt_FindGlyphIndex(&font_of(face), code);
  if (own != 0 || face == Face::regular) {
    return {face, own};
  }
  const int other = stbtt_FindGlyphIndex(&font_of(Face::regular), code);
  return other != 0 ? GlyphName{Face::regular, other} : GlyphName{face, 0};
}

double advance(const GlyphName& glyph, double size) {
  const stbtt_fontinfo& font = font_of(glyph.face);
  int units = 0;
  int bearing = 0;
  stbtt_GetGlyphHMetrics(&font, glyph.index, &units, &bearing);
  return units * static_cast<double>(scale_of(font, 1)) * size;
}

double units_to_pixels(const GlyphName& glyph, double size) {
  return static_cast<double>(scale_of(font_of(glyph.face), 1)) * size;
}

std::string glyph_outline(const GlyphName& glyph) {
  const GlyphShape shape(glyph);
  std::string path;
  for (int i = 0; i < shape.count; ++i) {
    const stbtt_vertex& vertex = shape.vertices.get()[i];
    if (vertex.type == STBTT_vmove) path += fmt::format("{}M{} {}", i > 0 ? "Z" : "", vertex.x, vertex.y);
    if (vertex.type == STBTT_vline) path += fmt::format("L{} {}", vertex.x, vertex.y);
    if (vertex.type == STBTT_vcurve)
      path += fmt::format("Q{} {} {} {}", vertex.cx, vertex.cy, vertex.x, vertex.y);
  }
  return path.empty() ? path : path + "Z";
}

GlyphAtlas::GlyphAtlas(double scale)
    : side_(side_at_one * std::max(1, static_cast<int>(std::ceil(scale)))), texels_(side_ * side_) {}

void GlyphAtlas::clear() {
  glyphs_.clear();
  shelf_x_ = 0;
  shelf_y_ = 0;
  shelf_height_ = 0;
}

bool GlyphAtlas::place(Glyph& glyph) {
  if (shelf_x_ + glyph.width > side_) {
    shelf_y_ += shelf_height_;
    shelf_x_ = 0;
    shelf_height_ = 0;
  }
  if (glyph.width > side_ || shelf_y_ + glyph.height > side_) {
    return false;
  }
  glyph.texel_x = shelf_x_;
  glyph.texel_y = shelf_y_;
  shelf_x_ += glyph.width;
  shelf_height_ = std::max(shelf_height_, glyph.height);
  return true;
}

const Glyph* GlyphAtlas::find(const GlyphKey& key) {
  const std::uint64_t name = packed(key);
  const auto known = glyphs_.find(name);
  if (known != glyphs_.end()) {
    return &known->second;
  }
  Bitmap bitmap = draw_glyph(key);
  if (key.rim > 0) {
    bitmap = draw_halo(bitmap, key.rim);
  }
  Glyph glyph = bitmap.place;
  if (glyph.width > 0) {
    if (!place(glyph)) {
      return nullptr;
    }
    for (int y = 0; y < glyph.height; ++y) {
      const int target = (glyph.texel_y + y) * side_ + glyph.texel_x;
      std::copy_n(bitmap.texels.begin() + y * glyph.width, glyph.width, texels_.begin() + target);
    }
    ++version_;
  }
  return &glyphs_.emplace(name, glyph).first->second;
}

}  // namespace cairn::render
