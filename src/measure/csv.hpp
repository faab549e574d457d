// Floor 6. Tables as CSV: a header line, then rows; numbers with all their digits.
#pragma once

#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace cairn {

using CsvCell = std::variant<std::string, long long, double>;

struct CsvTable {
  std::vector<std::string> header = {};
  std::vector<std::vector<CsvCell>> rows = {};
};

/// Writes doubles with 17 significant digits, so that they read back bit-equal, and quotes text that holds a
/// comma, a quote or a line break. Ends lines with \n.
/// @throws std::invalid_argument when a row has not as many cells as the header.
void write_csv(std::ostream& out, const CsvTable& table);

}  // namespace cairn
