// cairn extremes: what holds, what degrades and what is refused, at the edges of what can be asked.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <cairn/study/extremes/extreme.hpp>
#include "lessons/kit/records.hpp"
#include "lessons/sandbox/reports.hpp"
#include "lessons/sandbox/study_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/math/nearest.hpp>
#include <cairn/study/trade_row.hpp>

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;
using Color = Console::Color;

ExtremeChoice choice_of(const Words& words) {
  ExtremeChoice choice;
  if (words.has("only")) choice.axes = words.texts("only");
  if (words.has("quick")) choice.part = ExtremePart::quick;
  List<std::string> known;
  for (const ExtremeAxis& axis : extreme_axes()) known.push_back(axis.name);
  for (const std::string& axis : choice.axes) require_known(axis, known, "extremes", "axis");
  return choice;
}

int list_axes(Console& console) {
  for (const ExtremeAxis& axis : extreme_axes()) {
    console.result(console.spelt(fmt::format("{:<14} {}", axis.name, axis.title)));
    console.result(console.spelt(fmt::format("{:<14} {}", "", axis.settings)));
  }
  return all_well;
}

/// Columns as wide as their longest cell; the last one is a note.
List<std::string> lined_up(const List<List<std::string>>& rows) {
  List<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (int i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  List<std::string> lines;
  for (const auto& row : rows) {
    std::string line;
    for (int i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

bool is_met(const CsvTable& found, int row) { return number_in(found, row, "meets") == 1; }

/// Of a refusal there is no number.
List<std::string> row_cells(const CsvTable& found, int row) {
  List<std::string> cells;
  for (const char* column : {"axis", "value", "solver", "policy", "verdict", "required", "quantity"})
    cells.push_back(shown_in(found, row, column));
  const bool refused = text_in(found, row, "verdict") == "REFUSE";
  for (const char* column : {"measured", "limit"})
    cells.push_back(refused ? "" : fmt::format("{:.3g}", number_in(found, row, column)));
  cells.push_back(is_met(found, row) ? "" : shown_in(found, row, "note"));
  return cells;
}

void print_table(const CsvTable& found, const Words& words, Console& console) {
  List<List<std::string>> cells = {
      {"axis", "value", "solver", "policy", "verdict", "must", "quantity", "value", "limit", ""}};
  List<bool> good = {true};
  for (int row = 0; row < found.rows.size(); ++row) {
    if (words.has("missed") && is_met(found, row)) continue;
    cells.push_back(row_cells(found, row));
    good.push_back(is_met(found, row));
  }
  const List<std::string> lines = lined_up(cells);
  for (int i = 0; i < lines.size(); ++i)
    console.result(good[i] ? console.spelt(lines[i]) : console.colored(console.spelt(lines[i]), Color::bad));
}

int report_extremes(const CsvTable& found, const Words& words, Console& console) {
  std::map<std::string, int> verdicts;
  int missed = 0;
  for (int row = 0; row < found.rows.size(); ++row) {
    verdicts[text_in(found, row, "verdict")] += 1;
    missed += !is_met(found, row);
  }
  if (words.has("json"))
    fmt::print("{}\n", extreme_json(found));
  else
    print_table(found, words, console);
  const std::string summary = fmt::format(
      "{} cases: {} OK, {} BOUND, {} REFUSE, {} TOLD, {} FAIL; {} miss what is required", found.rows.size(),
      verdicts["OK"], verdicts["BOUND"], verdicts["REFUSE"], verdicts["TOLD"], verdicts["FAIL"], missed);
  if (words.has("json"))
    console.narrate(summary);
  else
    console.result(console.colored(summary, missed > 0 ? Color::bad : Color::good));
  return missed > 0 ? check_failed : all_well;
}

int run_extremes(const Words& words, Console& console) {
  if (words.has("atlas")) return run_atlas(words, console);
  words.refuse_beside("theme", "without --atlas");
  if (words.has("list")) return list_axes(console);
  const ExtremeChoice choice = choice_of(words);
  const Study study = extreme_study(choice);
  const Shard shard = shard_of(words);
  const fs::path folder = words.text("out").value_or("out/extremes");
  const fs::path file = folder / fmt::format("{}_{}_of_{}.csv", study.name, shard.number, shard.of);
  Journal journal = open_journal(words, file, study);
  if (!run_or_merge(words, study, shard, journal, "cases")) return stopped;
  const int code = report_extremes(extreme_table(journal.csv()), words, console);
  console.narrate("journal: " + file.string() + "; --again begins anew");
  return code;
}

}  // namespace

Verb extremes_verb() {
  return {.name = "extremes",
          .summary = "what holds, degrades or is refused at the extremes",
          .idea =
              "Drives one thing after the other to its extremes: mass ratios, heights, steps, speeds, sizes, "
              "springs, materials, numbers. OK: within the tolerance of what is measured. BOUND: not, but "
              "finite, without an energy gain above 1 %, and nothing goes through anything else. REFUSE: an "
              "error that names object and value. TOLD: it went wrong, and R_E says why: what solves left "
              "undone may move a body by half its size. FAIL: none of these. Exit code 1 where a case misses "
              "what it must do. It can be stopped and taken up again. --atlas draws maps over two things "
              "at once instead, a panel for each solver: where it holds, where it degrades and where it "
              "explodes.",
          .flags = {{"quick", "", "two settings for each value: half a minute instead of many"},
                    {"only", "AXIS,AXIS", "these alone", true},
                    {"missed", "", "shows those that miss what is required, and no others"},
                    {"out", "DIR", "for the journal (out/extremes)"},
                    {"again", "", "forgets what an earlier run has found"},
                    {"shard", "k/n", "does the k-th of n parts only"},
                    {"merge", "FILE,FILE", "puts the journals of parts together instead of running", true},
                    {"list", "", "the axes, and what each is tried with"},
                    {"atlas", "DIR", "draws the maps into this folder, their journal beside them"},
                    {"theme", "NAME", "of the maps: light or dark (light)"}},
          .examples = {"extremes --quick", "extremes --only stack,chain --missed", "extremes --shard 1/4",
                       "extremes --atlas out/atlas --theme dark"},
          .run = run_extremes};
}

}  // namespace cairn::sandbox
