// Chooses colours by how many pixels would look wrong without them, and how wrong.
#include "render/palette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn::render {
namespace {

/// The square of the distance of two colours [levels].
int square_distance(std::uint32_t a, std::uint32_t b) {
  int sum = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const int difference = static_cast<int>(a >> shift & 0xFFU) - static_cast<int>(b >> shift & 0xFFU);
    sum += difference * difference;
  }
  return sum;
}

struct Counted {
  std::uint32_t color = 0;
  long long pixels = 0;
  int distance = std::numeric_limits<int>::max();  // its square, to the nearest that is chosen

  /// What is wrong without it. The root keeps rare colours from being given up for shades of frequent ones.
  double weight() const { return distance * std::sqrt(static_cast<double>(pixels)); }
};

}  // namespace

void ColorCount::add(const Image& image) {
  const int end = image.pixels.size();
  for (int begin = 0; begin < end;) {
    const std::uint32_t color = color_at(&image.pixels[begin]);
    int i = begin;
    while (i < end && color_at(&image.pixels[i]) == color) i += 3;  // most pixels are as the one before
    pixels_[color] += (i - begin) / 3;
    begin = i;
  }
}

List<std::uint32_t> ColorCount::palette(int most) const {
  List<Counted> counted;
  for (const auto& [color, pixels] : pixels_) counted.push_back({.color = color, .pixels = pixels});
  std::sort(counted.begin(), counted.end(), [](const Counted& a, const Counted& b) {
    return a.pixels != b.pixels ? a.pixels > b.pixels : a.color < b.color;
  });
  List<std::uint32_t> chosen;
  while (chosen.size() < std::min(most, counted.size())) {
    const auto next =
        std::max_element(counted.begin(), counted.end(),
                         [](const Counted& a, const Counted& b) { return a.weight() < b.weight(); });
    chosen.push_back(next->color);
    for (Counted& other : counted)
      other.distance = std::min(other.distance, square_distance(other.color, chosen.back()));
  }
  return chosen;
}

std::uint8_t Palette::nearest(std::uint32_t color) {
  const auto [entry, is_new] = known_.try_emplace(color);
  if (is_new) {
    const auto found =
        std::min_element(colors_.begin(), colors_.end(), [color](std::uint32_t a, std::uint32_t b) {
          return square_distance(a, color) < square_distance(b, color);
        });
    entry->second = static_cast<std::uint8_t>(found - colors_.begin());
  }
  return entry->second;
}

}  // namespace cairn::render
