// Words and numbers as people type and read them: fractions, near misses, plain ASCII.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <cairn/math/list.hpp>
#include <cairn/math/nearest.hpp>

namespace cairn {

/// "0.02", "-3", "−3", "1e-6" or a fraction such as "1/60". Nothing for anything else, infinity and NaN among
/// it.
std::optional<double> parse_number(std::string_view text);

/// Numbers between commas; nothing unless each is one.
std::optional<List<double>> parse_numbers(std::string_view text);

/// The text in ASCII: "λ₂ = j M⁻¹ jᵀ" becomes "lambda_2 = j M^-1 j^T".
std::string transliterated(std::string_view text);

/// The text with "−" for "-" before its numbers: " -0.2" becomes " −0.2". "1e-9", "2-6" and "--sweeps" stay.
std::string with_minus_signs(std::string_view text);

/// The columns that UTF-8 text takes on a terminal (every letter counts one, combining marks none).
int display_width(std::string_view text);

/// The character, so many times.
std::string repeated(char character, int count);

/// The text and blanks behind it, `width` columns in all; the text alone if it is longer.
std::string padded(std::string_view text, int width);

/// The text broken at blanks into lines of at most `width` columns; all but the first begin with `indent`
/// blanks.
std::string wrapped(std::string_view text, int width, int indent);

/// The text in single quotes for a POSIX shell if it needs them.
std::string shell_quoted(const std::string& text);

/// "a, b, c".
std::string joined(const List<std::string>& words, std::string_view between);

}  // namespace cairn
