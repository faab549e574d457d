// Markup, UTF-8, and where glyphs stand.
#include "render/markup.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "render/variables.hpp"

namespace cairn::render {
namespace {

constexpr double script_size = 0.78;        // of the em around it
constexpr double subscript_drop = 0.20;     // [em]
constexpr double superscript_drop = -0.36;  // [em]
constexpr double parting = 0.08;            // [em] that each gives way where one stands above the other
constexpr int deepest_script = 4;
constexpr char32_t not_utf8 = 0xFFFD;

/// Where the next glyph goes and how large it is.
struct Pen {
  double x = 0;
  double drop = 0;
  double size = 0;
  int depth = 0;
};

/// Whether a letter in a script stands for a number or a quantity: "i" and those of "ij", and none of "rel".
bool is_index(std::string_view before, char32_t sign, std::string_view behind) {
  constexpr std::string_view indices = "ijk";
  const auto is_letter = [](char32_t other) {
    return (other >= U'a' && other <= U'z') || (other >= U'A' && other <= U'Z') ||
           (other >= U'α' && other <= U'ω');
  };
  const auto is_no_letter = [&](char other) { return !is_letter(static_cast<unsigned char>(other)); };
  if (sign < U'a' || !is_letter(sign)) return false;
  const std::string word =
      std::string(std::find_if(before.rbegin(), before.rend(), is_no_letter).base(), before.end()) +
      std::string(behind.begin(), std::find_if(behind.begin(), behind.end(), is_no_letter));
  return word.empty() || (indices.find(static_cast<char>(sign)) != indices.npos &&
                          word.find_first_not_of(indices) == word.npos);
}

class Setter {
 public:
  Setter(Face face, List<PlacedGlyph>& glyphs) : face_(face), glyphs_(glyphs) {}

  void set(std::string_view markup, Pen& pen) {
    const std::string_view whole = markup;
    while (!markup.empty()) {
      const char first = markup.front();
      if (first == '\\' && markup.size() > 1 && (markup[1] == '_' || markup[1] == '^')) {
        markup.remove_prefix(1);
        place(markup, whole, pen);
      } else if ((first == '_' || first == '^') && markup.size() > 1 && pen.depth < deepest_script) {
        set_scripts(markup, pen);
      } else {
        place(markup, whole, pen);
      }
    }
  }

 private:
  /// The first sign of `markup`, which is the rest of `whole`.
  void place(std::string_view& markup, std::string_view whole, Pen& pen) {
    const std::string_view rest = markup;
    char32_t code_point = take_code_point(markup);
    std::string_view sign = rest.substr(0, rest.size() - markup.size());
    if (code_point < U' ') {
      code_point = U' ';
      sign = " ";
    }
    if (code_point == not_utf8) sign = "\uFFFD";
    const std::string_view before = whole.substr(0, whole.size() - rest.size());
    GlyphName name = find_glyph(face_, code_point);
    name.slanted =
        pen.depth > 0 ? is_index(before, code_point, markup) : is_variable(before, code_point, markup);
    glyphs_.push_back({.name = name, .size = pen.size, .x = pen.x, .drop = pen.drop, .sign = sign});
    pen.x += advance(name, pen.size);
  }

  /// All scripts that follow directly: they start at the same place unless one kind comes twice.
  void set_scripts(std::string_view& markup, Pen& pen) {
    Pen below = pen;
    Pen above = pen;
    for (Pen* script : {&below, &above}) {
      script->size *= script_size;
      ++script->depth;
    }
    below.drop += subscript_drop * pen.size;
    above.drop += superscript_drop * pen.size;
    const int first = glyphs_.size();
    while (markup.size() > 1 && (markup.front() == '_' || markup.front() == '^')) {
      Pen& script = markup.front() == '_' ? below : above;
      markup.remove_prefix(1);
      set(take_group(markup), script);
    }
    if (below.x > pen.x && above.x > pen.x) {
      for (int i = first; i < glyphs_.size(); ++i) {
        glyphs_[i].drop += (glyphs_[i].drop > pen.drop ? parting : -parting) * pen.size;
      }
    }
    pen.x = std::max(below.x, above.x);
  }

  /// What stands in braces, or one character, possibly escaped. An open brace reaches to the end.
  static std::string_view take_group(std::string_view& markup) {
    if (markup.front() != '{') {
      std::string_view rest = markup;
      const bool escaped = rest.front() == '\\' && rest.size() > 1 && (rest[1] == '_' || rest[1] == '^');
      rest.remove_prefix(escaped ? 1 : 0);
      take_code_point(rest);
      const std::string_view group = markup.substr(0, markup.size() - rest.size());
      markup = rest;
      return group;
    }
    std::size_t end = 1;
    for (int depth = 1; end < markup.size(); ++end) {
      depth += markup[end] == '{' ? 1 : markup[end] == '}' ? -1 : 0;
      if (depth == 0) {
        break;
      }
    }
    const std::string_view group = markup.substr(1, end - 1);
    markup.remove_prefix(std::min(end + 1, markup.size()));
    return group;
  }

  Face face_;
  List<PlacedGlyph>& glyphs_;
};

}  // namespace

GlyphLine lay_out(std::string_view markup, double size, Face face) {
  GlyphLine line;
  Pen pen = {.size = size};
  Setter(face, line.glyphs).set(markup, pen);
  line.width = pen.x;
  return line;
}

char32_t take_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  char32_t code_point = length == 1   ? first
                        : length == 2 ? first & 0x1FU
                        : length == 3 ? first & 0x0FU
                                      : first & 7U;
  bool whole = length > 0 && length <= text.size();
  for (std::size_t i = 1; whole && i < length; ++i) {
    whole = (byte(i) & 0xC0U) == 0x80U;
    code_point = code_point << 6U | (byte(i) & 0x3FU);
  }
  // Longer than need be, half of a surrogate pair, or beyond Unicode: not UTF-8 either.
  const bool spelled = length < 3 || (length == 3 ? code_point >= 0x800 : code_point >= 0x10000);
  const bool sign = code_point < 0xD800 || (code_point > 0xDFFF && code_point <= 0x10FFFF);
  whole = whole && spelled && sign;
  text.remove_prefix(whole ? length : 1);
  return whole ? code_point : not_utf8;
}

}  // namespace cairn::render
