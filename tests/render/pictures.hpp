// What tests of pictures share: the renderer, how far a pixel is from a colour, and what is written on a
// page.
#pragma once

#include "images/golden.hpp"
#include "render/lint.hpp"
#include "render/page.hpp"
#include "testing.hpp"

namespace cairn::render {

/// How far each channel of a pixel is from that of a colour, 0 to 255.
inline FixedList<double, 3> channels_off(const Image& image, int x, int y, const Color& color) {
  const int at = 3 * (y * image.width + x);
  return {std::abs(image.pixels.at(at) - 255.0 * static_cast<double>(color.r)),
          std::abs(image.pixels.at(at + 1) - 255.0 * static_cast<double>(color.g)),
          std::abs(image.pixels.at(at + 2) - 255.0 * static_cast<double>(color.b))};
}

/// The worst of the three channels.
inline double worst_off(const Image& image, int x, int y, const Color& color) {
  const FixedList<double, 3> off = channels_off(image, x, y, color);
  return std::max({off[0], off[1], off[2]});
}

/// All channels together.
inline double sum_off(const Image& image, int x, int y, const Color& color) {
  const FixedList<double, 3> off = channels_off(image, x, y, color);
  return off[0] + off[1] + off[2];
}

/// What was drawn on a page, what is written there, and what is wrong with its layout.
struct PagePicture {
  Image image = {};
  List<TextBox> boxes = {};
  List<std::string> faults = {};
};

/// A page of 640 px by 360 px with what draw(page) draws on it.
template <typename Draw>
PagePicture picture_of_page(const Theme& theme, const Draw& draw) {
  Page page(640, 360, theme);
  page.canvas().clear(page.theme().background);
  draw(page);
  const Span<const TextBox> boxes = page.canvas().text_boxes();
  return {.image = page.canvas().read(), .boxes = {boxes.begin(), boxes.end()}, .faults = lint(page)};
}

template <typename Boxes>
const TextBox* find_text(const Boxes& boxes, const std::string& text) {
  const auto found =
      std::find_if(boxes.begin(), boxes.end(), [&](const TextBox& box) { return box.text == text; });
  return found == boxes.end() ? nullptr : &*found;
}

inline bool is_written(const PagePicture& picture, const std::string& text) {
  return find_text(picture.boxes, text) != nullptr;
}
inline bool is_written(const Page& page, const std::string& text) {
  return find_text(page.canvas().text_boxes(), text) != nullptr;
}

}  // namespace cairn::render
