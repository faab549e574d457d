// Judges claims and sets them in columns.
#include "lessons/kit/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/kit/fitting.hpp"
#include "lessons/kit/words.hpp"

namespace cairn {
namespace {

constexpr int value_column = 82;
constexpr int value_width = 9;
constexpr int verdict_width = 7;

}  // namespace

std::string short_number(double value) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{}", value == 0 ? 0.0 : value);
  const double size = std::abs(value);
  if (size < 1e-3 || size >= 1e5) return fmt::format("{:.1e}", value);
  std::string text = fmt::format("{:#.4g}", value);
  if (text.find('e') != std::string::npos) text = fmt::format("{:.0f}", value);
  if (text.back() == '.') text.pop_back();
  return text;
}

Claim small_claim(std::string_view text, double value, double limit) {
  // Written so that a value that is not a number fails.
  const bool holds = std::abs(value) <= limit;
  return {.text = std::string(text),
          .shown = short_number(value),
          .holds = holds,
          .demand = fmt::format("at most {}", limit),
          .value = value};
}

Claim equal_claim(std::string_view text, double value, double expected, double tolerance) {
  const bool holds = std::abs(value - expected) <= tolerance;
  return {.text = std::string(text),
          .shown = short_number(value),
          .holds = holds,
          .demand = fmt::format("{} within {}", expected, tolerance),
          .value = value};
}

Claim plain_claim(std::string_view text, bool holds, std::string_view shown) {
  return {.text = std::string(text), .shown = std::string(shown), .holds = holds, .value = holds ? 1.0 : 0.0};
}

std::string claim_line(const Claim& claim, int width) {
  const int behind = std::max(value_width, display_width(claim.shown)) + 2 + verdict_width;
  const int room = std::min(value_column - 1, width - behind);
  const bool is_whole = width == unlimited;  // programs read it line by line
  const std::string text = wrapped("CHECK  " + claim.text, is_whole ? width : room - 3, 7) + " ";
  const int dots = std::max(2, room - display_width(text.substr(text.rfind('\n') + 1)));
  return text + repeated('.', dots) + " " + padded(claim.shown, value_width) + " ";
}

std::string numbers_text(const List<double>& numbers) {
  List<std::string> words;
  for (const double number : numbers) words.push_back(with_minus_signs(short_number(number)));
  return joined(words, ", ");
}

namespace {

/// Why a guess is wrong, for one that is known; "" for all others.
std::string reason_of(const List<double>& guess, const List<WrongGuess>& known) {
  for (const WrongGuess& wrong : known) {
    bool is_among = guess.size() == wrong.least.size();
    for (int i = 0; is_among && i < guess.size(); ++i)
      is_among = guess[i] >= wrong.least[i] && guess[i] <= wrong.most[i];
    if (is_among) return wrong.why;
  }
  return "";
}

}  // namespace

Judgement judged(const List<double>& guess, const List<double>& right, double tolerance,
                 const List<WrongGuess>& known) {
  if (guess.size() != right.size()) {
    return {
        .words = fmt::format(
            "NOT YET  you said {} number{}, and the question asks for {}: a comma stands between numbers, a "
            "point before decimals; it is ",
            guess.size(), guess.size() == 1 ? "" : "s", right.size())};
  }
  for (int i = 0; i < right.size(); ++i) {
    const bool is_near = std::abs(guess[i] - right[i]) <= tolerance;
    if (is_near || short_number(guess[i]) == short_number(right[i])) continue;
    const std::string why = reason_of(guess, known), said = "NOT YET  you said " + numbers_text(guess);
    return {.words = why.empty() ? said + "; it is " : said + ". " + why + " It is "};
  }
  return {.is_right = true, .words = "RIGHT    "};
}

int holding(const List<Claim>& claims) {
  return static_cast<int>(
      std::count_if(claims.begin(), claims.end(), [](const Claim& claim) { return claim.holds; }));
}

}  // namespace cairn
