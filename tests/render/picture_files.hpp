// Folders, pictures and a small reader of PNG chunks, for tests of what is written to disk. The reader shares
// no code with the renderer: zlib only.
#pragma once

#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../geometry/random_shapes.hpp"
#include "render/image.hpp"
#include "testing.hpp"

namespace cairn::test {

/// An empty folder of its own, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cairn_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_ = {};
};

/// Up to 16 MiB: a device that should not be there may have no end.
inline std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text;
  for (char c = 0; text.size() < (1u << 24) && stream.get(c);) text += c;
  return text;
}

inline std::string as_text(const List<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

inline render::Image flat_picture(int width, int height, std::uint8_t grey) {
  const int size = 3 * width * height;
  return {.width = width, .height = height, .pixels = List<std::uint8_t>(size, grey)};
}

inline render::Image random_picture(int width, int height, std::uint64_t seed) {
  render::Image image = flat_picture(width, height, 0);
  Random random(seed);
  for (std::uint8_t& channel : image.pixels) channel = static_cast<std::uint8_t>(random.below(256));
  return image;
}

/// One channel (0 red, 1 green, 2 blue) of one pixel.
inline std::uint8_t& channel_at(render::Image& image, int x, int y, int channel) {
  return image.pixels[3 * (y * image.width + x) + channel];
}

struct PngChunk {
  std::string name = {};
  std::string data = {};
  std::uint32_t checksum = 0;  // as written in the file
};

/// Big-endian, `count` bytes.
inline std::uint32_t number_at(const std::string& bytes, std::size_t offset, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value = value << 8 | static_cast<std::uint8_t>(bytes.at(offset + i));
  return value;
}

inline List<PngChunk> png_chunks(const std::string& file) {
  if (file.substr(0, 8) != "\x89PNG\r\n\x1a\n") throw std::runtime_error("no PNG signature");
  List<PngChunk> chunks;
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t length = number_at(file, at, 4);
    chunks.push_back({.name = file.substr(at + 4, 4),
                      .data = file.substr(at + 8, length),
                      .checksum = number_at(file, at + 8 + length, 4)});
    at += 12 + length;
  }
  return chunks;
}

/// What the checksum of a chunk must be.
inline std::uint32_t checksum_of(const PngChunk& chunk) {
  const std::string covered = chunk.name + chunk.data;
  const auto* const bytes = reinterpret_cast<const Bytef*>(covered.data());
  return static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(covered.size())));
}

/// The inverse of zlib's compression, of so many bytes.
inline std::string inflated_bytes(const std::string& compressed, int count) {
  std::string bytes(static_cast<std::size_t>(count), '\0');
  uLongf length = bytes.size();
  const int code =
      uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(compressed.data()), static_cast<uLong>(compressed.size()));
  if (code != Z_OK || length != bytes.size()) throw std::runtime_error("pixels do not inflate");
  return bytes;
}

/// Unfiltered rows of RGB, compressed.
inline render::Image inflated(int width, int height, const std::string& compressed) {
  const int row = 1 + 3 * width;
  const std::string text = inflated_bytes(compressed, row * height);
  const List<std::uint8_t> rows(text.begin(), text.end());
  render::Image image{.width = width, .height = height};
  for (int at = 0; at < rows.size(); at += row) {
    if (rows[at] != 0) throw std::runtime_error("a row is filtered");
    const auto begin = rows.begin() + at;
    image.pixels.insert(image.pixels.end(), begin + 1, begin + row);
  }
  return image;
}

using testing::message_of;

}  // namespace cairn::test
