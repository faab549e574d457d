// Floor 12. What a map of the atlas says, in words.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "extremes/atlas.hpp"
#include "math/check.hpp"
#include "math/list.hpp"

namespace cairn {

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
