// Pages of panels: the map of settings, with its tables, and the maps of the stability atlas.
#include "lessons/sandbox/reports.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "lessons/kit/records.hpp"
#include "lessons/sandbox/charts.hpp"
#include "lessons/sandbox/study_words.hpp"
#include <cairn/measure/whole_file.hpp>
#include "render/image.hpp"
#include <cairn/scenes/solver_list.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/study/tuning/sweep_price.hpp>

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;

void print_endings(const MapTable& table, Console& console) {
  const List<std::string> endings = {"ok",      "off",      "fell", "fails",  "gained",
                                     "timeout", "diverged", "nan",  "refused"};
  console.result(fmt::format("how {} runs ended: {} settings in {} scenes",
                             table.settings() * table.scenes.size(), table.settings(), table.scenes.size()));
  std::string head = fmt::format("  {:<13}", "solver");
  for (const std::string& ending : endings) head += fmt::format(" {:>8}", ending);
  console.result(head);
  for (const std::string& solver : map_solvers) {
    std::map<std::string, int> counts;
    int all = 0;
    for (const List<MapRow>& runs : table.scenes) {
      for (const MapRow& run : runs) {
        if (run.solver != solver) continue;
        counts[run.status] += 1;
        all += 1;
      }
    }
    std::string line = fmt::format("  {:<13}", solver);
    for (const std::string& ending : endings)
      line += fmt::format(" {:>7.1f}%", all > 0 ? 100.0 * counts[ending] / all : 0);
    console.result(line);
  }
}

/// Scenes with joints, or those without, that any setting brings to the goal.
List<int> scenes_of(const MapTable& table, bool with_joints, double goal) {
  static const std::set<std::string> jointed = [] {
    std::set<std::string> names;
    for (const MapScene& entry : map_scenes())
      if (!entry.scene.make().joints().empty()) names.insert(entry.scene.name);
    return names;
  }();
  List<int> scenes;
  for (int i = 0; i < table.scenes.size(); ++i) {
    const bool has = jointed.count(table.scenes[i].front().scene) > 0;
    if (has == with_joints && cheapest(table.scenes[i], goal) != nullptr) scenes.push_back(i);
  }
  return scenes;
}

void print_choices(const MapTable& table, bool with_joints, double goal, Console& console) {
  const List<int> scenes = scenes_of(table, with_joints, goal);
  console.result(
      fmt::format("one setting for {} scenes {} joints, to an error of {:g}: the one that is enough for most",
                  scenes.size(), with_joints ? "with" : "without", goal));
  console.result(
      fmt::format("  {:<50} {:>8} {:>12} {:>12}", "setting", "does for", "times least", "is cheapest"));
  for (const std::string& solver : map_solvers) {
    const MapChoice choice = best_for_all(table, scenes, goal, solver);
    if (choice.setting < 0 || scenes.empty()) continue;
    int wins = 0;
    for (const int scene : scenes) wins += cheapest(table.scenes[scene], goal)->solver == solver ? 1 : 0;
    console.result(
        fmt::format("  {:<50} {:>7.0f}% {:>12.3g} {:>11.0f}%", table.scenes.front()[choice.setting].setting(),
                    100.0 * choice.met / scenes.size(), choice.multiple, 100.0 * wins / scenes.size()));
  }
}

/// In how many of the scenes a setting of the solver is the cheapest, and in how many any setting will do.
std::pair<int, int> wins_of(const MapTable& table, const std::string& solver, double goal) {
  int wins = 0, scenes = 0;
  for (const List<MapRow>& runs : table.scenes) {
    const MapRow* best = cheapest(runs, goal);
    if (best == nullptr) continue;
    scenes += 1;
    wins += best->solver == solver ? 1 : 0;
  }
  return {wins, scenes};
}

/// In how many scenes the solver is the cheapest, at each of these prices of its sweep.
std::string wins_text(const MapTable& table, const std::string& solver, const List<double>& prices,
                      double goal) {
  std::string text;
  for (const double price : prices)
    text += fmt::format(" {:>7}", wins_of(priced(table, solver, price), solver, goal).first);
  return text;
}

/// The price of a sweep decides who wins.
void print_prices(const MapTable& table, Console& console) {
  const List<double> goals = {0.01, 0.001};
  std::string of, head = fmt::format("  {:<13} {:>18}", "solver", "sweeps of si");
  for (const double goal : goals) {
    of += fmt::format("{}{} scenes to {:g}", of.empty() ? "" : ", of ",
                      wins_of(table, map_solvers.front(), goal).second, goal);
    for (const char* price : {"half", "price", "double"}) head += fmt::format(" {:>7}", price);
  }
  console.result("in how many of " + of + " a solver is the cheapest, by the price of its sweep");
  console.result(head);
  for (const std::string& solver : map_solvers) {
    const double price = solver_entry(solver).work_of_a_sweep;
    std::string line = fmt::format("  {:<13} {:>18.3g}", solver, price);
    for (const double goal : goals) line += wins_text(table, solver, {price / 2, price, 2 * price}, goal);
    console.result(line);
  }
}

/// What a sweep takes on this machine, where the runs of the map were done.
void print_measured_prices(Console& console) {
  console.result("measured here, on the frozen problems: a sweep in sweeps of si, of newton a linear system");
  console.result(fmt::format("  {:<13} {:>8} {:>8} {:>8}", "solver", "least", "median", "most"));
  for (const SweepPrice& price : measured_prices(map_solvers))
    console.result(fmt::format("  {:<13} {:>8.2f} {:>8.2f} {:>8.2f}", price.solver, price.least, price.median,
                               price.most));
}

/// Cells that were not run stay empty.
void report_sheets(const List<AtlasSheet>& sheets, const fs::path& folder, const Words& words,
                   Console& console) {
  const render::Theme theme = theme_of(words);
  for (const AtlasSheet& sheet : sheets) {
    const PanelPicture picture = draw_atlas(sheet, theme);
    const std::string name =
        fmt::format("atlas_{}_{}.png", sheet.map.name, words.text("theme").value_or("light"));
    render::write_png(folder / name, picture.image);
    for (const std::string& finding : picture.findings) console.warn(name + ": " + finding);
    if (!words.has("json"))
      console.result(console.spelt(fmt::format("{:<11} {}", sheet.map.name, sheet_finding(sheet))));
  }
}

}  // namespace

int report_map(const Words& words, const std::string& csv, const std::filesystem::path& folder,
               Console& console) {
  const CsvTable cells = table_of(csv, words.text("table").value_or("level3"));
  const MapTable table = read_map(cells, words.text("table").value_or("level3"));
  write_whole_file(folder / "level3.csv", csv);
  const PanelPicture picture = draw_map(table, theme_of(words));
  render::write_png(folder / "map.png", picture.image);
  for (const std::string& finding : picture.findings) console.warn("map.png: " + finding);
  if (words.has("json")) {
    fmt::print("{}", json_of(cells));
  } else {
    print_endings(table, console);
    for (const bool with_joints : {false, true}) {
      for (const double goal : {0.01, 0.001}) print_choices(table, with_joints, goal, console);
    }
    print_prices(table, console);
    if (!words.has("table")) print_measured_prices(console);
  }
  console.narrate("written: " + (folder / "level3.csv").string() + ", map.png");
  return all_well;
}

int run_atlas(const Words& words, Console& console) {
  for (const char* flag : {"only", "missed", "list", "out"}) words.refuse_beside(flag, "beside --atlas");
  (void)theme_of(words);  // refuses a wrong one before the work
  const AtlasPart part = words.has("quick") ? AtlasPart::quick : AtlasPart::all;
  const Study study = atlas_study(part);
  const Shard shard = shard_of(words);
  const fs::path folder = *words.text("atlas");
  const std::string of = shard.of > 1 ? fmt::format("_{}_of_{}", shard.number, shard.of) : "";
  const fs::path file = folder / (study.name + of + ".csv");
  Journal journal = open_journal(words, file, study);
  if (!run_or_merge(words, study, shard, journal, "cells")) return stopped;
  report_sheets(atlas_sheets(part, journal.csv()), folder, words, console);
  if (words.has("json")) fmt::print("{}\n", json_of(table_of(journal.csv(), "atlas")));
  console.narrate(fmt::format("{} of {} cells; journal: {}; --again begins anew", journal.size(),
                              study.tasks.size(), file.string()));
  return all_well;
}

}  // namespace cairn::sandbox
