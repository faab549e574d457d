// What is around a letter decides whether it is a variable.
#include "render/variables.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "render/markup.hpp"

namespace cairn::render {
namespace {

constexpr char32_t nothing = 0;  // stands at both ends of a text

bool is_latin(char32_t sign) { return (sign >= U'a' && sign <= U'z') || (sign >= U'A' && sign <= U'Z'); }
bool is_small_greek(char32_t sign) { return sign >= U'α' && sign <= U'ω'; }
bool is_digit(char32_t sign) { return sign >= U'0' && sign <= U'9'; }
bool is_one_of(char32_t sign, std::u32string_view signs) { return signs.find(sign) != signs.npos; }

/// A sub- or superscript of Unicode.
bool is_raised_or_lowered(char32_t sign) {
  return is_one_of(sign, U"¹²³") || (sign >= U'⁰' && sign <= U'ₜ') || (sign >= U'ᴬ' && sign <= U'ᵪ');
}

bool is_operator(char32_t sign) { return is_one_of(sign, U"=+−×/≤≥<>≠≈←±|½√ΔΣ") || is_small_greek(sign); }

char32_t first_of(std::string_view text) { return text.empty() ? nothing : take_code_point(text); }

/// Where the last code point of a text begins that is not empty.
std::size_t start_of_last(std::string_view text) {
  std::size_t start = text.size() - 1;
  while (start > 0 && (static_cast<unsigned char>(text[start]) & 0xC0U) == 0x80U) --start;
  return start;
}

char32_t last_of(std::string_view text) {
  return text.empty() ? nothing : first_of(text.substr(start_of_last(text)));
}

bool is_space(char32_t sign) { return is_one_of(sign, U" \u00A0"); }

std::string_view without_spaces_in_front(std::string_view text) {
  while (is_space(first_of(text))) take_code_point(text);
  return text;
}

std::string_view without_spaces_at_end(std::string_view text) {
  while (is_space(last_of(text))) text = text.substr(0, start_of_last(text));
  return text;
}

std::string_view last_word_of(std::string_view text) {
  text = without_spaces_at_end(text);
  std::size_t start = text.size();
  while (start > 0 && !is_space(last_of(text.substr(0, start))) && text[start - 1] != '(')
    start = start_of_last(text.substr(0, start));
  return text.substr(start);
}

bool ends_with_any(std::string_view text, std::span<const std::string_view> words) {
  const std::string_view last = last_word_of(text);
  return std::find(words.begin(), words.end(), last) != words.end();
}

/// "0.5", "(3, 4)", "10⁻⁵" or "10^{−5}".
bool ends_with_number(std::string_view text) {
  if (text.ends_with('}')) return text.substr(0, text.rfind('{')).ends_with("10^");
  while (is_raised_or_lowered(last_of(text))) text = text.substr(0, start_of_last(text));
  return is_digit(last_of(text)) || is_one_of(last_of(text), U")?");
}

/// m, s, N, J and W where they stand behind a number, another unit or in brackets of their own.
bool is_unit(std::string_view before, char32_t sign, std::string_view behind) {
  constexpr std::array<std::string_view, 8> units = {"kg", "N", "J", "m", "rad", "mm", "in", "1/kg"};
  if (!is_one_of(sign, U"msNJW")) return false;
  if ((sign == U'm' && behind.starts_with("/s")) || (sign == U's' && before.ends_with('/'))) return true;
  if (before.ends_with("N/") || before.ends_with("N s/")) return true;
  if (before.ends_with('(')) {
    before.remove_suffix(1);
    if (!before.empty() && !is_space(last_of(before))) return false;  // max(m, 1)
    const char32_t next = first_of(without_spaces_in_front(behind));
    return next == U'/' || !is_operator(next);
  }
  return is_space(last_of(before)) &&
         (ends_with_number(without_spaces_at_end(before)) || ends_with_any(before, units));
}

/// Whether a sign of a formula stands beside the letter.
bool is_in_formula(std::string_view before, std::string_view behind) {
  const char32_t after = first_of(behind);
  if (is_one_of(after, U"_^·") || is_raised_or_lowered(after) || before.ends_with("·")) return true;
  std::string_view next = without_spaces_in_front(behind);
  if (is_operator(first_of(next)) || is_operator(last_of(without_spaces_at_end(before)))) return true;
  if (!is_latin(first_of(next))) return false;
  take_code_point(next);
  return is_one_of(first_of(next), U"_^") ||
         (is_space(first_of(next)) && is_operator(first_of(without_spaces_in_front(next))));
}

/// The t of dc/dt: behind a d that is all of a word, beside a fraction bar.
bool is_derived(std::string_view before, std::string_view behind) {
  if (!before.ends_with('d') || is_latin(first_of(behind))) return false;
  before.remove_suffix(1);
  return !is_latin(last_of(before)) && (behind.starts_with('/') || before.ends_with('/'));
}

/// Whether the letter is part of a word, a number such as 3D, or a name such as x10.
bool is_in_word(std::string_view before, char32_t sign, std::string_view behind) {
  const char32_t last = last_of(before), first = first_of(behind);
  if ((is_digit(last) && sign < U'a') || (last == U'μ' && is_one_of(sign, U"ms"))) return true;
  const bool goes_on = behind.size() > 1 && first == U'.' && behind[1] != ' ';
  return is_latin(last) || is_latin(first) || is_digit(first) || goes_on || is_one_of(last, U"-_.'’\"") ||
         is_one_of(first, U"-'’\"");
}

/// "a box", "A box": a word follows.
bool is_article(char32_t sign, std::string_view behind) {
  const std::string_view word = is_space(first_of(behind)) ? without_spaces_in_front(behind) : "";
  return is_one_of(sign, U"aA") && word.size() > 1 && is_latin(first_of(word)) &&
         is_latin(first_of(word.substr(1)));
}

/// Neither at the beginning of a sentence nor the name of a body or panel.
bool is_in_sentence(std::string_view before) {
  constexpr std::array<std::string_view, 4> named = {"body", "box", "panel", "and"};
  const char32_t last = last_of(without_spaces_at_end(before));
  return last != nothing && !is_one_of(last, U".?!:;,·") && !ends_with_any(before, named);
}

}  // namespace

bool is_variable(std::string_view before, char32_t sign, std::string_view behind) {
  constexpr std::array<std::string_view, 5> bodies = {"body", "box", "bodies", "boxes", "and"};
  if (is_small_greek(sign)) return sign != U'μ' || !is_one_of(first_of(behind), U"ms");
  if (is_derived(before, behind)) return true;
  if (!is_latin(sign) || is_in_word(before, sign, behind) || is_unit(before, sign, behind)) return false;
  if (is_article(sign, behind)) return sign == U'A' && is_in_sentence(before);
  if (is_in_formula(before, behind)) return true;
  if (sign >= U'a') return sign != U'a' && (sign != U'b' || !ends_with_any(before, bodies));
  return sign == U'A' ? is_in_sentence(before) : sign == U'J' && last_word_of(before) == "of";
}

}  // namespace cairn::render
