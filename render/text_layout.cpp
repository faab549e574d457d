// Measuring, wrapping and cutting marked-up text.
#include "render/text_layout.hpp"

#include <algorithm>
#include <iterator>

namespace cairn::render {

namespace {

/// The end of the piece that begins at `from` and must stay whole: a character, with its sub- or superscript
/// mark.
std::size_t piece_end(std::string_view text, std::size_t from) {
  const char first = text[from];
  if ((first == '_' || first == '^') && from + 1 < text.size()) {
    if (text[from + 1] != '{') return piece_end(text, from + 1);
    int depth = 0;
    for (std::size_t i = from + 1; i < text.size(); ++i) {
      if (text[i] == '{') ++depth;
      if (text[i] == '}' && --depth == 0) return i + 1;
    }
    return text.size();
  }
  std::size_t end = from + 1;
  if (first == '\\' && end < text.size()) ++end;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return end;
}

/// As many pieces of the text as fit, at least one, so that whoever cuts comes to an end.
std::size_t fitting_end(const Canvas& canvas, std::string_view text, double width, const TextStyle& style) {
  std::size_t end = piece_end(text, 0);
  while (end < text.size()) {
    const std::size_t next = piece_end(text, end);
    if (canvas.text_width(text.substr(0, next), style) > width) break;
    end = next;
  }
  return end;
}

bool is_unit(std::string_view word) {
  const std::size_t last = word.find_last_not_of(".,;:?!)");
  if (last == std::string_view::npos) return false;
  static constexpr std::string_view units[] = {"m", "mm", "m/s", "mm/s", "m/s²", "s",     "ms", "kg", "N",
                                               "J", "W",  "Hz",  "%",    "rad",  "rad/s", "m²", "px"};
  return std::find(std::begin(units), std::end(units), word.substr(0, last + 1)) != std::end(units);
}

/// Where the units end that follow a number which ends at `end`: they stay on its line.
std::size_t end_with_units(std::string_view text, std::size_t end) {
  if (end == 0 || text[end - 1] < '0' || text[end - 1] > '9') return end;
  while (end < text.size() && text[end] == ' ') {
    const std::size_t next = std::min(text.find_first_of(" \n", end + 1), text.size());
    if (!is_unit(text.substr(end + 1, next - end - 1))) break;
    end = next;
  }
  return end;
}

/// Words with the spaces before them, a number with its unit; a line feed is a word of its own.
List<std::string_view> words_of(std::string_view text) {
  List<std::string_view> words;
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = begin;
    while (end < text.size() && text[end] == ' ') ++end;
    if (end < text.size() && text[end] == '\n') {
      ++end;
    } else {
      while (end < text.size() && text[end] != ' ' && text[end] != '\n') end = piece_end(text, end);
      end = end_with_units(text, end);
    }
    words.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

std::string_view without_leading_spaces(std::string_view word) {
  const std::size_t begin = word.find_first_not_of(' ');
  return begin == std::string_view::npos ? std::string_view() : word.substr(begin);
}

}  // namespace

double baseline_around(double y, double size) { return y + cap_height / 2 * size; }

Rect text_rect(const Canvas& canvas, const Point& at, std::string_view markup, const TextStyle& style) {
  const double width = canvas.text_width(markup, style);
  double left = at.x();
  if (style.align == Align::center) left -= width / 2;
  if (style.align == Align::right) left -= width;
  return {left, at.y() - 0.80 * style.size, width, 1.04 * style.size};
}

List<std::string> wrapped(const Canvas& canvas, std::string_view markup, double width,
                          const TextStyle& style) {
  List<std::string> lines(1);
  for (const std::string_view word : words_of(markup)) {
    if (word.back() == '\n') {
      lines.emplace_back();
      continue;
    }
    std::string longer = lines.back();
    longer += word;
    if (canvas.text_width(longer, style) <= width) {
      lines.back() = longer;
      continue;
    }
    std::string_view rest = without_leading_spaces(word);
    if (!lines.back().empty() && !rest.empty()) lines.emplace_back();
    while (!rest.empty()) {
      const std::size_t end = fitting_end(canvas, rest, width, style);
      lines.back() = rest.substr(0, end);
      rest.remove_prefix(end);
      if (!rest.empty()) lines.emplace_back();
    }
  }
  return lines;
}

std::string ellipsized(const Canvas& canvas, std::string_view markup, double width, const TextStyle& style) {
  if (canvas.text_width(markup, style) <= width) return std::string(markup);
  std::string cut;
  for (std::size_t end = 0; end < markup.size();) {
    end = piece_end(markup, end);
    std::string longer(markup.substr(0, end));
    longer += "…";
    if (canvas.text_width(longer, style) > width) break;
    cut = longer;
  }
  return cut;
}

TextStyle shrunk(const Canvas& canvas, std::string_view markup, double width, TextStyle style, double least) {
  while (style.size > least && canvas.text_width(markup, style) > width) {
    style.size = std::max(least, style.size - 1);
  }
  return style;
}

}  // namespace cairn::render
