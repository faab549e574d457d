// Animated PNG: the pixels that changed, compressed, in the chunks of the animation extension.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include "render/sequence.hpp"

namespace cairn::render {
namespace {

using Bytes = List<std::uint8_t>;

constexpr int compression_level = 9;  // a film is made once and sent often

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

/// Where the bytes of a pixel begin.
int offset_of(const ApngWriter::Picture& picture, int x, int y) {
  return picture.depth * (y * picture.width + x);
}

bool is_as_before(const ApngWriter::Picture& before, const ApngWriter::Picture& after, int x, int y) {
  const auto pixel = after.bytes.begin() + offset_of(after, x, y);
  return std::equal(pixel, pixel + after.depth, before.bytes.begin() + offset_of(before, x, y));
}

/// The smallest rectangle that holds every pixel that changed. The format knows no empty frame: one pixel
/// then.
Block changed_rect(const ApngWriter::Picture& before, const ApngWriter::Picture& after) {
  int left = after.width, right = -1, top = after.height, bottom = -1;
  for (int y = 0; y < after.height; ++y) {
    for (int x = 0; x < after.width; ++x) {
      if (is_as_before(before, after, x, y)) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  }
  if (right < 0) return {};
  return {.x = left, .y = top, .width = right - left + 1, .height = bottom - top + 1};
}

/// What means "as before" (tRNS): long runs of it take next to nothing. In a palette it is the first entry.
constexpr std::uint8_t unchanged_color[] = {3, 253, 2};
constexpr std::uint8_t unchanged_entry[] = {0};

const std::uint8_t* unchanged(int depth) { return depth == 1 ? unchanged_entry : unchanged_color; }

/// A pixel of just the colour that means "as before" is shown one level bluer.
Bytes without_unchanged(Bytes pixels) {
  for (int i = 0; i < pixels.size(); i += 3)
    if (std::equal(unchanged_color, unchanged_color + 3, pixels.begin() + i)) ++pixels[i + 2];
  return pixels;
}

/// The number in the file's palette of each pixel.
Bytes entries_of(const Bytes& pixels, Palette& palette) {
  Bytes entries;
  std::uint32_t last = color_at(pixels.data());
  std::uint8_t entry = palette.nearest(last);
  for (int i = 0; i < pixels.size(); i += 3) {
    const std::uint32_t color = color_at(&pixels[i]);
    if (color != last) entry = palette.nearest(color);
    last = color;
    entries.push_back(static_cast<std::uint8_t>(entry + 1));
  }
  return entries;
}

/// The rows of the rectangle of `after`, compressed; with `before`, what is as in that is left out.
Bytes compressed(const ApngWriter::Picture* before, const ApngWriter::Picture& after, const Block& rect) {
  Bytes rows;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    rows.push_back(0);  // flat colours compress best unfiltered
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const bool is_left_out = before != nullptr && is_as_before(*before, after, x, y);
      const std::uint8_t* const pixel =
          is_left_out ? unchanged(after.depth) : &after.bytes[offset_of(after, x, y)];
      for (int i = 0; i < after.depth; ++i) rows.push_back(pixel[i]);
    }
  }
  uLongf length = compressBound(static_cast<uLong>(rows.size()));
  Bytes result(static_cast<std::ptrdiff_t>(length));
  if (compress2(result.data(), &length, rows.data(), static_cast<uLong>(rows.size()), compression_level) !=
      Z_OK)
    throw std::bad_alloc();  // the only way in which it can fail here
  result.resize(static_cast<std::ptrdiff_t>(length));
  return result;
}

/// fcTL: where the frame lies, and the fraction of a second that it stays.
Bytes frame_control(std::uint32_t sequence_number, const Block& rect,
                    const FixedList<std::uint32_t, 2>& seconds) {
  Bytes data;
  append_number(data, sequence_number);
  for (const int value : {rect.width, rect.height, rect.x, rect.y}) {
    append_number(data, static_cast<std::uint32_t>(value));
  }
  append_short(data, seconds[0]);
  append_short(data, seconds[1]);
  data.push_back(0);  // the frame stays when its time is over
  data.push_back(1);  // its pixels cover what was there, but for those that are left out
  return data;
}

}  // namespace

ApngWriter::ApngWriter(const std::filesystem::path& path, int frames, double frames_per_second,
                       const List<std::uint32_t>& palette)
    : file_(path), frames_(frames), palette_(palette) {
  require(frames > 0, "ApngWriter", "frames", "at least one", frames);
  require(frames_per_second >= 0.01 && frames_per_second <= 655, "ApngWriter", "frames_per_second",
          "0.01 to 655 1/s", frames_per_second);
  require(palette.size() < 256, "ApngWriter", "palette", "at most 255 colours", palette.size());
  hundredths_ = static_cast<std::uint32_t>(std::lround(100 * frames_per_second));
}

void ApngWriter::begin(const Picture& first) {
  Bytes chunks = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes data;
  append_number(data, static_cast<std::uint32_t>(first.width));
  append_number(data, static_cast<std::uint32_t>(first.height));
  const std::uint8_t color_type = first.depth == 1 ? 3 : 2;
  data.insert(data.end(), {8, color_type, 0, 0, 0});  // bits, colours, and the only ways there are
  append_chunk(chunks, "IHDR", data);
  data.clear();
  append_number(data, static_cast<std::uint32_t>(frames_));
  append_number(data, 0);  // repeats for ever
  append_chunk(chunks, "acTL", data);
  if (first.depth == 1) {
    data.assign(unchanged_color, unchanged_color + 3);
    for (const std::uint32_t color : palette_.colors())
      for (const unsigned shift : {16U, 8U, 0U}) data.push_back(static_cast<std::uint8_t>(color >> shift));
    append_chunk(chunks, "PLTE", data);
    append_chunk(chunks, "tRNS", Bytes{0});
  } else {
    append_chunk(chunks, "tRNS", Bytes{0, unchanged_color[0], 0, unchanged_color[1], 0, unchanged_color[2]});
  }
  file_.write(chunks);
}

void ApngWriter::add(const Image& image, int times) {
  require_image(image, "ApngWriter");
  require(times > 0 && times < 655, "ApngWriter", "times", "1 to 654", times);
  const bool is_first = added_ == 0;
  if (!is_first) {
    require(image.width == last_.width, "ApngWriter", "width", "that of the first image", image.width);
    require(image.height == last_.height, "ApngWriter", "height", "that of the first image", image.height);
  }
  const bool is_colored = palette_.colors().empty();
  Picture picture{.width = image.width, .height = image.height, .depth = is_colored ? 3 : 1};
  picture.bytes = is_colored ? without_unchanged(image.pixels) : entries_of(image.pixels, palette_);
  if (is_first) begin(picture);
  const Block rect = is_first ? Block{.x = 0, .y = 0, .width = image.width, .height = image.height}
                              : changed_rect(last_, picture);
  Bytes chunks, data;
  append_chunk(
      chunks, "fcTL",
      frame_control(sequence_number_++, rect, {100 * static_cast<std::uint32_t>(times), hundredths_}));
  if (!is_first) append_number(data, sequence_number_++);
  const Bytes pixels = compressed(is_first ? nullptr : &last_, picture, rect);
  data.insert(data.end(), pixels.begin(), pixels.end());
  append_chunk(chunks, is_first ? "IDAT" : "fdAT", data);
  file_.write(chunks);
  last_ = std::move(picture);
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
