// Floor 11. Reading the map of settings.
#include "tuning/map_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/check.hpp"
#include "tuning/map_study.hpp"

namespace cairn {

namespace {

double number_in(const CsvCell& cell) {
  if (const auto* whole = std::get_if<long long>(&cell)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&cell);
  return real != nullptr && !std::isnan(*real) ? *real : std::numeric_limits<double>::infinity();
}

int count_in(const CsvCell& cell) { return static_cast<int>(std::get<long long>(cell)); }

std::string text_in(const CsvCell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr ? *text : "";
}

/// The first cell is the number of the task.
MapRow map_row_of(const List<CsvCell>& cells) {
  MapRow row{.scene = text_in(cells[1]),
             .family = text_in(cells[2]),
             .value = number_in(cells[3]),
             .solver = text_in(cells[4]),
             .frequency = count_in(cells[5]),
             .substeps = count_in(cells[6]),
             .sweeps = count_in(cells[7]),
             .policy = text_in(cells[8]),
             .scalar = text_in(cells[9]),
             .status = text_in(cells[10]),
             .error = number_in(cells[13])};
  row.work = counted_work(row.solver, number_in(cells[12]), number_in(cells[11]));
  return row;
}

}  // namespace

std::string MapRow::setting() const {
  const std::string substepped = substeps > 1 ? fmt::format(" x{}", substeps) : "";
  return fmt::format("{} x{}, {} Hz{}, {}, {}", solver, sweeps, frequency, substepped, policy, scalar);
}

MapTable read_map(const CsvTable& table, const std::string& name) {
  List<std::string> header = {"task"};
  for (const std::string& column : map_header()) header.push_back(column);
  require(table.header == header, name, "columns", "those of the map of settings", "others");
  MapTable map;
  for (const List<CsvCell>& cells : table.rows) {
    MapRow row = map_row_of(cells);
    if (map.scenes.empty() || map.scenes.back().front().scene != row.scene) map.scenes.emplace_back();
    map.scenes.back().push_back(std::move(row));
  }
  for (const List<MapRow>& runs : map.scenes)
    require(runs.size() == map.settings(), name, "settings of " + runs.front().scene,
            fmt::format("{}, as of the first scene", map.settings()), runs.size());
  return map;
}

const MapRow* cheapest(const List<MapRow>& runs, double goal,
                       const std::function<bool(const MapRow&)>& among) {
  const MapRow* best = nullptr;
  for (const MapRow& run : runs) {
    if (!run.meets(goal) || (among && !among(run))) continue;
    if (best == nullptr || run.work < best->work) best = &run;
  }
  return best;
}

MapChoice best_for_all(const MapTable& table, const List<int>& scenes, double goal,
                       const std::string& solver) {
  List<double> least;
  for (const int scene : scenes) {
    const MapRow* best = cheapest(table.scenes[scene], goal);
    least.push_back(best != nullptr ? best->work : 0);
  }
  MapChoice choice;
  for (int setting = 0; setting < table.settings(); ++setting) {
    if (table.scenes.front()[setting].solver != solver) continue;
    int met = 0;
    double logs = 0;
    for (int i = 0; i < scenes.size(); ++i) {
      const MapRow& run = table.scenes[scenes[i]][setting];
      if (!run.meets(goal)) continue;
      ++met;
      if (least[i] > 0) logs += std::log(run.work / least[i]);
    }
    const double multiple = met > 0 ? std::exp(logs / met) : 1;
    const bool is_better = met > choice.met || (met == choice.met && multiple < choice.multiple);
    if (choice.setting < 0 || is_better) choice = {setting, met, multiple};
  }
  return choice;
}

}  // namespace cairn
