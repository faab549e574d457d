// Reports of work against error.
#include "lessons/sandbox/reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lessons/kit/records.hpp"
#include "lessons/sandbox/charts.hpp"
#include "lessons/kit/words.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/whole_file.hpp>
#include "render/image.hpp"
#include <cairn/study/trade_row.hpp>

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;

constexpr double least_residual = 1e-16;        // R_E below this is rounding
constexpr double least_error = 1e-9;            // of a whole run likewise, in each of its units
constexpr double most_spread = 0.1;             // of times: quartile range over median
const List<double> goals = {1e-2, 1e-4, 1e-6};  // of R_E
constexpr int profile_goal = 1;                 // 1e-4

/// Its units stand below the header.
std::string csv_with_units(const std::string& csv) {
  List<CsvCell> units = {std::string()};
  for (const TradeColumn& column : trade_columns()) units.push_back(column.unit);
  const std::size_t end = csv.find('\n') + 1;
  return csv.substr(0, end) + csv_line(units) + "\n" + csv.substr(end);
}

/// Counts in full, other numbers with three digits.
std::string number_text(double value) {
  const bool is_count = value == std::trunc(value) && std::abs(value) < 1e9;
  return is_count ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// "1e-4".
std::string power_text(double goal) { return fmt::format("1e{:.0f}", std::log10(goal)); }

/// Why a solver never came to an error: "cycle", "plateau", "nan", "refused", or "-" for too few sweeps.
std::string ending_text(const WorkToError& work) { return work.ending == "ok" ? "-" : work.ending; }

void print_work_to_errors(const List<WorkToError>& all, Console& console) {
  std::string head = fmt::format("{:<35}", "row updates down to R_E <=");
  for (const double goal : goals) head += fmt::format(" {:>10}", power_text(goal));
  console.result(head);
  bool has_endings = false;
  for (const WorkToError& work : all) {
    std::string line = fmt::format("  {:<16} {:<16}", work.scene, work.solver);
    for (const double updates : work.row_updates) {
      const bool is_reached = std::isfinite(updates);
      has_endings = has_endings || !is_reached;
      line += fmt::format(" {:>10}", is_reached ? number_text(updates) : ending_text(work));
    }
    console.result(line);
  }
  if (has_endings) {
    console.narrate("  -: not with so few sweeps; cycle, plateau: never, as its impulses repeat or drift");
  }
}

std::string noisy_text(int noisy) {
  return fmt::format("{} left out as noisy, their times spread by more than {:g} %", noisy,
                     100 * most_spread);
}

/// Measures of a whole run that stand beside its error, whatever that is: the worst of its starts.
struct Measure {
  std::string name = {}, unit = {};
  std::string column = {};
  double factor = 1;  // from the column to the unit
};

/// Times stand beside times alone: counted work is the same on every machine.
List<Measure> measures_of(const TradeStudy& trade) {
  if (trade.level != 2) return {};
  List<Measure> all = {{"slowest", "ms", "step_ns_max", 1e-6}, {"overlap", "mm", "pen_max", 1e3},
                       {"gap", "mm", "drift_max", 1e3},        {"gain", "%", "dE_max_gain", 100},
                       {"jitter", "mm/s", "jitter", 1e3},      {"inexact", "mm", "exact_gap", 1e3}};
  if (trade.work == "work") all.erase(all.begin());
  return all;
}

std::string measure_head(const List<Measure>& measures, std::string Measure::*word) {
  std::string head;
  for (const Measure& measure : measures) head += fmt::format(" {:>7}", measure.*word);
  return head;
}

/// "-" where there is no number.
std::string measure_text(const List<Measure>& measures, const CsvTable& table, int row) {
  std::string text;
  for (const Measure& measure : measures) {
    const double number = number_in(table, row, measure.column) * measure.factor;
    text += fmt::format(" {:>7}", std::isnan(number) ? "-" : fmt::format("{:.2g}", number));
  }
  return text;
}

/// "22 fails, 3 timeout": the settings whose runs are no points, by what became of them.
std::string ended_text(const CsvTable& table) {
  std::map<std::string, int> counts;
  for (int row = 0; row < table.rows.size(); ++row) {
    const std::string status = text_in(table, row, "status");
    if (!is_point(status)) counts[status] += 1;
  }
  List<std::string> parts;
  for (const auto& [status, count] : counts) parts.push_back(fmt::format("{} {}", count, status));
  return joined(parts, ", ");
}

/// What none of the points beats, from the least work on: each is better than the one before by a hundredth.
List<TradePoint> told_front(const List<TradePoint>& points) {
  List<TradePoint> front, told;
  std::copy_if(points.begin(), points.end(), std::back_inserter(front),
               [](const TradePoint& p) { return p.on_front; });
  std::stable_sort(front.begin(), front.end(),
                   [](const TradePoint& a, const TradePoint& b) { return a.work < b.work; });
  for (const TradePoint& point : front) {
    if (told.empty() || point.error < 0.99 * told.back().error) told.push_back(point);
  }
  return told;
}

/// `noisy` of the settings of the table are not among those whose points these may be.
void print_front(const TradeStudy& trade, const CsvTable& table, int noisy, const List<TradePoint>& points,
                 Console& console) {
  const List<TradePoint> front = told_front(points);
  std::size_t width = 20;
  for (const TradePoint& point : front) width = std::max(width, point.setting.size());
  const std::string ended = ended_text(table);
  console.result(fmt::format("the best of {} settings, by work and error{}{}", table.rows.size() + noisy,
                             ended.empty() ? "" : "; no points: " + ended,
                             noisy > 0 ? "; " + noisy_text(noisy) : ""));
  if (front.empty()) return;
  const List<Measure> measures = measures_of(trade);
  console.result(fmt::format("  {:<{}} {:>12} {:>12}{}", "setting", width, trade.work_name, trade.error_name,
                             measure_head(measures, &Measure::name)));
  if (!measures.empty())
    console.result(
        fmt::format("  {:<{}} {:>12} {:>12}{}", "", width, "", "", measure_head(measures, &Measure::unit)));
  for (const TradePoint& point : front) {
    console.result(fmt::format("  {:<{}} {:>12} {:>12.3g}{}", point.setting, width, number_text(point.work),
                               point.error, measure_text(measures, table, point.row)));
  }
}

void print_profiles(const List<PerformanceProfile>& profiles, Console& console) {
  const List<double> factors = {1, 2, 5, 10, 100, 1000};
  console.result(fmt::format("share of {} problems solved to R_E <= {}, by work as a multiple of the least",
                             profiles.empty() ? 0 : profiles.front().ratios.size(),
                             power_text(goals[profile_goal])));
  std::string head = fmt::format("  {:<16}", "solver");
  for (const double factor : factors) head += fmt::format(" {:>7}", fmt::format("x{:g}", factor));
  console.result(head);
  for (const PerformanceProfile& profile : profiles) {
    std::string line = fmt::format("  {:<16}", profile.solver);
    for (const double factor : factors) line += fmt::format(" {:>6.0f}%", 100 * profile.share(factor));
    console.result(line);
  }
}

/// "In a cycle for ever: si, block.": solvers that stand still before the last goal.
std::string standstill_note(const List<WorkToError>& all) {
  std::string note;
  for (const auto& [ending, words] :
       {std::pair("cycle", " In a cycle for ever: "), std::pair("plateau", " On a plateau for ever: ")}) {
    List<std::string> names;
    for (const WorkToError& work : all) {
      if (work.ending == ending && !std::isfinite(work.row_updates.back())) names.push_back(work.solver);
    }
    if (!names.empty()) note += words + joined(names, ", ") + ".";
  }
  return note;
}

/// Errors of 0 have no place on a logarithmic axis: they get the decade below the least of the others.
/// Whether there were any.
bool place_zeros(List<TradePoint>& points) {
  double least = 1;
  for (const TradePoint& point : points) {
    if (point.error > 0) least = std::min(least, point.error);
  }
  bool any = false;
  for (TradePoint& point : points) {
    if (point.error > 0) continue;
    point.error = std::pow(10, std::ceil(std::log10(least)) - 1);
    any = true;
  }
  return any;
}

void write_chart(const Words& words, const TradeStudy& trade, List<TradePoint> points,
                 const std::string& note, const fs::path& path) {
  const bool has_zeros = place_zeros(points);
  TradeChart chart{.title = trade.title,
                   .work = trade.work_axis,
                   .error = trade.error_axis,
                   .points = points,
                   .curves = trade.curves};
  chart.note =
      "A dot is a setting; the wide line joins those that none beats, a curve the best of a solver. " +
      unmarked(trade.note) + note + (has_zeros ? " What stands lowest has an error of 0." : "");
  chart.labels_all = words.has("labels");
  render::write_png(path, draw_trade_chart(chart, theme_of(words)));
}

/// The profile of all problems. The names of the files that were written.
std::string report_profile(const Words& words, const TradeStudy& trade, const List<WorkToError>& work,
                           const fs::path& folder, Console& console) {
  const List<PerformanceProfile> profiles = performance_profiles(work, profile_goal);
  ProfileChart chart{
      .title = fmt::format("{}, to R_{{E}} of at most {}", trade.title, power_text(goals[profile_goal])),
      .note =
          "At the left: how often a solver is the best of all. At the right: how often it gets "
          "there at all. E. D. Dolan, J. J. Moré, 2002.",
      .profiles = {}};
  for (const std::string& solver : trade.curves) {
    std::copy_if(profiles.begin(), profiles.end(), std::back_inserter(chart.profiles),
                 [&](const PerformanceProfile& profile) { return profile.solver == solver; });
  }
  render::write_png(folder / "profile.png", draw_profile_chart(chart, theme_of(words)));
  if (!words.has("json")) print_profiles(profiles, console);
  return ", profile.png";
}

/// Table and chart of one scene. The names of the files that were written.
std::string report_scene(const Words& words, const TradeStudy& trade, const CsvTable& shown,
                         const std::string& standstill, const fs::path& folder, Console& console) {
  const bool by_solve_time = trade.work == "solve_ns_med";
  const CsvTable steady = by_solve_time ? rows_with_steady_times(shown, most_spread) : shown;
  const List<TradePoint> points =
      trade_points(steady, trade.work, trade.error, trade.level == 1 ? least_residual : least_error);
  const int noisy = shown.rows.size() - steady.rows.size();
  if (!words.has("json")) print_front(trade, steady, noisy, points, console);
  if (points.empty()) return "";
  const std::string left_out = noisy > 0 ? " " + noisy_text(noisy) + "." : "";
  write_chart(words, trade, points, standstill + left_out, folder / (trade.name + ".png"));
  return ", .png";
}

}  // namespace

render::Theme theme_of(const Words& words) {
  const bool is_dark = words.word("theme", "light", {"light", "dark"}) == "dark";
  return is_dark ? render::dark_theme() : render::light_theme();
}

int report_trade(const Words& words, const TradeStudy& trade, const std::string& csv, const fs::path& folder,
                 Console& console) {
  if (trade.level == 3) return report_map(words, csv, folder, console);
  const CsvTable table = table_of(csv, trade.name);
  if (trade.is_of_sweeps) write_whole_file(folder / "sweeps.csv", csv_with_units(csv));
  if (trade.is_of_sweeps) return report_sweeps(words, trade, table, folder, console);
  write_whole_file(folder / (trade.name + ".csv"), csv_with_units(csv));
  write_whole_file(folder / (trade.name + ".json"), json_of(table));
  if (words.has("json")) fmt::print("{}", json_of(table));
  const CsvTable shown = rows_with(table, trade.shown);
  List<WorkToError> work;
  if (trade.level == 1) work = work_to_errors(shown, goals);
  if (trade.level == 1 && !words.has("json")) print_work_to_errors(work, console);
  std::string written = (folder / (trade.name + ".csv")).string() + ", .json";
  bool is_drawn = true;
  if (!words.has("all")) {
    const std::string chart = report_scene(words, trade, shown, standstill_note(work), folder, console);
    is_drawn = !chart.empty();
    written += chart;
  } else if (trade.level == 1) {
    written += report_profile(words, trade, work, folder, console);
  }
  console.narrate("written: " + written);
  if (!is_drawn) {
    console.warn("no chart: no run has ended with a value for --error " + trade.error_name +
                 (trade.error == "E_M" ? ", as the true velocity is not known to be unique" : ""));
  }
  return is_drawn ? all_well : check_failed;
}

}  // namespace cairn::sandbox
