// Floor 9. The columns of every table about work and error.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include <cairn/measure/csv.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

struct TradeColumn {
  std::string name = {};
  std::string unit = {};  // "" for words and pure numbers
};

/// All columns, in order; one schema for frozen problems (level 1) and for trajectories (level 2). There is
/// none for momentum, which the ground takes up in nearly every scene, and none for the rank of A, which no
/// solver asks for.
const List<TradeColumn>& trade_columns();
List<std::string> trade_header();

/// One row, filled by the names of its columns; what is not set stays empty.
class TradeRow {
 public:
  /// @throws std::logic_error for a name that is no column.
  void set(std::string_view column, CsvCell value);
  List<CsvCell> cells() const;

 private:
  std::map<std::string, CsvCell, std::less<>> values_;
};

/// The table that a journal holds; `name` is for messages. @throws std::invalid_argument.
CsvTable table_of(const std::string& csv, const std::string& name);
/// @throws std::invalid_argument "name: columns must be rule, got others" unless the columns of a journal are
/// those of the study: the task, and then these.
void require_columns(const CsvTable& table, const List<std::string>& header, const std::string& name,
                     const std::string& rule);
/// A number of a table that was read back; NaN where the cell is empty or a word.
double number_in(const CsvTable& table, int row, std::string_view column);
/// A word of it; "" where there is none.
std::string text_in(const CsvTable& table, int row, std::string_view column);
/// A cell as text, whatever it holds.
std::string shown_in(const CsvTable& table, int row, std::string_view column);

}  // namespace cairn
