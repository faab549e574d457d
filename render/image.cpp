// Pictures to and from disk, and the comparison of two pictures pixel by pixel.
#include "render/image.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <system_error>

#include <cairn/math/check.hpp>

namespace cairn::render {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// The three channels of a pixel; nothing outside the image.
const std::uint8_t* pixel_at(const Image& image, int x, int y) {
  if (x >= image.width || y >= image.height) return nullptr;
  return &image.pixels[3 * (y * image.width + x)];
}

int largest_difference(const std::uint8_t* a, const std::uint8_t* b) {
  if (a == nullptr || b == nullptr) return 255;
  int largest = 0;
  for (int channel = 0; channel < 3; ++channel) {
    largest = std::max(largest, std::abs(a[channel] - b[channel]));
  }
  return largest;
}

/// Grey between 60 % and white: dark enough to recognise the scene, pale enough for red to stand out.
std::uint8_t faded_grey(const std::uint8_t* pixel) {
  const int grey = (299 * pixel[0] + 587 * pixel[1] + 114 * pixel[2]) / 1000;
  return static_cast<std::uint8_t>(155 + grey * 100 / 255);
}

}  // namespace

void write_png(const fs::path& path, const Image& image) {
  WholeFile file(path);
  file.write(encode_png(image));
  file.finish();
}

Image read_png(const fs::path& path) {
  const std::string failed = "cannot read " + path.string() + ": ";
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw std::runtime_error(failed + reason(errno));
  List<std::uint8_t> bytes;
  FixedList<std::uint8_t, 65536> block = {};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + count);
  }
  if (std::ferror(file.get()) != 0) throw std::runtime_error(failed + reason(errno));
  try {
    return decode_png(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(failed + error.what());
  }
}

Image part_of(const Image& image, int left, int top, int width, int height) {
  require_image(image, "part_of");
  require(left >= 0 && width > 0 && left + width <= image.width, "part_of", "width", "inside the picture",
          width);
  require(top >= 0 && height > 0 && top + height <= image.height, "part_of", "height", "inside the picture",
          height);
  Image part = {.width = width, .height = height};
  for (int y = top; y < top + height; ++y) {
    const auto row = image.pixels.begin() + 3 * (y * image.width + left);
    part.pixels.insert(part.pixels.end(), row, row + 3 * width);
  }
  return part;
}

ImageDifference compare(const Image& expected, const Image& actual) {
  const auto pixels = [](const Image& image) { return static_cast<long long>(image.width) * image.height; };
  if (expected.width != actual.width || expected.height != actual.height) {
    return {.same_size = false, .largest = 255, .differing = std::max(pixels(expected), pixels(actual))};
  }
  ImageDifference difference = {.same_size = true};
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      const int largest = largest_difference(pixel_at(expected, x, y), pixel_at(actual, x, y));
      difference.largest = std::max(difference.largest, largest);
      if (largest > 0) ++difference.differing;
    }
  }
  return difference;
}

Image difference_image(const Image& expected, const Image& actual, int tolerance) {
  Image image{.width = std::max(expected.width, actual.width),
              .height = std::max(expected.height, actual.height)};
  image.pixels.reserve(std::ptrdiff_t{3} * image.width * image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* const pixel = pixel_at(actual, x, y);
      const bool differs = largest_difference(pixel_at(expected, x, y), pixel) > tolerance;
      const std::uint8_t grey = pixel == nullptr || differs ? std::uint8_t{0} : faded_grey(pixel);
      image.pixels.push_back(differs ? std::uint8_t{220} : grey);
      image.pixels.push_back(grey);
      image.pixels.push_back(grey);
    }
  }
  return image;
}

}  // namespace cairn::render
