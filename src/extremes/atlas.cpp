// Floor 12. The maps as a study, and read back from its journal.
#include "extremes/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "extremes/atlas_maps.hpp"
#include "math/check.hpp"
#include "math/list.hpp"

namespace cairn {

namespace {

/// Every second value, the headline's among them.
AtlasAxis thinned(const AtlasAxis& axis, int kept) {
  AtlasAxis thin{.title = axis.title};
  for (int i = kept % 2; i < axis.values.size(); i += 2) {
    thin.values.push_back(axis.values[i]);
    thin.labels.push_back(axis.labels[i]);
  }
  return thin;
}

AtlasMap thinned_map(AtlasMap map) {
  map.x = thinned(map.x, map.headline);
  map.headline /= 2;
  if (map.y.values.size() > 3) map.y = thinned(map.y, 0);
  return map;
}

int cells_of(const AtlasMap& map) { return map.panels.size() * map.x.values.size() * map.y.values.size(); }

AtlasClass class_named(const std::string& text) {
  for (const AtlasClass ending : {AtlasClass::holds, AtlasClass::strained, AtlasClass::failed,
                                  AtlasClass::exploded, AtlasClass::refused}) {
    if (atlas_class_text(ending) == text) return ending;
  }
  return AtlasClass::not_run;
}

double atlas_number(const CsvCell& cell) {
  if (const auto* whole = std::get_if<long long>(&cell)) return static_cast<double>(*whole);
  const auto* number = std::get_if<double>(&cell);
  return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

void add_tasks(const AtlasMap& map, Study& study) {
  for (const AtlasPanel& panel : map.panels) {
    for (const double x : map.x.values) {
      for (const double y : map.y.values) {
        const bool once = panel.ignores_y && y != map.y.values.front();
        study.tasks.push_back(
            {map.name + " " + panel.title, [=]() -> List<CsvCell> {
               const AtlasCell cell = once ? AtlasCell{} : map.run(panel, x, y);
               return {map.name, panel.setting.solver,          panel.title,   x,
                       y,        atlas_class_text(cell.ending), cell.measured, cell.energy_gain};
             }});
      }
    }
  }
}

}  // namespace

List<AtlasMap> atlas_maps(AtlasPart part) {
  List<AtlasMap> maps = {mass_ratio_map(), stack_map(), chain_map(), spring_map(), origin_map()};
  if (part == AtlasPart::quick) std::transform(maps.begin(), maps.end(), maps.begin(), thinned_map);
  return maps;
}

Setting atlas_setting(const std::string& solver, int sweeps) {
  Setting setting;
  setting.solver = solver;
  setting.sweeps.iterations = sweeps;
  setting.stabilization.policy = StabilizationPolicy::baumgarte;
  return setting;
}

List<AtlasPanel> solver_panels(int sweeps) {
  List<AtlasPanel> panels = {{"SI, and so PGS", atlas_setting("si", sweeps), true}};
  for (const char* solver :
       {"block", "block-contact", "accelerated", "newton", "jacobi", "jacobi-damped", "jacobi-split"})
    panels.push_back({solver, atlas_setting(solver, sweeps)});
  return panels;
}

AtlasClass class_of(double measured, const AtlasLimits& limits) {
  if (measured <= limits.holds) return AtlasClass::holds;
  if (measured <= limits.strained) return AtlasClass::strained;
  return std::isfinite(measured) ? AtlasClass::failed : AtlasClass::exploded;
}

AtlasCell atlas_cell(const Scene& scene, const Setting& setting, const AtlasLimits& limits,
                     const std::function<double(const TrialResult&)>& measure) {
  TrialOptions options;
  options.seconds = limits.seconds;
  options.penetration_every = std::numeric_limits<int>::max();
  options.most_energy = std::numeric_limits<double>::infinity();
  options.gives_up = [](const TrialResult& so_far) { return so_far.energy_gain > atlas_explosion; };
  const TrialResult result = run_trial(scene, setting, options);
  AtlasCell cell{.measured = measure(result), .energy_gain = result.energy_gain};
  cell.ending = class_of(cell.measured, limits);
  if (result.status == TrialStatus::nan || !(cell.energy_gain <= atlas_explosion))
    cell.ending = AtlasClass::exploded;
  if (result.status == TrialStatus::refused) cell.ending = AtlasClass::refused;
  return cell;
}

const AtlasCell& AtlasSheet::cell(int panel, int x, int y) const {
  const int row = map.panels[panel].ignores_y ? 0 : y;
  return cells[(panel * map.x.values.size() + x) * map.y.values.size() + row];
}

std::string atlas_class_text(AtlasClass ending) {
  switch (ending) {
    case AtlasClass::holds:
      return "holds";
    case AtlasClass::strained:
      return "strained";
    case AtlasClass::failed:
      return "failed";
    case AtlasClass::exploded:
      return "exploded";
    case AtlasClass::refused:
      return "refused";
    case AtlasClass::not_run:
      break;
  }
  return "not run";
}

Study atlas_study(AtlasPart part) {
  Study study;
  study.name = part == AtlasPart::quick ? "atlas-quick" : "atlas";
  study.header = {"map", "solver", "panel", "x", "y", "class", "measured", "energy_gain"};
  for (const AtlasMap& map : atlas_maps(part)) add_tasks(map, study);
  return study;
}

List<AtlasSheet> atlas_sheets(AtlasPart part, const std::string& csv) {
  std::istringstream in(csv);
  const CsvTable table = read_csv(in, "atlas");
  require(table.header.size() == 9, "atlas_sheets", "columns", "9", static_cast<double>(table.header.size()));
  List<AtlasSheet> sheets;
  List<std::pair<int, int>> places;  // of each task: sheet and cell
  for (const AtlasMap& map : atlas_maps(part)) {
    sheets.push_back({map, List<AtlasCell>(cells_of(map))});
    for (int cell = 0; cell < cells_of(map); ++cell) places.push_back({sheets.size() - 1, cell});
  }
  for (const List<CsvCell>& row : table.rows) {
    const double task = atlas_number(row[0]);
    require(task >= 0 && task < static_cast<double>(places.size()), "atlas_sheets", "task",
            "the number of a cell", task);
    const auto& [sheet, cell] = places[static_cast<int>(task)];
    const auto* ending = std::get_if<std::string>(&row[6]);
    sheets[sheet].cells[cell] = {.ending = class_named(ending != nullptr ? *ending : ""),
                                 .measured = atlas_number(row[7]),
                                 .energy_gain = atlas_number(row[8])};
  }
  return sheets;
}

}  // namespace cairn
