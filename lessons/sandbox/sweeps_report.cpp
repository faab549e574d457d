// What more sweeps buy in each of several scenes: a table and a chart of every run.
#include <fmt/format.h>

#include <cmath>

#include "lessons/kit/records.hpp"
#include "lessons/kit/words.hpp"
#include "lessons/sandbox/charts.hpp"
#include "lessons/sandbox/reports.hpp"
#include "render/image.hpp"
#include <cairn/measure/whole_file.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/study/work_precision.hpp>

namespace cairn::sandbox {
namespace {

/// The runs of a scene, in the order of their sweeps, that have a place on a logarithmic axis: none that
/// failed, and none with an error of 0.
List<TradePoint> runs_of(const CsvTable& table, const std::string& scene, const std::string& error) {
  List<TradePoint> points;
  for (int row = 0; row < table.rows.size(); ++row) {
    const bool is_drawn = is_point(text_in(table, row, "status")) && number_in(table, row, error) > 0;
    if (text_in(table, row, "scene") != scene || !is_drawn) continue;
    points.push_back({.solver = scene,
                      .setting = text_in(table, row, "setting"),
                      .work = number_in(table, row, "sweeps"),
                      .error = number_in(table, row, error),
                      .row = row});
  }
  return points;
}

void print_sweeps(const TradeStudy& trade, const CsvTable& table, Console& console) {
  console.result(trade.title + ": " + trade.error_name);
  std::string line;
  for (int row = 0; row < table.rows.size(); ++row) {
    const std::string scene = text_in(table, row, "scene");
    const bool is_new = row == 0 || text_in(table, row - 1, "scene") != scene;
    if (is_new && row > 0) console.result(line);
    if (is_new) line = "  " + padded(scene, 12);
    const std::string status = text_in(table, row, "status");
    line += fmt::format(
        " {:>9}", is_point(status) ? fmt::format("{:.3g}", number_in(table, row, trade.error)) : status);
  }
  console.result(line);
}

}  // namespace

int report_sweeps(const Words& words, const TradeStudy& trade, const CsvTable& table,
                  const std::filesystem::path& folder, Console& console) {
  write_whole_file(folder / "sweeps.json", json_of(table));
  TradeChart chart{
      .title = trade.title, .work = trade.work_axis, .error = trade.error_axis, .note = trade.note};
  chart.curves = trade.curves;
  chart.is_of_sweeps = true;
  for (const std::string& scene : trade.curves) {
    for (const TradePoint& point : runs_of(table, scene, trade.error)) chart.points.push_back(point);
  }
  if (words.has("json"))
    fmt::print("{}", json_of(table));
  else
    print_sweeps(trade, table, console);
  if (!chart.points.empty())
    render::write_png(folder / "sweeps.png", draw_trade_chart(chart, theme_of(words)));
  console.narrate("written: " + (folder / "sweeps.csv").string() +
                  (chart.points.empty() ? ", .json" : ", .json, .png"));
  bool all_good = true;
  for (int row = 0; row < table.rows.size(); ++row)
    all_good = all_good && is_point(text_in(table, row, "status"));
  return all_good ? all_well : check_failed;
}

}  // namespace cairn::sandbox
