// Floor 9. From what a case does to a verdict, and to a row of a table.
#include <cairn/study/extremes/extreme.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <cairn/study/extremes/extreme_axes.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/build_info.hpp>
#include <cairn/study/trade_row.hpp>

namespace cairn {

std::string verdict_text(ExtremeVerdict verdict) {
  static const List<std::string> words = {"OK", "BOUND", "REFUSE", "TOLD", "FAIL"};
  return words[static_cast<int>(verdict)];
}

bool meets(ExtremeVerdict required, ExtremeVerdict found) {
  if (required != ExtremeVerdict::bound) return found == required;
  return found == required || found == ExtremeVerdict::ok || found == ExtremeVerdict::told;
}

const List<ExtremeAxis>& extreme_axes() {
  static const List<ExtremeAxis> axes = [] {
    List<ExtremeAxis> all;
    for (const auto& group : {load_axes(), step_axes(), motion_axes(), size_axes(), row_axes(), spring_axes(),
                              material_axes(), number_axes(), count_axes(), input_axes(), target_axes()}) {
      all.insert(all.end(), group.begin(), group.end());
    }
    return all;
  }();
  return axes;
}

ExtremeFinding find_out(const ExtremeCase& extreme) {
  ExtremeFinding finding;
  try {
    finding = extreme.run(extreme.setting);
    if (!std::isfinite(finding.value)) finding.verdict = ExtremeVerdict::fail;
  } catch (const std::invalid_argument& refusal) {
    finding = {.verdict = ExtremeVerdict::refuse, .quantity = "refused", .note = refusal.what()};
    // Field, rule and value are named where the message came from `require`.
    const bool names = finding.note.find(" must be ") != std::string::npos ||
                       finding.note.find(" above the limit of ") != std::string::npos;
    if (!names) finding.verdict = ExtremeVerdict::fail;
  } catch (const std::length_error& refusal) {
    finding = {.verdict = ExtremeVerdict::refuse, .quantity = "refused", .note = refusal.what()};
  } catch (const std::exception& error) {
    finding = {.quantity = "an error", .note = error.what()};
  }
  return finding;
}

namespace {

const List<std::string> extreme_header = {"axis",     "value",    "solver", "policy", "required", "verdict",
                                          "quantity", "measured", "limit",  "note",   "meets"};

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

}  // namespace

Study extreme_study(const ExtremeChoice& choice) {
  const bool quick = choice.part == ExtremePart::quick;
  Study study{.name = quick ? "extremes-quick" : "extremes", .header = extreme_header, .tasks = {}};
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

CsvTable extreme_table(const std::string& csv) {
  const CsvTable table = table_of(csv, "extremes");
  require_columns(table, extreme_header, "extremes", "those of the extremes");
  return table;
}

std::string extreme_json(const CsvTable& table) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (int row = 0; row < table.rows.size(); ++row) {
    nlohmann::ordered_json one;
    for (const std::string& column : extreme_header) {
      const bool is_number = column == "measured" || column == "limit";
      if (is_number) one[column] = number_in(table, row, column);
      if (!is_number) one[column] = shown_in(table, row, column);
    }
    one["meets"] = number_in(table, row, "meets") == 1;
    cases.push_back(one);
  }
  return nlohmann::ordered_json({{"build", build_json()}, {"cases", cases}}).dump(1);
}

}  // namespace cairn
