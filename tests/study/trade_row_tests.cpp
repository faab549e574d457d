// Rows of the trade's tables: every name in its own column, every number back again.
#include <cairn/study/trade_row.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

using namespace cairn;

TEST_CASE("a row of the trade has a cell for every column, and what is not set is empty") {
  const List<std::string> header = trade_header();
  REQUIRE(header.size() == trade_columns().size());
  CHECK(std::set<std::string>(header.begin(), header.end()).size() == header.size());
  TradeRow row;
  row.set("solver", std::string("si"));
  row.set("sweeps", 16LL);
  row.set("dt", 0.1);
  row.set("dt", 1.0 / 60);  // the last word counts
  const List<CsvCell> cells = row.cells();
  REQUIRE(cells.size() == header.size());
  for (int i = 0; i < cells.size(); ++i) {
    const bool is_set = header[i] == "solver" || header[i] == "sweeps" || header[i] == "dt";
    CHECK((cells[i] == CsvCell(std::string())) != is_set);
  }
}

TEST_CASE("a column that there is none of is refused when it is set and when it is read") {
  TradeRow row;
  CHECK_THROWS_WITH_AS(row.set("R_F", 1.0), doctest::Contains("R_F"), std::logic_error);
  const CsvTable table{.header = trade_header(), .rows = {row.cells()}};
  CHECK_THROWS_AS(number_in(table, 0, "R_F"), std::logic_error);
  CHECK_THROWS_AS(text_in(table, 0, "R_F"), std::logic_error);
}

TEST_CASE("numbers and words of the trade come back through a file as they were, failures too") {
  TradeRow row;
  row.set("setting", std::string("si x10, 60 Hz"));  // a comma inside
  row.set("R_E", 0.1 + 0.2);
  row.set("R_E_v", std::numeric_limits<double>::infinity());
  row.set("E_M", std::numeric_limits<double>::quiet_NaN());
  row.set("row_updates", 123456789012LL);
  std::stringstream file;
  write_csv(file, {.header = trade_header(), .rows = {row.cells()}});
  const CsvTable table = read_csv(file, "a file");
  CHECK(number_in(table, 0, "R_E") == 0.1 + 0.2);
  CHECK(number_in(table, 0, "R_E_v") == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(number_in(table, 0, "E_M")));
  CHECK(number_in(table, 0, "row_updates") == 123456789012.0);
  CHECK(text_in(table, 0, "setting") == "si x10, 60 Hz");
  CHECK(std::isnan(number_in(table, 0, "setting")));  // a word is no number
  CHECK(std::isnan(number_in(table, 0, "cost")));     // nor is nothing
  CHECK(text_in(table, 0, "R_E").empty());            // and a number no word
}

TEST_CASE("every quantity of the trade that has a unit says it") {
  const auto unit_of = [](const std::string& name) {
    const auto found = std::find_if(trade_columns().begin(), trade_columns().end(),
                                    [&](const TradeColumn& column) { return column.name == name; });
    REQUIRE(found != trade_columns().end());
    return found->unit;
  };
  for (const char* name : {"solve_ns_min", "solve_ns_med", "solve_ns_iqr", "step_ns_med"})
    CHECK(unit_of(name) == "ns");
  for (const char* name : {"r_inf_e", "r_inf_n", "r_inf_t"}) CHECK(unit_of(name) == "m/s");
  for (const char* name : {"pen_max", "drift_max", "slop"}) CHECK(unit_of(name) == "m");
  for (const char* name : {"dt", "stands_until"}) CHECK(unit_of(name) == "s");
  for (const char* name : {"R_E", "R_E_v", "E_M", "survival", "rows"}) CHECK(unit_of(name).empty());
}
