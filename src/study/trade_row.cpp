// Floor 10. Rows by the names of their columns.
#include "study/trade_row.hpp"
#include "math/list.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace cairn {

const List<TradeColumn>& trade_columns() {
  static const List<TradeColumn> columns = {{"schema", ""},
                                            {"version", ""},
                                            {"git", ""},
                                            {"box2d", ""},
                                            {"compiler", ""},
                                            {"flags", ""},
                                            {"cpu", ""},
                                            {"cores", ""},
                                            {"scalar", ""},
                                            {"scene", ""},
                                            {"scene_hash", ""},
                                            {"level", ""},
                                            {"bodies", ""},
                                            {"rows", ""},
                                            {"nnzA", ""},
                                            {"unique_v", ""},
                                            {"solver", ""},
                                            {"setting", ""},
                                            {"dt", "s"},
                                            {"substeps", ""},
                                            {"sweeps", ""},
                                            {"warm", ""},
                                            {"friction_model", ""},
                                            {"stabilizer", ""},
                                            {"beta", ""},
                                            {"slop", "m"},
                                            {"starts", ""},
                                            {"row_updates", ""},
                                            {"solve_ns_min", "ns"},
                                            {"solve_ns_med", "ns"},
                                            {"solve_ns_iqr", "ns"},
                                            {"step_ns_med", "ns"},
                                            {"reps", ""},
                                            {"R_E", ""},
                                            {"R_E_v", ""},
                                            {"r_inf_e", "m/s"},
                                            {"r_inf_n", "m/s"},
                                            {"r_inf_t", "m/s"},
                                            {"E_M", ""},
                                            {"delta_v_lambda", ""},
                                            {"gap_J", "J"},
                                            {"pen_max", "m"},
                                            {"drift_max", "m"},
                                            {"dE_max_gain", ""},
                                            {"dE_final", ""},
                                            {"stands_until", "s"},
                                            {"survival", ""},
                                            {"cost", "s/s"},
                                            {"work", "1/s"},
                                            {"err_name", ""},
                                            {"err_value", ""},
                                            {"err_p90", ""},
                                            {"err_ref", ""},
                                            {"ref_kind", ""},
                                            {"status", ""},
                                            {"state_hash", ""}};
  return columns;
}

List<std::string> trade_header() {
  List<std::string> header;
  for (const TradeColumn& column : trade_columns()) header.push_back(column.name);
  return header;
}

void TradeRow::set(std::string_view column, CsvCell value) {
  const bool is_known = std::any_of(trade_columns().begin(), trade_columns().end(),
                                    [&](const TradeColumn& known) { return known.name == column; });
  if (!is_known) throw std::logic_error("there is no column " + std::string(column));
  values_.insert_or_assign(std::string(column), std::move(value));
}

List<CsvCell> TradeRow::cells() const {
  List<CsvCell> cells;
  for (const TradeColumn& column : trade_columns()) {
    const auto found = values_.find(column.name);
    cells.push_back(found == values_.end() ? CsvCell(std::string()) : found->second);
  }
  return cells;
}

namespace {

const CsvCell& cell_in(const CsvTable& table, int row, std::string_view column) {
  const auto found = std::find(table.header.begin(), table.header.end(), column);
  if (found == table.header.end()) throw std::logic_error("there is no column " + std::string(column));
  return table.rows[row][found - table.header.begin()];
}

}  // namespace

double number_in(const CsvTable& table, int row, std::string_view column) {
  const CsvCell& cell = cell_in(table, row, column);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* whole = std::get_if<long long>(&cell)) return static_cast<double>(*whole);
  return std::numeric_limits<double>::quiet_NaN();
}

std::string text_in(const CsvTable& table, int row, std::string_view column) {
  const auto* text = std::get_if<std::string>(&cell_in(table, row, column));
  return text == nullptr ? "" : *text;
}

}  // namespace cairn
