// Pictures on disk: PNG files, and how far two pictures differ.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include <cairn/math/list.hpp>
#include <cairn/measure/whole_file.hpp>
#include "render/canvas.hpp"

namespace cairn::render {

using cairn::WriteError;

/// @throws std::invalid_argument unless both sides are positive and there are 3 bytes for every pixel.
void require_image(const Image& image, std::string_view place);

/// The bytes of a PNG file. The same image gives the same bytes on every thread.
/// @throws std::invalid_argument as require_image().
List<std::uint8_t> encode_png(const Image& image);
/// The bytes of a PNG file without a background, from the same picture on black and on white.
/// @throws std::invalid_argument as require_image(), or where the two differ in size.
List<std::uint8_t> encode_transparent_png(const Image& on_black, const Image& on_white);
/// The part of a picture inside a rectangle of whole pixels.
/// @throws std::invalid_argument where it does not lie in the picture.
Image part_of(const Image& image, int left, int top, int width, int height);
/// Any PNG; an alpha channel is dropped. @throws std::runtime_error with the reason.
Image decode_png(Span<const std::uint8_t> bytes);

/// Whole or not at all. @throws WriteError, or std::invalid_argument as require_image().
void write_png(const std::filesystem::path& path, const Image& image);
/// @throws std::runtime_error that names the file and the reason.
Image read_png(const std::filesystem::path& path);

/// How far two pictures differ. Pictures of two sizes differ in every pixel and as much as can be.
struct ImageDifference {
  bool same_size = false;
  int largest = 0;          // of one channel, 0..255
  long long differing = 0;  // [pixels]
};

ImageDifference compare(const Image& expected, const Image& actual);

/// `actual` in pale grey; red where a channel differs by more than `tolerance` or one image has no pixel.
Image difference_image(const Image& expected, const Image& actual, int tolerance = 0);

}  // namespace cairn::render
