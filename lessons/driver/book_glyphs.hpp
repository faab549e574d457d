// The characters that formulas are typed with.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "math/list.hpp"

namespace cairn::driver {

using Glyphs = List<std::string>;  // one character of UTF-8 each
using GlyphMap = std::map<std::string, std::string>;
using GlyphSet = std::set<std::string>;

Glyphs glyphs_of(std::string_view text);
bool is_latin(const std::string& glyph);
bool is_digit(const std::string& glyph);
bool is_greek(const std::string& glyph);

extern const GlyphMap raised;      // "²" -> "2"
extern const GlyphMap lowered;     // "₁" -> "1"
extern const GlyphSet operators;   // what stands between two terms
extern const GlyphSet functions;   // "max"
extern const GlyphSet long_names;  // variables and units of more than one letter
extern const GlyphSet units;
extern const GlyphSet small_words;  // English, though they have no more than two letters

}  // namespace cairn::driver
