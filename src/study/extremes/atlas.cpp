// Floor 9. The maps as a study, read back from its journal, and what they say in words.
#include <cairn/study/extremes/atlas.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <cairn/study/trial.hpp>
#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/study/trade_row.hpp>

namespace cairn {

namespace {

const List<std::string> atlas_header = {"map", "solver", "panel",    "x",
                                        "y",   "class",  "measured", "energy_gain"};

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

const List<std::string> class_words = {"holds", "strained", "failed", "exploded", "refused", "not run"};

AtlasClass class_named(const std::string& text) {
  const auto found = std::find(class_words.begin(), class_words.end(), text);
  return found == class_words.end() ? AtlasClass::not_run
                                    : static_cast<AtlasClass>(found - class_words.begin());
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
  return setting_of(solver, sweeps, StabilizationPolicy::baumgarte);
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

std::string atlas_class_text(AtlasClass ending) { return class_words[static_cast<int>(ending)]; }

Study atlas_study(AtlasPart part) {
  Study study{
      .name = part == AtlasPart::quick ? "atlas-quick" : "atlas", .header = atlas_header, .tasks = {}};
  for (const AtlasMap& map : atlas_maps(part)) add_tasks(map, study);
  return study;
}

List<AtlasSheet> atlas_sheets(AtlasPart part, const std::string& csv) {
  const CsvTable table = table_of(csv, "atlas");
  require_columns(table, atlas_header, "atlas_sheets", "those of the atlas");
  List<AtlasSheet> sheets;
  List<std::pair<int, int>> places;  // of each task: sheet and cell
  for (const AtlasMap& map : atlas_maps(part)) {
    sheets.push_back({map, List<AtlasCell>(cells_of(map))});
    for (int cell = 0; cell < cells_of(map); ++cell) places.push_back({sheets.size() - 1, cell});
  }
  for (int row = 0; row < table.rows.size(); ++row) {
    const double task = number_in(table, row, "task");
    require(task >= 0 && task < static_cast<double>(places.size()), "atlas_sheets", "task",
            "the number of a cell", task);
    const auto& [sheet, cell] = places[static_cast<int>(task)];
    sheets[sheet].cells[cell] = {.ending = class_named(text_in(table, row, "class")),
                                 .measured = number_in(table, row, "measured"),
                                 .energy_gain = number_in(table, row, "energy_gain")};
  }
  return sheets;
}

namespace {

bool cell_holds(const AtlasSheet& sheet, int panel, int x, int y) {
  return sheet.cell(panel, x, y).ending == AtlasClass::holds;
}

/// The first y from which all up to the last hold.
std::optional<int> holds_from(const AtlasSheet& sheet, int panel, int x) {
  int first = sheet.map.y.values.size();
  while (first > 0 && cell_holds(sheet, panel, x, first - 1)) --first;
  if (first == sheet.map.y.values.size()) return std::nullopt;
  return first;
}

/// The last y up to which all from the first hold.
std::optional<int> holds_up_to(const AtlasSheet& sheet, int panel, int x) {
  int count = 0;
  while (count < sheet.map.y.values.size() && cell_holds(sheet, panel, x, count)) ++count;
  if (count == 0) return std::nullopt;
  return count - 1;
}

std::string from_y_text(const AtlasSheet& sheet, int panel) {
  const AtlasMap& map = sheet.map;
  if (sheet.cell(panel, map.headline, 0).ending == AtlasClass::not_run) return "too large to try";
  const std::optional<int> first = holds_from(sheet, panel, map.headline);
  if (map.panels[panel].ignores_y) return first ? "always" : "never";
  if (!first) return fmt::format("not with {} {}", shortest(map.y.values.back()), map.y_unit);
  const bool one = map.y.values[*first] == 1;
  const std::string unit = one ? map.y_unit.substr(0, map.y_unit.size() - 1) : map.y_unit;
  return fmt::format("from {} {}", shortest(map.y.values[*first]), unit);
}

std::string up_to_y_text(const AtlasSheet& sheet, int panel) {
  const AtlasMap& map = sheet.map;
  const std::optional<int> last = holds_up_to(sheet, panel, map.headline);
  if (!last) return fmt::format("not even at {} {}", shortest(map.y.values.front()), map.y_unit);
  return fmt::format("up to {} {}", shortest(map.y.values[*last]), map.y_unit);
}

std::string up_to_x_text(const AtlasSheet& sheet, int panel) {
  const AtlasMap& map = sheet.map;
  std::string text;
  for (int y = 0; y < map.y.values.size(); ++y) {
    if (sheet.cell(panel, 0, y).ending == AtlasClass::not_run) continue;
    int count = 0;
    while (count < map.x.values.size() && cell_holds(sheet, panel, count, y)) ++count;
    const std::string place =
        count > 0 ? fmt::format("{:.0e}", map.x.values[count - 1]) : std::string("nowhere");
    const std::string power =
        count > 0 ? fmt::format("10^{{{}}} m", std::stoi(place.substr(place.find('e') + 1))) : place;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", map.y.labels[y], power);
  }
  return text;
}

}  // namespace

std::string panel_finding(const AtlasSheet& sheet, int panel) {
  switch (sheet.map.reading) {
    case AtlasReading::from_y:
      return from_y_text(sheet, panel);
    case AtlasReading::up_to_y:
      return up_to_y_text(sheet, panel);
    case AtlasReading::up_to_x:
      break;
  }
  return up_to_x_text(sheet, panel);
}

std::string sheet_finding(const AtlasSheet& sheet) {
  List<std::string> findings;
  for (int panel = 0; panel < sheet.map.panels.size(); ++panel)
    findings.push_back(panel_finding(sheet, panel));
  const bool alike = std::count(findings.begin(), findings.end(), findings.front()) == std::ssize(findings);
  if (alike && findings.size() > 1)
    return fmt::format("{}, with every solver: {}", sheet.map.headline_text, findings.front());
  std::string text = sheet.map.headline_text;
  bool first = true;
  for (int panel = 0; panel < findings.size(); ++panel) {
    const AtlasPanel& shown = sheet.map.panels[panel];
    if (!shown.in_title) continue;
    const std::string who = shown.title.substr(0, shown.title.find(", and so"));
    text += fmt::format("{} {} {}", first ? ":" : ";", who, findings[panel]);
    first = false;
  }
  return text;
}

}  // namespace cairn
