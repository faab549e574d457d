// Markup, UTF-8, and where glyphs stand.
#include "render/markup.hpp"

#include <algorithm>
#include <cstdint>

namespace cairn::render {
namespace {

constexpr double script_size = 0.78;        // of the em around it
constexpr double subscript_drop = 0.20;     // [em]
constexpr double superscript_drop = -0.36;  // [em]
constexpr double parting = 0.08;            // [em] that each gives way where one stands above the other
constexpr int deepest_script = 4;
constexpr char32_t not_utf8 = 0xFFFD;
constexpr char32_t beginning = 0;  // what stands before the first sign

/// Where the next glyph goes and how large it is.
struct Pen {
  double x = 0;
  double drop = 0;
  double size = 0;
  int depth = 0;
};

bool is_small_greek(char32_t sign) { return sign >= U'α' && sign <= U'ω'; }

/// Latin, or small Greek; Δ and Σ are signs of operations.
bool is_letter(char32_t sign) {
  return (sign >= U'a' && sign <= U'z') || (sign >= U'A' && sign <= U'Z') || is_small_greek(sign);
}

class Setter {
 public:
  Setter(Face face, bool is_formula, List<PlacedGlyph>& glyphs)
      : face_(face), is_formula_(is_formula), glyphs_(glyphs) {}

  void set(std::string_view markup, Pen& pen) {
    char32_t before = beginning;
    while (!markup.empty()) {
      const char first = markup.front();
      if (first == '\\' && markup.size() > 1 && (markup[1] == '_' || markup[1] == '^')) {
        markup.remove_prefix(1);
        before = place(markup, before, pen);
      } else if ((first == '_' || first == '^') && markup.size() > 1 && pen.depth < deepest_script) {
        set_scripts(markup, pen);
      } else {
        before = place(markup, before, pen);
      }
    }
  }

 private:
  /// Returns the sign that it has placed.
  char32_t place(std::string_view& markup, char32_t sign_before, Pen& pen) {
    const std::string_view before = markup;
    char32_t code_point = take_code_point(markup);
    std::string_view sign = before.substr(0, before.size() - markup.size());
    if (code_point < U' ') {
      code_point = U' ';
      sign = " ";
    }
    if (code_point == not_utf8) sign = "\uFFFD";
    GlyphName name = find_glyph(face_, code_point);
    name.slanted = is_variable(code_point, sign_before, markup, pen);
    glyphs_.push_back({.name = name, .size = pen.size, .x = pen.x, .drop = pen.drop, .sign = sign});
    pen.x += advance(name, pen.size);
    return code_point;
  }

  /// Whether a letter stands for a quantity, from what stands before and after it.
  bool is_variable(char32_t sign, char32_t before, std::string_view rest, const Pen& pen) const {
    const bool is_unit = (sign == U'm' && rest.starts_with("/s")) || (sign == U's' && before == U'/');
    const bool has_unit = before == beginning && rest.starts_with(" (");
    const bool has_subscript = rest.size() > 1 && rest.front() == '_';
    const char32_t after = rest.empty() ? U' ' : take_code_point(rest);
    if (is_unit || !is_letter(sign) || is_letter(before) || is_letter(after)) return false;
    const bool is_index = pen.depth > 0 && sign >= U'a';
    return is_formula_ || has_unit || has_subscript || is_index || before == U'Δ' || is_small_greek(sign);
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
  bool is_formula_;
  List<PlacedGlyph>& glyphs_;
};

}  // namespace

GlyphLine lay_out(std::string_view markup, double size, Face face, bool is_formula) {
  GlyphLine line;
  Pen pen = {.size = size};
  Setter(face, is_formula, line.glyphs).set(markup, pen);
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
