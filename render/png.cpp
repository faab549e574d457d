// PNG bytes from pixels and back. The one place that holds stb_image and stb_image_write.
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include "render/image.hpp"

namespace {

// Measured on diagrams of 1280x720, without row filters: levels 1-3 take 7-12 ms and give up to a fifth more
// bytes, level 4 takes 12-17 ms, level 6 up to half as long again for 3-8 % fewer bytes.
constexpr int compression_level = 4;

/// zlib in place of stb's own compressor: half the time, smaller. The caller frees the result with std::free.
unsigned char* zlib_compress(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
  uLongf length = compressBound(static_cast<uLong>(size));
  void* buffer = std::malloc(length);
  if (buffer == nullptr) return nullptr;
  unsigned char* bytes = static_cast<unsigned char*>(buffer);
  if (compress2(bytes, &length, data, static_cast<uLong>(size), compression_level) != Z_OK) {
    std::free(buffer);
    return nullptr;
  }
  *compressed_size = static_cast<int>(length);
  return bytes;
}

unsigned zlib_crc(const unsigned char* data, int size) {
  return static_cast<unsigned>(crc32(0, data, static_cast<uInt>(size)));
}

}  // namespace

#define STBIW_ZLIB_COMPRESS zlib_compress
#define STBIW_CRC32 zlib_crc
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

namespace cairn::render {
namespace {

struct Release {
  void operator()(void* memory) const { std::free(memory); }
};
using StbBytes = std::unique_ptr<unsigned char, Release>;

/// stb's knob is a global: it is turned once, before the first picture, and never again.
void use_no_row_filter() {
  // Flat colours compress as well unfiltered; trying all five filters costs 25 ms a frame.
  [[maybe_unused]] static const int filter = stbi_write_force_png_filter = 0;
}

List<std::uint8_t> encoded(const List<std::uint8_t>& pixels, int width, int height, int channels) {
  use_no_row_filter();
  int size = 0;
  const StbBytes bytes(
      stbi_write_png_to_mem(pixels.data(), width * channels, width, height, channels, &size));
  if (!bytes) throw std::bad_alloc();  // the only way in which stb and zlib can fail here
  return {bytes.get(), bytes.get() + size};
}

}  // namespace

void require_image(const Image& image, std::string_view place) {
  require(image.width > 0, place, "width", "positive px", image.width);
  require(image.height > 0, place, "height", "positive px", image.height);
  // stb counts in int, compression may grow what it cannot shrink, and every row has one byte more than
  // pixels.
  const double bytes = (3.0 * image.width + 1) * image.height;
  require(bytes < std::numeric_limits<int>::max() / 2, place, "size", "less than 1 GiB", bytes);
  const int wanted = image.width * image.height * 3;
  require(image.pixels.size() == wanted, place, "pixels", "width * height * 3 bytes", image.pixels.size());
}

List<std::uint8_t> encode_png(const Image& image) {
  require_image(image, "encode_png");
  return encoded(image.pixels, image.width, image.height, 3);
}

List<std::uint8_t> encode_transparent_png(const Image& on_black, const Image& on_white) {
  require_image(on_black, "encode_transparent_png");
  require_image(on_white, "encode_transparent_png");
  require(on_white.width == on_black.width && on_white.height == on_black.height, "encode_transparent_png",
          "size", "the same of both pictures", on_white.width);
  List<std::uint8_t> pixels;
  for (int i = 0; i < on_black.pixels.size(); i += 3) {
    // White shines through as much as all that covers it lets pass: what covers is opaque in the channel in
    // which the two pictures differ least.
    int passes = 255;
    for (int k = 0; k < 3; ++k) passes = std::min(passes, on_white.pixels[i + k] - on_black.pixels[i + k]);
    const int alpha = 255 - std::max(0, passes);
    for (int k = 0; k < 3; ++k) {
      const int color = alpha == 0 ? 0 : std::min(255, (255 * on_black.pixels[i + k] + alpha / 2) / alpha);
      pixels.push_back(static_cast<std::uint8_t>(color));
    }
    pixels.push_back(static_cast<std::uint8_t>(alpha));
  }
  return encoded(pixels, on_black.width, on_black.height, 4);
}

Image decode_png(Span<const std::uint8_t> bytes) {
  if (bytes.end() - bytes.begin() > std::numeric_limits<int>::max()) {
    throw std::runtime_error("larger than 2 GiB");
  }
  Image image;
  int channels = 0;
  const StbBytes pixels(
      stbi_load_from_memory(bytes.data(), bytes.size(), &image.width, &image.height, &channels, 3));
  if (!pixels) throw std::runtime_error(std::string("not a whole PNG (") + stbi_failure_reason() + ")");
  const int size = image.width * image.height * 3;
  image.pixels.assign(pixels.get(), pixels.get() + size);
  return image;
}

}  // namespace cairn::render
