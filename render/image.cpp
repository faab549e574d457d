// Whole files or none, and the comparison of two pictures pixel by pixel.
#include "render/image.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <system_error>

namespace cairn::render {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_write(const fs::path& path, const std::string& why) {
  throw WriteError("cannot write " + path.string() + ": " + why);
}

/// Removes the part on every way out; once it is renamed there is none.
struct PartGuard {
  fs::path path = {};
  ~PartGuard() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Writes to `destination`; errors speak of `path`, the name the caller knows.
void write_bytes(const fs::path& destination, const fs::path& path, Span<const std::uint8_t> bytes) {
  File file(std::fopen(destination.c_str(), "wb"));
  if (!file) fail_write(path, reason(errno));
  // An empty span may have no address, and fwrite must have one.
  const auto size = static_cast<std::size_t>(bytes.size());
  const std::size_t written = bytes.empty() ? 0 : std::fwrite(bytes.data(), 1, size, file.get());
  if (written != size) fail_write(path, reason(errno));
  // A full disk often shows only when the buffer is flushed.
  if (std::fclose(file.release()) != 0) fail_write(path, reason(errno));
}

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

void write_file(const fs::path& path, Span<const std::uint8_t> bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_bytes(path, path, bytes);  // renaming onto a device would replace the device itself
    return;
  }
  fs::path part = path;
  part += ".part";
  const PartGuard guard{part};
  write_bytes(part, path, bytes);
  fs::rename(part, path, error);
  if (error) fail_write(path, error.message());
}

void write_file(const fs::path& path, std::string_view text) {
  const List<std::uint8_t> bytes(text.begin(), text.end());
  write_file(path, Span<const std::uint8_t>(bytes));
}

void write_png(const fs::path& path, const Image& image) { write_file(path, encode_png(image)); }

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
