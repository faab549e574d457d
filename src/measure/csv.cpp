// Floor 6. CSV.
#include "measure/csv.hpp"

#include <fmt/format.h>

#include <ostream>

#include "math/check.hpp"

namespace cairn {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

std::string text_of(const CsvCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return quoted(*text);
  if (const auto* number = std::get_if<long long>(&cell)) return fmt::format("{}", *number);
  return fmt::format("{:.17g}", std::get<double>(cell));
}

void write_line(std::ostream& out, const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) out << (i > 0 ? "," : "") << cells[i];
  out << '\n';
}

}  // namespace

void write_csv(std::ostream& out, const CsvTable& table) {
  std::vector<std::string> cells;
  for (const std::string& name : table.header) cells.push_back(quoted(name));
  write_line(out, cells);
  for (const std::vector<CsvCell>& row : table.rows) {
    require(row.size() == table.header.size(), "write_csv", "row", "as long as the header",
            static_cast<double>(row.size()));
    cells.clear();
    for (const CsvCell& cell : row) cells.push_back(text_of(cell));
    write_line(out, cells);
  }
}

}  // namespace cairn
