// Floor 12. Tasks and rows of the extremes.
#include "extremes/extreme_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "math/check.hpp"
#include "study/build_info.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

std::string solver_text(const Setting& setting) {
  std::string text = fmt::format("{} x{}", setting.solver, setting.sweeps.iterations);
  if (setting.substeps > 1) text += fmt::format(", {} substeps", setting.substeps);
  return text;
}

List<CsvCell> extreme_cells(const ExtremeCase& extreme) {
  const ExtremeFinding found = find_out(extreme);
  std::string note = found.note;
  std::replace(note.begin(), note.end(), '\n', ' ');  // a row of a journal is a line
  return {extreme.axis,
          extreme.value,
          solver_text(extreme.setting),
          stabilization_text({.policy = extreme.setting.stabilization.policy}),
          verdict_text(extreme.required),
          verdict_text(found.verdict),
          found.quantity,
          found.value,
          found.limit,
          note,
          static_cast<long long>(meets(extreme.required, found.verdict))};
}

std::string text_of(const CsvCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<long long>(&cell)) return std::to_string(*whole);
  return shortest(std::get<double>(cell));
}

double number_of(const CsvCell& cell) {
  if (const auto* whole = std::get_if<long long>(&cell)) return static_cast<double>(*whole);
  const auto* number = std::get_if<double>(&cell);
  return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Study extreme_study(const ExtremeChoice& choice) {
  const bool quick = choice.part == ExtremePart::quick;
  Study study;
  study.name = quick ? "extremes-quick" : "extremes";
  study.header = {"axis",     "value",    "solver", "policy", "required", "verdict",
                  "quantity", "measured", "limit",  "note",   "meets"};
  for (const ExtremeAxis& axis : extreme_axes()) {
    const bool chosen =
        choice.axes.empty() || std::count(choice.axes.begin(), choice.axes.end(), axis.name) > 0;
    if (!chosen) continue;
    if (!choice.axes.empty()) study.name += "-" + axis.name;
    for (const ExtremeCase& extreme : axis.make()) {
      if (quick && !extreme.quick) continue;
      study.tasks.push_back({axis.name + " " + extreme.value, [extreme] { return extreme_cells(extreme); }});
    }
  }
  require(!study.tasks.empty(), "extreme_study", "axes", "names of axes", "none that is known");
  return study;
}

List<ExtremeRow> extreme_rows(const std::string& csv) {
  std::istringstream in(csv);
  const CsvTable table = read_csv(in, "extremes");
  require(table.header.size() == 12, "extreme_rows", "columns", "12",
          static_cast<double>(table.header.size()));
  List<ExtremeRow> rows;
  for (const List<CsvCell>& cells : table.rows) {
    rows.push_back({.axis = text_of(cells[1]),
                    .value = text_of(cells[2]),
                    .solver = text_of(cells[3]),
                    .policy = text_of(cells[4]),
                    .required = text_of(cells[5]),
                    .verdict = text_of(cells[6]),
                    .quantity = text_of(cells[7]),
                    .measured = number_of(cells[8]),
                    .limit = number_of(cells[9]),
                    .note = text_of(cells[10]),
                    .meets = number_of(cells[11]) == 1});
  }
  return rows;
}

std::string extreme_json(const List<ExtremeRow>& rows) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (const ExtremeRow& row : rows) {
    cases.push_back({{"axis", row.axis},
                     {"value", row.value},
                     {"solver", row.solver},
                     {"policy", row.policy},
                     {"required", row.required},
                     {"verdict", row.verdict},
                     {"quantity", row.quantity},
                     {"measured", row.measured},
                     {"limit", row.limit},
                     {"note", row.note},
                     {"meets", row.meets}});
  }
  return nlohmann::ordered_json({{"build", build_json()}, {"cases", cases}}).dump(1);
}

}  // namespace cairn
