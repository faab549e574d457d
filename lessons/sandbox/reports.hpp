// Studies of the command line, and what they are told as: files, tables, pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include "render/theme.hpp"
#include <cairn/study/journal.hpp>

namespace cairn::sandbox {

/// What --theme says. @throws UsageError.
render::Theme theme_of(const Words& words);

/// What `cairn tradeoff` is asked to study, and how its table is to be drawn.
struct TradeStudy {
  Study study = {};
  int level = 1;
  std::string name = {};                        // of its files
  std::string title = {};                       // of its chart
  std::string note = {};                        // below it
  std::string work = {}, error = {};            // columns
  std::string work_name = {}, error_name = {};  // at the head of a printed table
  std::string work_axis = {}, error_axis = {};
  List<std::string> curves = {};                  // at most 4 solvers; or scenes, of what more sweeps buy
  bool is_of_sweeps = false;                      // in each of several scenes
  std::map<std::string, std::string> shown = {};  // the rows that are drawn: words that columns have
};

/// @throws UsageError, std::invalid_argument.
TradeStudy trade_study(const Words& words);

/// Of work against error: writes the table as CSV and JSON, draws what there is to draw, prints. The exit
/// code: check_failed when no setting came to a number.
int report_trade(const Words& words, const TradeStudy& trade, const std::string& csv,
                 const std::filesystem::path& folder, Console& console);

/// Of what more sweeps buy in each of several scenes: writes sweeps.csv, .json and .png, prints. The exit
/// code: check_failed when some run failed.
int report_sweeps(const Words& words, const TradeStudy& trade, const CsvTable& table,
                  const std::filesystem::path& folder, Console& console);

/// Of the map of settings: writes level3.csv and map.png, prints how the runs ended and which one setting
/// does for most scenes. @throws std::invalid_argument for a table of another kind.
int report_map(const Words& words, const std::string& csv, const std::filesystem::path& folder,
               Console& console);

/// Runs the maps of the atlas, and draws them. The exit code. Explosions are what a map is there to show:
/// they are no failure.
int run_atlas(const Words& words, Console& console);

}  // namespace cairn::sandbox
