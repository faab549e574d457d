// Tables in plain text: columns as wide as their widest cell.
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <stdexcept>

namespace cairn::bench {

void TextTable::add(List<std::string> cells) {
  if (cells.size() != columns_.size()) {
    throw std::logic_error(
        fmt::format("TextTable::add: cells must be {}, got {}", columns_.size(), cells.size()));
  }
  rows_.push_back(std::move(cells));
}

std::string TextTable::text() const {
  List<std::string> names, units;
  for (const Column& column : columns_) {
    names.push_back(column.name);
    units.push_back(column.unit);
  }
  List<List<std::string>> lines = {names, units};
  lines.insert(lines.end(), rows_.begin(), rows_.end());

  List<std::size_t> width(columns_.size(), 0);
  for (const auto& line : lines) {
    for (int i = 0; i < line.size(); ++i) width[i] = std::max(width[i], line[i].size());
  }
  std::string text;
  for (int number = 0; number < lines.size(); ++number) {
    if (number == 2) {
      std::size_t whole = 0;
      for (const std::size_t one : width) whole += one + 2;
      text += "  " + std::string(whole - 2, '-') + "\n";
    }
    for (int i = 0; i < width.size(); ++i) {
      const std::string& cell = lines[number][i];
      text += i == 0 ? fmt::format("  {:<{}}", cell, width[i]) : fmt::format("  {:>{}}", cell, width[i]);
    }
    text += "\n";
  }
  return text;
}

void print_heading(const std::string& text) {
  fmt::print("\n{}\n{}\n\n", text, std::string(text.size(), '='));
}

std::string grouped(std::ptrdiff_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  std::ptrdiff_t left = std::ssize(digits);
  for (const char digit : digits) {
    if (!text.empty() && left % 3 == 0) text += ' ';
    text += digit;
    --left;
  }
  return text;
}

std::string three_digits(double number) {
  if (!std::isfinite(number)) return fmt::format("{}", number);
  const double size = std::abs(number);
  if (size != 0 && (size < 1e-3 || size >= 1e6)) return fmt::format("{:.1e}", number);
  if (size < 10) return fmt::format("{:.2f}", number);
  return size < 100 ? fmt::format("{:.1f}", number) : fmt::format("{:.0f}", number);
}

}  // namespace cairn::bench
