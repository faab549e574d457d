// The few colours that stand for all colours of a film.
#pragma once

#include <cstdint>
#include <unordered_map>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"

namespace cairn::render {

/// Counts the colours of pictures, 0xRRGGBB each.
class ColorCount {
 public:
  void add(const Image& image);
  /// All colours where they are at most `most`; else so many of them that each of the others has one near it,
  /// the nearer the more pixels have it. The most frequent comes first.
  List<std::uint32_t> palette(int most) const;

 private:
  std::unordered_map<std::uint32_t, long long> pixels_ = {};
};

/// Finds the nearest of at most 256 colours, and remembers it.
class Palette {
 public:
  explicit Palette(List<std::uint32_t> colors) : colors_(std::move(colors)) {}

  const List<std::uint32_t>& colors() const { return colors_; }
  /// Its place among the colours.
  std::uint8_t nearest(std::uint32_t color);

 private:
  List<std::uint32_t> colors_;
  std::unordered_map<std::uint32_t, std::uint8_t> known_ = {};
};

/// The colour of a pixel, which lies there in three bytes.
inline std::uint32_t color_at(const std::uint8_t* pixel) {
  return std::uint32_t{pixel[0]} << 16 | std::uint32_t{pixel[1]} << 8 | pixel[2];
}

}  // namespace cairn::render
