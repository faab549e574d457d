// Sets prose and tables at a width.
#include "lessons/kit/fitting.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>

#include "lessons/kit/text_table.hpp"
#include "lessons/kit/words.hpp"

namespace cairn {
namespace {

int gap_before(const TextTable& table, int column, int most) {
  const int gap = table.columns[column].gap;
  return column == 0 ? (most < unlimited ? std::min(gap, 2) : gap) : std::min(gap, most);
}

/// What the columns take with gaps of at most `most` between them.
int table_width(const TextTable& table, int most) {
  int width = 0;
  for (int i = 0; i < table.columns.size(); ++i) width += gap_before(table, i, most) + table.columns[i].width;
  return width;
}

/// Some columns of a table, set at one width.
struct Setting {
  List<int> columns = {};
  int most = unlimited;  // blanks between columns
  int width = unlimited;
  std::optional<int> last_width = {};  // the last column is wrapped to it
};

std::string set_row(const TextTable& table, const List<Cell>& row, const Setting& setting) {
  std::string line;
  int width = 0;
  for (const int i : setting.columns) {
    const Cell& cell = row[i];
    const int column = table.columns[i].width;
    const int before = cell.is_right ? column - width_of(cell.text) : cell.indent;
    width += gap_before(table, i, setting.most);
    if (!cell.text.empty()) line += repeated(' ', width + before - width_of(line)) + cell.text;
    width += column;
  }
  return line;
}

/// wrapped() counts a line from its first letter; here it begins behind other cells.
std::string wrapped_row(const TextTable& table, const List<Cell>& row, const Setting& setting) {
  Setting others = setting;
  others.columns.pop_back();
  const std::string head = others.columns.empty() ? "" : set_row(table, row, others);
  const int last = setting.columns.back();
  const Cell& cell = row[last];
  if (cell.text.empty()) return head;
  const int start = setting.width - *setting.last_width + cell.indent;
  const std::string lines = wrapped(repeated('x', start) + cell.text, setting.width, start);
  return head + repeated(' ', start - width_of(head)) + lines.substr(static_cast<std::size_t>(start));
}

/// Where the wrapped lines of prose begin: below the word behind "Scene: ", or where it begins itself.
int hanging_indent(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t colon = line.find(": ", begin);
  const bool has_label = colon != std::string_view::npos && colon - begin < 10 &&
                         line.substr(begin, colon - begin).find(' ') == std::string_view::npos;
  return static_cast<int>(has_label ? colon + 2 : begin);
}

std::string set_prose(const std::string& line, int width) {
  return width_of(line) <= width ? line : wrapped(line, width, hanging_indent(line));
}

std::string set_rows(const TextTable& table, const Setting& setting) {
  std::string text;
  for (int i = 0; i < table.rows.size(); ++i) {
    const List<Cell>& row = table.rows[i];
    const std::string line = row.empty()          ? set_prose(table.lines[i], setting.width)
                             : setting.last_width ? wrapped_row(table, row, setting)
                                                  : set_row(table, row, setting);
    text += line + "\n";
  }
  return text;
}

/// What is left for the last column, if it is prose and that is enough to read.
std::optional<int> room_for_prose(const TextTable& table, int width) {
  if (table.columns.size() < 2) return {};
  const Column& last = table.columns.back();
  const int room = width - (table_width(table, 2) - last.width);
  const bool is_prose = std::any_of(table.rows.begin(), table.rows.end(), [](const List<Cell>& row) {
    return !row.empty() && std::count(row.back().text.begin(), row.back().text.end(), ' ') > 2;
  });
  if (!is_prose || room < 24) return {};
  return room;
}

/// The first column and as many of the others as fit, then the first and the next ones. Nothing where one is
/// too wide.
std::optional<std::string> cut_up(const TextTable& table, int width) {
  std::string text;
  const int first = gap_before(table, 0, 2) + table.columns[0].width;
  for (int next = 1; next < table.columns.size();) {
    Setting setting = {.columns = {0}, .most = 2, .width = width};
    int used = first;
    while (next < table.columns.size()) {
      const int wider = used + gap_before(table, next, 2) + table.columns[next].width;
      if (wider > width) break;
      used = wider;
      setting.columns.push_back(next++);
    }
    if (setting.columns.size() == 1) return {};
    text += set_rows(table, setting);
  }
  if (text.empty()) return {};
  return text;
}

/// The same with what is in brackets in its head, the units, in a line below; nothing where there is none.
std::optional<TextTable> with_units_below(TextTable table) {
  if (table.rows.size() < 2 || table.rows.front().empty()) return {};
  List<Cell> units(table.columns.size());
  bool has_units = false;
  for (int i = 0; i < units.size(); ++i) {
    Cell& cell = table.rows.front()[i];
    const std::size_t bracket = cell.text.find(" (");
    if (bracket == std::string::npos) continue;
    units[i] = cell;
    units[i].text = cell.text.substr(bracket + 1);
    cell.text.resize(bracket);
    has_units = true;
  }
  if (!has_units) return {};
  table.rows.insert(table.rows.begin() + 1, units);
  table.lines.insert(table.lines.begin() + 1, "");
  for (int i = 0; i < units.size(); ++i) {
    table.columns[i].width = 0;
    for (const List<Cell>& row : table.rows)
      if (!row.empty())
        table.columns[i].width = std::max(table.columns[i].width, row[i].indent + width_of(row[i].text));
  }
  return table;
}

/// Where lines with many more or many fewer cells than before begin; 0 if nowhere.
int where_another_begins(const List<std::string>& lines) {
  int place = 0;
  int most = 1;
  for (int i = 1; i < lines.size(); ++i) {
    const int change = std::abs(cell_count(lines[i]) - cell_count(lines[i - 1]));
    if (change > most) place = i;
    most = std::max(most, change);
  }
  return place;
}

std::string set_table(const List<std::string>& lines, int width, bool plain) {
  const TextTable table = text_table(lines, plain);
  Setting setting = {.width = width};
  for (int i = 0; i < table.columns.size(); ++i) setting.columns.push_back(i);
  for (const int most : {unlimited, 3, 2}) {
    setting.most = most;
    if (table_width(table, most) <= width) return set_rows(table, setting);
  }
  setting.last_width = room_for_prose(table, width);
  if (setting.last_width) return set_rows(table, setting);
  setting.most = 1;
  if (table_width(table, 1) <= width) return set_rows(table, setting);
  if (const auto taller = with_units_below(table); taller && table_width(*taller, 1) <= width)
    return set_rows(*taller, setting);
  if (const auto parts = cut_up(table, width)) return *parts;
  if (const int other = where_another_begins(lines); other > 0) {
    return set_table({lines.begin(), lines.begin() + other}, width, plain) +
           set_table({lines.begin() + other, lines.end()}, width, plain);
  }
  std::string text;
  for (const std::string& line : table.lines) text += set_prose(line, width) + "\n";
  return text;
}

/// Whether prose begins where a table does, as a title between its rows would: it does not end the table.
bool stands_within(std::string_view line, std::string_view first) {
  const std::size_t indent = line.find_first_not_of(' ');
  return indent != std::string_view::npos && indent > 0 && indent == first.find_first_not_of(' ');
}

}  // namespace

bool has_cells(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", begin);
  return gap != std::string_view::npos && line.find_first_not_of(' ', gap) != std::string_view::npos;
}

std::string fitted(std::string_view text, int width, bool plain) {
  std::string result;
  List<std::string> table;
  const auto end_table = [&] {
    const bool fits = std::all_of(table.begin(), table.end(),
                                  [&](const std::string& line) { return width_of(line) <= width; });
    if (!table.empty() && (plain || !fits)) {
      result += set_table(table, width, plain);
    } else {
      for (const std::string& line : table) result += line + "\n";
    }
    table.clear();
  };
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line(text.substr(begin, end - begin));
    begin = end + 1;
    if (has_cells(line) || (!table.empty() && stands_within(line, table.front()))) {
      table.push_back(line);
      continue;
    }
    end_table();
    result += set_prose(plain ? transliterated(line) : line, width) + "\n";
  }
  end_table();
  return result;
}

std::string spread(const std::string& left, const std::string& right, int width) {
  const int blanks = width - display_width(left) - display_width(right);
  if (right.empty()) return left;
  return blanks < 3 ? left + "\n" + wrapped(right, width, 0) : left + repeated(' ', blanks) + right;
}

std::string folded_command(const std::string& command, int width) {
  constexpr char kept = '\x01';  // for blanks before what is no flag
  std::string words = command;
  for (std::size_t at = words.find(' '); at != std::string::npos; at = words.find(' ', at + 1))
    if (words.compare(at, 2, " -") != 0) words[at] = kept;
  std::string lines = wrapped(words, width - 2, 7);
  std::replace(lines.begin(), lines.end(), kept, ' ');
  for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 3))
    lines.insert(at, " \\");
  return lines;
}

}  // namespace cairn
