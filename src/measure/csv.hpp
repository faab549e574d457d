// Floor 6. Tables as CSV: a header line, then rows; numbers with all their digits.
#pragma once

#include <iosfwd>
#include <string>
#include <variant>

#include <cairn/math/list.hpp>

namespace cairn {

/// Text, a whole number or any other number.
using CsvCell = std::variant<std::string, long long, double>;

/// A table with a name for each column.
struct CsvTable {
  List<std::string> header = {};  // of the columns
  List<List<CsvCell>> rows = {};  // each with as many cells as the header
};

/// Writes doubles with 17 significant digits, so that they read back bit-equal, and quotes text that holds a
/// comma, a quote or a line break. Ends every line with a line feed.
/// @throws std::invalid_argument when a row has not as many cells as the header.
void write_csv(std::ostream& out, const CsvTable& table);

/// One line of write_csv, without its line feed.
std::string csv_line(const List<CsvCell>& row);

/// What write_csv has written: whole numbers, then other numbers, are read as such, everything else as text.
/// `name` is for messages. @throws std::invalid_argument that names line and rule.
CsvTable read_csv(std::istream& in, const std::string& name);

}  // namespace cairn
