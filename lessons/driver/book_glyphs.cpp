// Characters, one at a time, and what they are in a formula.
#include "lessons/driver/book_glyphs.hpp"

#include <cctype>

namespace cairn::driver {

const GlyphMap raised = {{"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"}, {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"},
                         {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}, {"⁺", "+"}, {"⁻", "−"}, {"ᵀ", "T"}, {"ᵏ", "k"},
                         {"ⁱ", "i"}, {"ˢ", "s"}, {"ⁿ", "n"}, {"⁽", "("}, {"⁾", ")"}, {"ˡ", "l"}};
const GlyphMap lowered = {{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"}, {"₄", "4"}, {"₅", "5"},
                          {"₆", "6"}, {"₇", "7"}, {"₈", "8"}, {"₉", "9"}, {"₊", "+"}, {"₋", "−"},
                          {"ᵢ", "i"}, {"ⱼ", "j"}, {"ₙ", "n"}, {"ₜ", "t"}, {"ₓ", "x"}, {"ₖ", "k"}};
const GlyphSet operators = {"+", "−", "=", "←", "≥", "≤", "·", "×", "≠", ",", ":",
                            ";", "<", ">", "≈", "±", "→", "∈", "∞", "…", "°", "%"};
const GlyphSet functions = {"max", "min", "diag", "cos", "sin", "tan", "atan", "ln", "exp"};
const GlyphSet long_names = {"length", "error", "top", "dc", "dt", "gap", "kg", "Hz"};
const GlyphSet units = {"N", "m", "s", "kg", "Hz", "J"};
const GlyphSet small_words = {"as", "is", "to", "or", "at", "an", "of", "by",
                              "it", "no", "so", "in", "on", "if", "be", "we"};

Glyphs glyphs_of(std::string_view text) {
  Glyphs glyphs;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U && !glyphs.empty()) {
      glyphs.back() += c;
    } else {
      glyphs.emplace_back(1, c);
    }
  }
  return glyphs;
}

bool is_latin(const std::string& glyph) {
  return glyph.size() == 1 && std::isalpha(static_cast<unsigned char>(glyph[0])) != 0;
}
bool is_digit(const std::string& glyph) {
  return glyph.size() == 1 && std::isdigit(static_cast<unsigned char>(glyph[0])) != 0;
}
bool is_greek(const std::string& glyph) { return glyph >= "Α" && glyph <= "ω"; }

}  // namespace cairn::driver
