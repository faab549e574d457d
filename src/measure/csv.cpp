// Floor 6. CSV.
#include <cairn/measure/csv.hpp>

#include <fmt/format.h>

#include <charconv>
#include <istream>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

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

/// One cell as it was written: quotes tell text that looks like a number.
struct RawCell {
  std::string text = {};
  bool was_quoted = false;
};

template <typename Number>
bool read_whole(const std::string& text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end;
}

CsvCell cell_of(const RawCell& raw) {
  long long whole = 0;
  double number = 0;
  if (!raw.was_quoted && read_whole(raw.text, whole)) return whole;
  if (!raw.was_quoted && read_whole(raw.text, number)) return number;
  return raw.text;
}

/// The next record, which may go over several lines; nothing at the end of the input.
std::optional<List<RawCell>> next_record(std::istream& in, const std::string& name, int& line) {
  if (in.peek() == std::istream::traits_type::eof()) return std::nullopt;
  ++line;
  List<RawCell> cells(1);
  bool inside = false;
  for (char c = 0; in.get(c);) {
    RawCell& cell = cells.back();
    if (inside && c == '"' && in.peek() == '"') {
      cell.text += '"';
      in.get(c);
    } else if (c == '"') {
      inside = !inside;
      cell.was_quoted = true;
    } else if (!inside && c == ',') {
      cells.emplace_back();
    } else if (!inside && c == '\n') {
      return cells;
    } else {
      line += c == '\n' ? 1 : 0;
      cell.text += c;
    }
  }
  throw std::invalid_argument(name + ": line " + std::to_string(line) +
                              ": a line must end with a line break, and a quote with a quote");
}

}  // namespace

std::string csv_line(const List<CsvCell>& row) {
  std::string line;
  for (int i = 0; i < row.size(); ++i) line += (i > 0 ? "," : "") + text_of(row[i]);
  return line;
}

void write_csv(std::ostream& out, const CsvTable& table) {
  out << csv_line({table.header.begin(), table.header.end()}) << '\n';
  for (const List<CsvCell>& row : table.rows) {
    require(row.size() == table.header.size(), "write_csv", "row", "as long as the header",
            static_cast<double>(row.size()));
    out << csv_line(row) << '\n';
  }
}

CsvTable read_csv(std::istream& in, const std::string& name) {
  CsvTable table;
  int line = 0;
  while (const std::optional<List<RawCell>> record = next_record(in, name, line)) {
    if (table.header.empty()) {
      for (const RawCell& cell : *record) table.header.push_back(cell.text);
      continue;
    }
    require(record->size() == table.header.size(), name, "line " + std::to_string(line),
            "of as many cells as the header, " + std::to_string(table.header.size()),
            static_cast<double>(record->size()));
    List<CsvCell>& row = table.rows.emplace_back();
    for (const RawCell& cell : *record) row.push_back(cell_of(cell));
  }
  return table;
}

}  // namespace cairn
