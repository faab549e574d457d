// Animated PNG: the encoder's own compressed pixels, wrapped in the chunks of the animation extension.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include "render/sequence.hpp"

namespace cairn::render {
namespace {

using Bytes = List<std::uint8_t>;

// Of every file that encode_png() makes: signature, header chunk, then one chunk with all pixels.
constexpr int signature_size = 8;
constexpr int header_end = signature_size + 12 + 13;

struct Block {
  int x = 0, y = 0, width = 1, height = 1;  // [px]
};

void append_number(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_short(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

/// Length, name, data, and the checksum of name and data.
void append_chunk(Bytes& file, std::string_view name, Span<const std::uint8_t> data) {
  append_number(file, static_cast<std::uint32_t>(data.size()));
  const int start = file.size();
  file.insert(file.end(), name.begin(), name.end());
  file.insert(file.end(), data.begin(), data.end());
  const uLong checksum = crc32_z(0, file.data() + start, static_cast<z_size_t>(file.size() - start));
  append_number(file, static_cast<std::uint32_t>(checksum));
}

/// The compressed pixels inside a file of encode_png().
Span<const std::uint8_t> compressed_pixels(Span<const std::uint8_t> png) {
  int length = 0;
  for (int i = 0; i < 4; ++i) length = length << 8 | png[header_end + i];
  return png.subspan(header_end + 8, length);
}

int offset_of(const Image& image, int x, int y) { return 3 * (y * image.width + x); }

/// The smallest rectangle that holds every pixel that changed. The format knows no empty frame: one pixel
/// then.
Block changed_rect(const Image& before, const Image& after) {
  int left = after.width, right = -1, top = after.height, bottom = -1;
  for (int y = 0; y < after.height; ++y) {
    for (int x = 0; x < after.width; ++x) {
      const int pixel = offset_of(after, x, y);
      if (std::equal(before.pixels.begin() + pixel, before.pixels.begin() + pixel + 3,
                     after.pixels.begin() + pixel)) {
        continue;
      }
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  }
  if (right < 0) return {};
  return {.x = left, .y = top, .width = right - left + 1, .height = bottom - top + 1};
}

/// The colour that means "as before" (tRNS): long runs of it take next to nothing.
constexpr std::uint8_t unchanged[] = {3, 253, 2};

/// A pixel of just that colour is shown one level bluer.
void keep_clear(Image& image) {
  for (int i = 0; i < image.pixels.size(); i += 3)
    if (std::equal(unchanged, unchanged + 3, image.pixels.begin() + i)) ++image.pixels[i + 2];
}

/// The rectangle of `after`, with what is as before left out.
Image changes(const Image& before, const Image& after, const Block& rect) {
  Image part{.width = rect.width, .height = rect.height};
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const auto pixel = after.pixels.begin() + offset_of(after, x, y);
      const bool is_same = std::equal(pixel, pixel + 3, before.pixels.begin() + offset_of(before, x, y));
      for (int i = 0; i < 3; ++i) part.pixels.push_back(is_same ? unchanged[i] : pixel[i]);
    }
  }
  return part;
}

/// fcTL: where the frame lies and how long it stays, [100 / hundredths s].
Bytes frame_control(std::uint32_t sequence_number, const Block& rect, std::uint32_t hundredths) {
  Bytes data;
  append_number(data, sequence_number);
  for (const int value : {rect.width, rect.height, rect.x, rect.y}) {
    append_number(data, static_cast<std::uint32_t>(value));
  }
  append_short(data, 100);
  append_short(data, hundredths);
  data.push_back(0);  // the frame stays when its time is over
  data.push_back(1);  // its pixels cover what was there, but for those that are left out
  return data;
}

}  // namespace

ApngWriter::ApngWriter(const std::filesystem::path& path, int frames, double frames_per_second)
    : file_(path), frames_(frames) {
  require(frames > 0, "ApngWriter", "frames", "at least one", frames);
  require(frames_per_second >= 0.01 && frames_per_second <= 655, "ApngWriter", "frames_per_second",
          "0.01 to 655 1/s", frames_per_second);
  hundredths_ = static_cast<std::uint32_t>(std::lround(100 * frames_per_second));
}

void ApngWriter::add(Image image) {
  require_image(image, "ApngWriter");
  keep_clear(image);
  const bool is_first = added_ == 0;
  if (!is_first) {
    require(image.width == last_.width, "ApngWriter", "width", "that of the first image", image.width);
    require(image.height == last_.height, "ApngWriter", "height", "that of the first image", image.height);
  }
  const Block rect = is_first ? Block{.x = 0, .y = 0, .width = image.width, .height = image.height}
                              : changed_rect(last_, image);
  const Bytes png = encode_png(is_first ? image : changes(last_, image, rect));
  Bytes chunks, data;
  if (is_first) {
    chunks.assign(png.begin(), png.begin() + header_end);
    append_number(data, static_cast<std::uint32_t>(frames_));
    append_number(data, 0);  // repeats for ever
    append_chunk(chunks, "acTL", data);
    append_chunk(chunks, "tRNS", Bytes{0, unchanged[0], 0, unchanged[1], 0, unchanged[2]});
    data.clear();
  }
  append_chunk(chunks, "fcTL", frame_control(sequence_number_++, rect, hundredths_));
  if (!is_first) append_number(data, sequence_number_++);
  const Span<const std::uint8_t> pixels = compressed_pixels(png);
  data.insert(data.end(), pixels.begin(), pixels.end());
  append_chunk(chunks, is_first ? "IDAT" : "fdAT", data);
  file_.write(chunks);
  last_ = std::move(image);
  ++added_;
}

void ApngWriter::finish() {
  require(added_ == frames_, "ApngWriter", "frames added", std::to_string(frames_), added_);
  Bytes end;
  append_chunk(end, "IEND", {});
  file_.write(end);
  file_.finish();
}

}  // namespace cairn::render
