// How marked-up text is measured, wrapped at words and cut to a width.
#pragma once

#include <string>
#include <string_view>

#include <cairn/math/list.hpp>
#include "render/canvas.hpp"

namespace cairn::render {

/// Height of a capital above the base line, as a part of the em.
inline constexpr double cap_height = 0.73;
/// From one base line to the next of running text, as a part of the em.
inline constexpr double leading = 1.4;
/// From the top of a panel's title to what is below it, as a part of the label's em.
inline constexpr double title_pitch = 1.75;

/// The base line that puts capitals of this size in the middle of `y` [px].
double baseline_around(double y, double size);

/// Where the text would stand, from the top of its letters to their descenders. Canvas::text_boxes() tells
/// what is inked, once it is drawn; that is a little less.
Rect text_rect(const Canvas& canvas, const Point& at, std::string_view markup, const TextStyle& style);

/// Wrapped at spaces and line feeds so that every line is at most `width` px wide. A word wider than that is
/// broken between characters, never inside markup.
List<std::string> wrapped(const Canvas& canvas, std::string_view markup, double width,
                          const TextStyle& style);

/// The text, or as much of its beginning as fits in `width` px with an ellipsis behind it.
std::string ellipsized(const Canvas& canvas, std::string_view markup, double width, const TextStyle& style);

/// The style with a size at which the text fits in `width` px, in steps of 1 px, not below `least`.
TextStyle shrunk(const Canvas& canvas, std::string_view markup, double width, TextStyle style, double least);

}  // namespace cairn::render
