// Blocks of formulas: rows of cells, side by side as their writer set them.
#include <algorithm>
#include <sstream>

#include "lessons/driver/book_glyphs.hpp"
#include "lessons/driver/book_math.hpp"
#include "lessons/driver/book_text.hpp"
#include "math/list.hpp"

namespace cairn::driver {
namespace {

struct Cell {
  int column = 0;  // of its first character
  std::string text = {};
};

/// Cells of a line: two blanks or more part them.
List<Cell> cells_of(const std::string& line) {
  List<Cell> cells;
  for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos;) {
    const std::size_t end = std::min(line.find("  ", at), line.size());
    cells.push_back({.column = glyphs_of(line.substr(0, at)).size(), .text = line.substr(at, end - at)});
    at = line.find_first_not_of(' ', end);
  }
  return cells;
}

/// "(22)", "4.3": the number of an equation or a section, at the front of a line.
bool is_tag(const std::string& text) {
  const bool is_bracketed = text.size() > 2 && text.front() == '(' && text.back() == ')';
  return (is_bracketed && text.find_first_not_of("0123456789()") == std::string::npos) ||
         (text.size() == 3 && text[1] == '.' && text.find_first_not_of("0123456789.") == std::string::npos);
}

std::string cell_html(const Cell& cell, bool& has_formula, const SymbolPages& symbols) {
  if (is_tag(cell.text)) return "<span class=\"tag\">" + cell.text + "</span>";
  const std::optional<std::string> math = math_of(cell.text, symbols);
  has_formula = has_formula || math;
  return "<span>" + (math ? *math : escaped(cell.text)) + "</span>";
}

}  // namespace

std::optional<std::string> formula_block(const std::string& block, const SymbolPages& symbols) {
  std::istringstream lines(block);
  std::string rows;
  bool has_formula = false;
  int second_column = 0;  // of the line before: where a line may begin that leaves its first cell empty
  for (std::string line; std::getline(lines, line);) {
    const List<Cell> cells = cells_of(line);
    if (cells.empty()) continue;
    const bool is_numbered = cells[0].text.find_first_not_of("0123456789") == std::string::npos;
    const bool is_indented = cells[0].column > 0;
    if (is_numbered || (is_indented && cells[0].column != second_column)) return {};
    std::string row = is_indented ? "<span></span>" : "";
    for (const Cell& cell : cells) row += cell_html(cell, has_formula, symbols);
    rows += "<div>" + row + "</div>\n";
    if (!is_indented) second_column = cells.size() > 1 ? cells[1].column : 0;
  }
  if (!has_formula) return {};
  return "<div class=\"formula\" tabindex=\"0\" role=\"group\" aria-label=\"Formula\">\n" + rows + "</div>";
}

}  // namespace cairn::driver
