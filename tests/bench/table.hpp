// Tables in plain text, for a terminal.
#pragma once

#include <cstddef>
#include <string>

#include <cairn/math/list.hpp>

namespace cairn::bench {

/// A column: its name, and the unit of what stands in it.
struct Column {
  std::string name = {};
  std::string unit = {};
};

/// The first column is aligned left, the others right. Every row has a cell for each column.
class TextTable {
 public:
  explicit TextTable(List<Column> columns) : columns_(std::move(columns)) {}

  void add(List<std::string> cells);
  /// Names, units, a rule, and the rows.
  std::string text() const;

 private:
  List<Column> columns_;
  List<List<std::string>> rows_;
};

/// A heading that stands out between tables.
void print_heading(const std::string& text);

/// 1234567 as "1 234 567".
std::string grouped(std::ptrdiff_t number);

/// Three significant digits, without an exponent where the number is of common size.
std::string three_digits(double number);

}  // namespace cairn::bench
