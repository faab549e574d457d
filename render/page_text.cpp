// Running text on a page, text that looks for a free place, and numbers for people.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <cairn/math/list.hpp>
#include "render/page.hpp"
#include "render/text_layout.hpp"

namespace cairn::render {

namespace {

constexpr const char* minus_sign = "−";

bool meet(const Rect& first, const Rect& second) {
  return first.x < second.x + second.width && second.x < first.x + first.width &&
         first.y < second.y + second.height && second.y < first.y + first.height;
}

bool lies_within(const Rect& inner, const Rect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

bool meets_text(Span<const TextBox> boxes, const Rect& rect) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const TextBox& box) { return meet(box.rect, rect); });
}

/// Whether the segment has a part in the box, by separating axes: the two of the box and the segment's
/// normal.
bool passes(const Point& from, const Point& to, const Rect& box) {
  const Point half(box.width / 2, box.height / 2);
  const Point center(box.x + half.x(), box.y + half.y());
  const Point middle = 0.5 * (from + to) - center;
  const Point reach = 0.5 * (to - from);
  const bool apart =
      std::abs(middle.x()) >= half.x() + std::abs(reach.x()) ||
      std::abs(middle.y()) >= half.y() + std::abs(reach.y()) ||
      std::abs(cross(reach, middle)) >= half.x() * std::abs(reach.y()) + half.y() * std::abs(reach.x());
  return from.allFinite() && to.allFinite() && !apart;
}

bool meets_line(const List<List<Point>>& lines, const Rect& rect) {
  for (const List<Point>& line : lines) {
    for (int i = 1; i < line.size(); ++i) {
      if (passes(line[i - 1], line[i], rect)) return true;
    }
  }
  return false;
}

/// "" for a number, the word or sign for what is none.
std::string not_finite(double value) {
  if (std::isfinite(value)) return "";
  if (std::isnan(value)) return "NaN";
  return value > 0 ? "∞" : std::string(minus_sign) + "∞";
}

/// The digits of |value| without a point, rounded to so many, and the exponent of the first.
struct Digits {
  std::string text = {};
  int exponent = 0;
};

Digits digits_of(double value, int count) {
  FixedList<char, 64> buffer = {};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value),
                                 std::chars_format::scientific, count - 1)
                       .ptr;
  const std::string text(buffer.data(), end);
  const std::size_t mark = text.find('e');
  Digits digits = {.text = text.substr(0, mark), .exponent = std::atoi(text.c_str() + mark + 1)};
  std::erase(digits.text, '.');
  const std::size_t last = digits.text.find_last_not_of('0');
  digits.text.resize(last == std::string::npos ? 1 : last + 1);
  return digits;
}

/// 1234 with exponent 1 becomes 12.34, with -2 becomes 0.01234, and 12 with 3 becomes 1200.
std::string plain(const Digits& digits) {
  if (digits.exponent < 0) {
    return "0." + std::string(static_cast<std::size_t>(-digits.exponent - 1), '0') + digits.text;
  }
  const std::size_t whole = static_cast<std::size_t>(digits.exponent) + 1;
  if (digits.text.size() <= whole) return digits.text + std::string(whole - digits.text.size(), '0');
  return digits.text.substr(0, whole) + "." + digits.text.substr(whole);
}

}  // namespace

double Page::paragraph(const Point& at, double width, std::string_view text, const TextStyle& style) {
  const double pitch = std::round(leading * style.size);
  Point line = at;
  for (const std::string& words : wrapped(canvas_, text, width, style)) {
    if (!words.empty()) canvas_.text(line, words, style);
    line.y() += pitch;
  }
  return line.y() - at.y();
}

void Page::place_text(const List<Point>& places, const Rect& within, std::string_view text,
                      const TextStyle& style) {
  if (places.empty()) return;
  const Point* chosen = nullptr;
  for (const Point& place : places) {
    const Rect rect = text_rect(canvas_, place, text, style);
    if (!lies_within(rect, within) || meets_text(canvas_.text_boxes(), rect)) continue;
    if (chosen == nullptr) chosen = &place;
    if (!meets_line(avoided_, rect) && !meets_line(curves_, rect)) {
      chosen = &place;
      break;
    }
  }
  canvas_.text(chosen == nullptr ? places.front() : *chosen, text, style);
}

std::string fixed(double value, int decimals, Sign sign) {
  std::string text = not_finite(value);
  if (text.empty()) {
    FixedList<char, 512> buffer = {};  // 309 digits, a point, and decimals
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value),
                                   std::chars_format::fixed, std::clamp(decimals, 0, 150))
                         .ptr;
    text.assign(buffer.data(), end);
    // What is rounded to zero has no sign.
    const bool zero = text.find_first_not_of("0.") == std::string::npos;
    if (zero) return text;
    if (value < 0) text.insert(0, minus_sign);
  }
  if (sign == Sign::always && value > 0) text.insert(0, "+");
  return text;
}

std::string significant(double value, int digits) {
  const std::string word = not_finite(value);
  if (!word.empty()) return word;
  if (value == 0) return "0";
  const Digits rounded = digits_of(value, std::clamp(digits, 1, 17));
  const std::string sign = value < 0 ? minus_sign : "";
  if (rounded.exponent >= -4 && rounded.exponent < 6) return sign + plain(rounded);
  const std::string power = rounded.exponent < 0 ? minus_sign + std::to_string(-rounded.exponent)
                                                 : std::to_string(rounded.exponent);
  return sign + plain({.text = rounded.text, .exponent = 0}) + "×10^{" + power + "}";
}

std::string readable(double value, int decimals) {
  return std::abs(value) < 1e5 ? fixed(value, decimals) : significant(value);
}

}  // namespace cairn::render
