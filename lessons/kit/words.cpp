// Reading numbers, comparing words, spelling Greek out.
#include "lessons/kit/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>

namespace cairn {
namespace {

constexpr std::string_view minus = "−";

std::optional<double> parse_decimal(std::string_view typed) {
  // A number as it was printed is one that may be typed.
  const bool printed = typed.starts_with(minus);
  const std::string ascii = printed ? "-" + std::string(typed.substr(minus.size())) : std::string(typed);
  std::string_view text = ascii;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// The code point that begins at `at`, which moves behind it. Broken UTF-8 gives U+FFFD.
std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
  std::uint32_t code = lead & (0x3Fu >> more);
  if (more == 0) return 0xFFFD;
  for (int i = 0; i < more; ++i, ++at) {
    if (at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0u) != 0x80) return 0xFFFD;
    code = code << 6 | (static_cast<unsigned char>(text[at]) & 0x3Fu);
  }
  return code;
}

enum class Script { line, raised, lowered, word };

struct Spelling {
  Script script = Script::line;
  std::string text = {};
};

using Spellings = std::map<std::uint32_t, Spelling>;

void add_letters(Spellings& spellings, Script script, std::u32string_view letters, std::string_view ascii) {
  for (std::size_t i = 0; i < letters.size(); ++i) {
    spellings[letters[i]] = {.script = script, .text = std::string(1, ascii[i])};
  }
}

Spellings make_spellings() {
  Spellings spellings;
  const std::map<std::uint32_t, std::string> words = {
      {U'α', "alpha"}, {U'β', "beta"},  {U'γ', "gamma"}, {U'δ', "delta"},  {U'ε', "epsilon"},
      {U'ζ', "zeta"},  {U'η', "eta"},   {U'θ', "theta"}, {U'κ', "kappa"},  {U'λ', "lambda"},
      {U'μ', "mu"},    {U'ν', "nu"},    {U'ξ', "xi"},    {U'π', "pi"},     {U'ρ', "rho"},
      {U'σ', "sigma"}, {U'τ', "tau"},   {U'φ', "phi"},   {U'ψ', "psi"},    {U'ω', "omega"},
      {U'Σ', "sum"},   {U'Ω', "Omega"}, {U'Φ', "Phi"},   {U'Λ', "Lambda"}, {U'√', "sqrt"},
      {U'∞', "inf"},   {U'∑', "sum"}};
  for (const auto& [code, text] : words) spellings[code] = {.script = Script::word, .text = text};
  // A step is spelt like the flag: Δt is dt.
  const std::map<std::uint32_t, std::string> signs = {
      {U'Δ', "d"},         {U'∂', "d"},      {U'·', "."},         {U'⋅', "."},      {U'×', "x"},
      {U'−', "-"},         {U'–', "-"},      {U'—', "--"},        {U'±', "+-"},     {U'≤', "<="},
      {U'≥', ">="},        {U'≠', "!="},     {U'≈', "~"},         {U'≡', "=="},     {U'→', "->"},
      {U'←', "<-"},        {U'⇒', "=>"},     {U'↑', "^"},         {U'↓', "v"},      {U'°', " deg"},
      {U'…', "..."},       {U'µ', "u"},      {U'½', "1/2"},       {U'⅓', "1/3"},    {U'¼', "1/4"},
      {U'¾', "3/4"},       {U'∈', " in "},   {U'∝', "~"},         {U'“', "\""},     {U'”', "\""},
      {U'‘', "'"},         {U'’', "'"},      {U'′', "'"},         {U'\u00A0', " "}, {U'─', "-"},
      {U'│', "|"},         {U'█', "#"},      {U'•', "*"},         {U'✓', "ok"},     {U'✗', "FAILED"},
      {U'ċ', "c'"},        {U'ẋ', "x'"},     {U'ẏ', "y'"},        {U'λ', "lambda"}, {U'\u0304', "_bar"},
      {U'\u0305', "_bar"}, {U'\u0307', "'"}, {U'\u0302', "_hat"}, {U'∆', "d"},      {U'⟨', "<"},
      {U'⟩', ">"},         {U'‖', "||"},     {U'∥', "||"},        {U'é', "e"},      {U'∓', "-+"}};
  for (const auto& [code, text] : signs) spellings.try_emplace(code, Spelling{.text = text});
  add_letters(spellings, Script::raised, U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵀᵏⁿⁱˡ", "0123456789+-=()Tknil");
  add_letters(spellings, Script::lowered, U"₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ",
              "0123456789+-=()aehijklmnoprstuvx");
  return spellings;
}

Spelling spelling_of(std::uint32_t code) {
  static const Spellings spellings = make_spellings();
  if (code < 0x80) return {.text = std::string(1, static_cast<char>(code))};
  const auto found = spellings.find(code);
  return found == spellings.end() ? Spelling{.text = "?"} : found->second;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text);
  const std::optional<double> numerator = parse_decimal(text.substr(0, slash));
  const std::optional<double> denominator = parse_decimal(text.substr(slash + 1));
  if (!numerator || !denominator || !std::isfinite(*numerator / *denominator)) return {};
  return *numerator / *denominator;
}

std::optional<List<double>> parse_numbers(std::string_view text) {
  List<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view word = text.substr(begin, end - begin);
    while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
    while (!word.empty() && (word.back() == ' ' || word.back() == '\r')) word.remove_suffix(1);
    const std::optional<double> number = parse_number(word);
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

std::string transliterated(std::string_view text) {
  std::string result;
  Script before = Script::line;
  for (std::size_t at = 0; at < text.size();) {
    const Spelling spelling = spelling_of(next_code_point(text, at));
    const bool begins = spelling.script != before;
    if (spelling.script == Script::raised && begins) result += '^';
    if (spelling.script == Script::lowered && begins) result += '_';
    // Words keep a distance from letters, so that λΔt reads "lambda dt".
    const bool touches_word = before == Script::word && !spelling.text.empty() &&
                              is_letter(spelling.text[0]) &&
                              (spelling.script == Script::line || spelling.script == Script::word);
    const bool touches_letter =
        spelling.script == Script::word && !result.empty() && begins &&
        (is_letter(result.back()) || before == Script::raised || before == Script::lowered);
    if (touches_word || touches_letter) result += ' ';
    result += spelling.text;
    before = spelling.script;
  }
  return result;
}

std::string with_minus_signs(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || std::string_view(" ([=,").find(text[i - 1]) != std::string_view::npos;
    const bool is_number = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    if (text[i] == '-' && begins && is_number) {
      result += minus;
    } else {
      result += text[i];
    }
  }
  return result;
}

int display_width(std::string_view text) {
  int width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t code = next_code_point(text, at);
    width += code >= 0x300 && code < 0x370 ? 0 : 1;
  }
  return width;
}

std::string repeated(char character, int count) {
  return std::string(static_cast<std::size_t>(count), character);
}

std::string padded(std::string_view text, int width) {
  return std::string(text) + repeated(' ', std::max(0, width - display_width(text)));
}

std::string wrapped(std::string_view text, int width, int indent) {
  std::string result;
  std::string line;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word(text.substr(begin, end - begin));
    if (!line.empty() && display_width(line) + 1 + display_width(word) > width) {
      result += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
      line = repeated(' ', indent) + word;
    } else {
      line += (begin == 0 ? "" : " ") + word;
    }
    begin = end + 1;
  }
  return result + line;
}

std::string shell_quoted(const std::string& text) {
  const std::string safe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+@%";
  if (!text.empty() && text.find_first_not_of(safe) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string joined(const List<std::string>& words, std::string_view between) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : std::string(between)) + word;
  return result;
}

}  // namespace cairn
