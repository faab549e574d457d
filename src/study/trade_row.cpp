// Floor 9. Rows by the names of their columns.
#include <cairn/study/trade_row.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include <cairn/math/check.hpp>

namespace cairn {

const List<TradeColumn>& trade_columns() {
  static const List<TradeColumn> columns = [] {
    const List<std::string> names = {"schema",
                                     "version",
                                     "git",
                                     "box2d",
                                     "compiler",
                                     "flags",
                                     "cpu",
                                     "cores",
                                     "scalar",
                                     "scene",
                                     "scene_hash",
                                     "level",
                                     "bodies",
                                     "rows",
                                     "nnzA",
                                     "unique_v",
                                     "solver",
                                     "setting",
                                     "dt",
                                     "substeps",
                                     "sweeps",
                                     "warm",
                                     "friction_model",
                                     "stabilizer",
                                     "beta",
                                     "slop",
                                     "starts",
                                     "row_updates",
                                     "solve_ns_min",
                                     "solve_ns_med",
                                     "solve_ns_iqr",
                                     "step_ns_med",
                                     "step_ns_max",
                                     "setup_ns",
                                     "frame_ms",
                                     "reps",
                                     "R_E",
                                     "R_E_v",
                                     "r_inf_e",
                                     "r_inf_n",
                                     "r_inf_t",
                                     "E_M",
                                     "delta_v_lambda",
                                     "gap_J",
                                     "pen_max",
                                     "drift_max",
                                     "pen_med",
                                     "drift_med",
                                     "of_body",
                                     "of_body_med",
                                     "jitter",
                                     "exact_gap",
                                     "dE_max_gain",
                                     "dE_final",
                                     "stands_until",
                                     "survival",
                                     "failed",
                                     "asked",
                                     "asked_med",
                                     "asked_most",
                                     "cost",
                                     "work",
                                     "err_name",
                                     "err_value",
                                     "err_p90",
                                     "err_ref",
                                     "ref_kind",
                                     "status",
                                     "state_hash"};
    const std::map<std::string, std::string> units = {{"dt", "s"},
                                                      {"slop", "m"},
                                                      {"solve_ns_min", "ns"},
                                                      {"solve_ns_med", "ns"},
                                                      {"solve_ns_iqr", "ns"},
                                                      {"step_ns_med", "ns"},
                                                      {"step_ns_max", "ns"},
                                                      {"setup_ns", "ns"},
                                                      {"frame_ms", "ms"},
                                                      {"r_inf_e", "m/s"},
                                                      {"r_inf_n", "m/s"},
                                                      {"r_inf_t", "m/s"},
                                                      {"gap_J", "J"},
                                                      {"pen_max", "m"},
                                                      {"drift_max", "m"},
                                                      {"pen_med", "m"},
                                                      {"drift_med", "m"},
                                                      {"jitter", "m/s"},
                                                      {"exact_gap", "m"},
                                                      {"stands_until", "s"},
                                                      {"cost", "s/s"},
                                                      {"work", "1/s"}};
    List<TradeColumn> all;
    for (const std::string& name : names) {
      const auto unit = units.find(name);
      all.push_back({name, unit != units.end() ? unit->second : ""});
    }
    return all;
  }();
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

CsvTable table_of(const std::string& csv, const std::string& name) {
  std::istringstream in(csv);
  return read_csv(in, name);
}

void require_columns(const CsvTable& table, const List<std::string>& header, const std::string& name,
                     const std::string& rule) {
  List<std::string> expected = {"task"};
  expected.insert(expected.end(), header.begin(), header.end());
  require(table.header == expected, name, "columns", rule, "others");
}

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

std::string shown_in(const CsvTable& table, int row, std::string_view column) {
  const CsvCell& cell = cell_in(table, row, column);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<long long>(&cell)) return std::to_string(*whole);
  return shortest(std::get<double>(cell));
}

}  // namespace cairn
