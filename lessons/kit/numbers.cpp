// Short forms of numbers.
#include "lessons/kit/numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/page.hpp"

namespace cairn {

double cleaned(double value) { return std::abs(value) < 1e-9 ? 0 : value; }

std::string brief(double value, int most) {
  std::string text = render::fixed(value, most);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string in_brackets(const std::string& number) {
  return number.starts_with("−") ? "(" + number + ")" : number;
}

std::string spaced(double number) {
  std::string digits = fmt::format("{:.0f}", number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, "\u00a0");
  return digits;
}

}  // namespace cairn
