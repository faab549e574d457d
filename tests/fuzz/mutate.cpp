// Changes of bytes, of numbers, of words and of lines.
#include "fuzz/mutate.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "geometry/random_shapes.hpp"

namespace cairn::fuzz {

namespace {

using test::Random;

const std::size_t longest_input = 200000;  // [bytes]

std::size_t place_in(const std::string& text, Random& random) {
  return static_cast<std::size_t>(random.below(std::max(static_cast<int>(text.size()), 1)));
}

const std::string& one_of(const List<std::string>& texts, Random& random) {
  return texts[random.below(texts.size())];
}

/// The shortest of three: more inputs in the same time.
const std::string& short_one_of(const List<std::string>& texts, Random& random) {
  int best = random.below(texts.size());
  for (int i = 0; i < 2; ++i) {
    const int other = random.below(texts.size());
    if (texts[other].size() < texts[best].size()) best = other;
  }
  return texts[best];
}

/// Numbers at the edges of what doubles and integers hold, and texts that are nearly numbers.
const List<std::string>& edges() {
  static const List<std::string> numbers = {"nan",
                                            "inf",
                                            "-inf",
                                            "1e308",
                                            "-1e308",
                                            "1.8e308",
                                            "-0.0",
                                            "0",
                                            "-1",
                                            "1e-308",
                                            "5e-324",
                                            "1e15",
                                            "1e16",
                                            "1e-15",
                                            "1e154",
                                            "1e-154",
                                            "1e38",
                                            "1e39",
                                            "1e-40",
                                            "2147483647",
                                            "2147483648",
                                            "-2147483649",
                                            "9223372036854775807",
                                            "1e999",
                                            "\"inf\"",
                                            "\"-inf\"",
                                            "18446744073709551616",
                                            "0.1",
                                            "1",
                                            "2",
                                            "3",
                                            "100",
                                            "1e6",
                                            "1e7",
                                            "1e-6",
                                            "1e-12",
                                            "\"\"",
                                            "[]",
                                            "{}",
                                            "true",
                                            "1/0",
                                            "pi",
                                            "16777217",
                                            "4503599627370497",
                                            "0x7f",
                                            "1_000",
                                            "+1",
                                            "1e",
                                            "null"};
  return numbers;
}

/// A word, a number, or one other byte: where it begins and where it ends.
struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool joins_words(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '.' ||
         letter == '-' || letter == '+';
}

Token token_at(const std::string& text, std::size_t place) {
  Token token{place, std::min(place + 1, text.size())};
  if (text.empty() || !joins_words(text[place])) return token;
  while (token.begin > 0 && joins_words(text[token.begin - 1])) --token.begin;
  while (token.end < text.size() && joins_words(text[token.end])) ++token.end;
  return token;
}

Token line_at(const std::string& text, std::size_t place) {
  const std::size_t before = place == 0 ? std::string::npos : text.rfind('\n', place - 1);
  const std::size_t behind = text.find('\n', place);
  return {before == std::string::npos ? 0 : before + 1,
          behind == std::string::npos ? text.size() : behind + 1};
}

std::string text_of(const std::string& text, const Token& token) {
  return text.substr(token.begin, token.end - token.begin);
}

void change_bytes(std::string& text, Random& random) {
  const std::size_t place = place_in(text, random);
  const int kind = random.below(4);
  if (kind == 0 && !text.empty()) {
    text[place] = static_cast<char>(static_cast<unsigned char>(text[place]) ^ (1u << random.below(8)));
  } else if (kind == 1) {
    text.insert(std::min(place, text.size()), 1, static_cast<char>(random.below(256)));
  } else if (kind == 2) {
    text.erase(std::min(place, text.size()), static_cast<std::size_t>(1 + random.below(8)));
  } else {
    text.resize(place);  // the rest of the file was never written
  }
}

/// The next number behind a place becomes one at the edge, or a multiple of itself.
void change_number(std::string& text, Random& random) {
  const std::size_t place = text.find_first_of("0123456789", place_in(text, random));
  if (place == std::string::npos) return;
  Token token = token_at(text, place);
  const std::string before = text_of(text, token);
  const FixedList<const char*, 4> endings = {"0", "e3", "e-3", "00000"};
  const bool is_scaled = random.below(4) == 0;
  text.replace(token.begin, token.end - token.begin,
               is_scaled ? before + endings[random.below(endings.size())] : one_of(edges(), random));
}

/// A part is left out, is there twice, changes places with another, or comes from another input.
void change_parts(std::string& text, const std::string& other, bool whole_lines, Random& random) {
  const auto part = [&](const std::string& from) {
    const std::size_t place = place_in(from, random);
    return whole_lines ? line_at(from, place) : token_at(from, place);
  };
  const Token first = part(text);
  const int kind = random.below(4);
  if (kind == 0) text.erase(first.begin, first.end - first.begin);
  if (kind == 1) text.insert(first.end, text_of(text, first));
  if (kind == 2) {
    const Token second = part(text);
    if (second.begin < first.end) return;
    const std::string one = text_of(text, first), two = text_of(text, second);
    text.replace(second.begin, two.size(), one);
    text.replace(first.begin, one.size(), two);
  }
  if (kind == 3) text.replace(first.begin, first.end - first.begin, text_of(other, part(other)));
}

void splice(std::string& text, const std::string& other, Random& random) {
  const std::size_t end = place_in(text, random), begin = place_in(other, random);
  text = text.substr(0, end) + other.substr(std::min(begin, other.size()));
}

void change(std::string& text, const std::string& other, Random& random) {
  const int kind = random.below(10);
  if (kind < 2) change_bytes(text, random);
  if (kind >= 2 && kind < 6) change_number(text, random);
  if (kind >= 6 && kind < 8) change_parts(text, other, false, random);
  if (kind == 8) change_parts(text, other, true, random);
  if (kind == 9) splice(text, other, random);
  if (text.size() > longest_input) text.resize(longest_input);
}

}  // namespace

std::string input(const List<std::string>& seeds, std::uint64_t seed, std::uint64_t number) {
  if (std::cmp_less(number, seeds.size())) return seeds[static_cast<int>(number)];
  Random random(seed * 0x9e3779b97f4a7c15u + number);
  if (seeds.empty()) return {};
  std::string text = short_one_of(seeds, random);
  const int changes = 1 + random.below(4);
  for (int i = 0; i < changes; ++i) change(text, short_one_of(seeds, random), random);
  return text;
}

}  // namespace cairn::fuzz
