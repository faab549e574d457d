// Reads the columns of a table.
#include "lessons/kit/text_table.hpp"

#include <algorithm>
#include <cstddef>

#include "lessons/kit/words.hpp"

namespace cairn {
namespace {

/// A line, one string for each column of the terminal: a letter with its combining marks and colours.
using Glyphs = List<std::string>;

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80; }

Glyphs glyphs_of(std::string_view line) {
  Glyphs glyphs;
  std::string color;  // of the next letter
  for (std::size_t at = 0; at < line.size();) {
    const bool is_color = line[at] == '\x1b';
    std::size_t end = at + 1;
    if (is_color) end = std::min(line.find('m', at), line.size() - 1) + 1;
    while (!is_color && end < line.size() && continues(line[end])) ++end;
    const std::string part(line.substr(at, end - at));
    at = end;
    if (is_color && (part != "\x1b[0m" || glyphs.empty())) {
      color += part;
    } else if (is_color || display_width(part) == 0) {
      if (glyphs.empty()) glyphs.push_back("");
      glyphs.back() += part;
    } else {
      glyphs.push_back(color + part);
      color.clear();
    }
  }
  return glyphs;
}

std::string joined_glyphs(const Glyphs& glyphs, int begin, int end) {
  std::string text;
  for (int i = begin; i < std::min(end, glyphs.size()); ++i) text += glyphs[i];
  return text;
}

bool is_blank(const Glyphs& line, int at) { return at >= line.size() || line[at] == " "; }

/// Without those that have few cells, such as "...  (20 more rows)": they may cross the columns.
List<Glyphs> typical(const List<std::string>& lines) {
  List<int> counts;
  for (const std::string& line : lines) counts.push_back(cell_count(line));
  std::nth_element(counts.begin(), counts.begin() + counts.size() / 2, counts.end());
  const int median = counts[counts.size() / 2];
  List<Glyphs> kept;
  for (const std::string& line : lines)
    if (2 * cell_count(line) > median) kept.push_back(glyphs_of(line));
  return kept;
}

bool is_gap(const List<Glyphs>& lines, int at) {
  return std::all_of(lines.begin(), lines.end(), [at](const Glyphs& line) { return is_blank(line, at); });
}

/// Whether numbers end in front of a blank, and words above them: then it parts two columns by itself.
bool is_behind_numbers(const List<Glyphs>& lines, int at) {
  const auto ends_there = [at](const Glyphs& line) { return !is_blank(line, at - 1); };
  const auto is_digit = [at](const Glyphs& line) {
    const char last = line[at - 1].empty() ? ' ' : line[at - 1].back();
    return last >= '0' && last <= '9';
  };
  return at > 0 && lines.size() > 2 && std::all_of(lines.begin(), lines.end(), ends_there) &&
         std::any_of(lines.begin(), lines.end(), is_digit);
}

List<Column> columns_of(const List<Glyphs>& lines) {
  int widest = 0;
  for (const Glyphs& line : lines) widest = std::max(widest, line.size());
  List<Column> columns;
  int blanks = 0;
  for (int at = 0; at < widest; ++at) {
    if (is_gap(lines, at)) {
      ++blanks;
    } else if (columns.empty() || blanks > 1 || (blanks == 1 && is_behind_numbers(lines, at - 1))) {
      columns.push_back({.begin = at, .end = at + 1, .gap = blanks});
      blanks = 0;
    } else {
      columns.back().end = at + 1;
      blanks = 0;
    }
  }
  return columns;
}

bool crosses(const Glyphs& line, const List<Column>& columns) {
  int begin = 0;
  for (const Column& column : columns) {
    for (int at = begin; at < column.begin; ++at)
      if (!is_blank(line, at)) return true;
    begin = column.end;
  }
  return false;
}

Cell cell_of(const Glyphs& line, const Column& column, bool plain) {
  int begin = column.begin;
  int end = std::min(column.end, line.size());
  while (begin < end && is_blank(line, begin)) ++begin;
  while (end > begin && is_blank(line, end - 1)) --end;
  Cell cell = {.text = joined_glyphs(line, begin, end), .indent = begin - column.begin};
  if (plain) cell.text = transliterated(cell.text);
  cell.is_right = end == column.end && cell.indent > 0;
  cell.fills = end == column.end && cell.indent == 0 && begin < end;
  if (cell.is_right || cell.text.empty()) cell.indent = 0;
  return cell;
}

}  // namespace

int width_of(std::string_view text) { return glyphs_of(text).size(); }

int cell_count(std::string_view text) {
  const Glyphs line = glyphs_of(text);
  int cells = 0;
  for (int at = 0; at < line.size(); ++at) {
    const bool begins = at == 0 || (is_blank(line, at - 1) && (at == 1 || is_blank(line, at - 2)));
    cells += !is_blank(line, at) && begins ? 1 : 0;
  }
  return cells;
}

TextTable text_table(const List<std::string>& texts, bool plain) {
  List<Glyphs> lines;
  for (const std::string& text : texts) lines.push_back(glyphs_of(text));
  TextTable table = {.columns = columns_of(typical(texts))};
  for (int i = 0; i < lines.size(); ++i) {
    table.rows.push_back({});
    table.lines.push_back(plain ? transliterated(texts[i]) : texts[i]);
    if (crosses(lines[i], table.columns)) continue;
    for (Column& column : table.columns) {
      table.rows.back().push_back(cell_of(lines[i], column, plain));
      const Cell& cell = table.rows.back().back();
      column.width = std::max(column.width, cell.indent + width_of(cell.text));
    }
  }
  // What fills a column of numbers ends where they end.
  for (int i = 0; i < table.columns.size(); ++i) {
    const bool has_right = std::any_of(table.rows.begin(), table.rows.end(), [i](const List<Cell>& row) {
      return !row.empty() && row[i].is_right;
    });
    for (List<Cell>& row : table.rows)
      if (!row.empty()) row[i].is_right = row[i].is_right || (has_right && row[i].fills);
  }
  return table;
}

}  // namespace cairn
