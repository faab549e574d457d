// The columns of a table that was printed, read from where its lines are blank.
#pragma once

#include <string>
#include <string_view>

#include <cairn/math/list.hpp>

namespace cairn {

/// The columns of a terminal that a text takes; its colours take none.
int width_of(std::string_view text);

struct Cell {
  std::string text = {};
  int indent = 0;  // of its first letter in the column
  bool is_right = false;
  bool fills = false;  // the column as it was printed
};

struct Column {
  int begin = 0;
  int end = 0;
  int gap = 0;    // before it
  int width = 0;  // of the widest cell as it is spelt
};

struct TextTable {
  List<Column> columns = {};
  List<List<Cell>> rows = {};  // one without cells is a line that crosses the columns
  List<std::string> lines = {};
};

/// How many groups of words a line has, with two blanks or more between them.
int cell_count(std::string_view line);

/// The columns of these lines. With `plain` each cell is spelt in ASCII.
TextTable text_table(const List<std::string>& lines, bool plain);

}  // namespace cairn
