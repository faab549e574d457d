// cairn tradeoff: what more work buys, as a table and a chart.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include <cairn/study/frozen/frozen_set.hpp>
#include "lessons/kit/records.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/study_words.hpp"
#include "lessons/sandbox/reports.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>
#include <cairn/study/trade_row.hpp>
#include <cairn/study/trajectory_study.hpp>

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;

int list_scenes(const Words& words, Console& console) {
  if (words.has("json")) {
    const nlohmann::ordered_json lists = {{"level1", frozen_names()}, {"level2", trajectory_names()}};
    fmt::print("{}\n", lists.dump());
    return all_well;
  }
  const auto line = [&](const std::string& head, const List<std::string>& names) {
    console.result(head + ":\n  " + wrapped(joined(names, ", "), 98, 2));
  };
  line("level 1, one step of frozen problems", frozen_names());
  line("level 2, whole runs", trajectory_names());
  return all_well;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": cannot be made: " + error.message());
}

/// What there is to do, and what was done before.
void tell_plan(const Study& study, const Shard& shard, const Journal& journal, Console& console) {
  console.narrate(fmt::format("{} of {} settings to try", tasks_in(study, shard), study.tasks.size()));
  if (journal.size() > 0) {
    console.narrate(fmt::format("{} of them were tried before, as the journal says", journal.size()));
  }
}

/// Tells the table of an earlier run: level 3 alone, whose tables are kept.
int tell_table(const Words& words, const fs::path& folder, Console& console) {
  for (const char* flag : {"shard", "merge"}) words.refuse_beside(flag, "beside --table, which runs nothing");
  const TradeStudy trade = trade_study(words);
  if (trade.level != 3) throw UsageError("cairn tradeoff: --table needs --all --level 3");
  const std::string path = *words.text("table");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in || !text) throw UsageError("cairn tradeoff: --table must be a file that can be read, got " + path);
  make_folder(folder);
  return report_trade(words, trade, text.str(), folder, console);
}

int run_level(const Words& words, Console& console) {
  const fs::path folder = words.text("out").value_or("out/tradeoff");
  if (words.has("table")) return tell_table(words, folder, console);
  const Shard shard = shard_of(words);
  (void)theme_of(words);  // refuses a wrong one before the work
  const TradeStudy trade = trade_study(words);
  make_folder(folder);
  const std::string part = shard.of > 1 ? fmt::format(".{}-of-{}", shard.number, shard.of) : "";
  Journal journal = open_journal(words, folder / (trade.name + part + ".journal"), trade.study);
  if (!words.has("merge")) tell_plan(trade.study, shard, journal, console);
  if (!run_or_merge(words, trade.study, shard, journal, "settings")) return stopped;
  if (shard.of > 1) {
    if (words.has("json")) fmt::print("{}", json_of(table_of(journal.csv(), trade.name)));
    console.narrate(
        fmt::format("part {} of {} is done; --merge puts the parts together", shard.number, shard.of));
    return all_well;
  }
  if (journal.size() < trade.study.tasks.size()) {
    console.warn(
        fmt::format("cairn tradeoff: --merge must be all parts of the study, got {} of {} settings; "
                    "without --merge the rest is done here",
                    journal.size(), trade.study.tasks.size()));
    return check_failed;
  }
  return report_trade(words, trade, journal.csv(), folder, console);
}

int run_tradeoff(const Words& words, Console& console) {
  if (words.has("list")) return list_scenes(words, console);
  if (!words.has("all") || words.has("level")) return run_level(words, console);
  if (words.has("json") || words.has("merge")) {
    throw UsageError("cairn tradeoff: --all with --json or --merge needs --level 1 or --level 2");
  }
  for (const char* level : {"1", "2"}) {
    Words one = words;
    one.flags["level"] = {level};
    const int code = run_level(one, console);
    if (code != all_well) return code;
  }
  return all_well;
}

List<Flag> tradeoff_flags() {
  return joined_flags(
      {{"level", "1|2|3",
        "one step, whole runs (as the scene asks for; --all: both), or with --all the map of settings"},
       {"all", "", "the whole study: all scenes of the level, or of both; no chart"},
       {"quick", "", "a coarse grid: a minute instead of many"},
       {"solvers", "NAME,NAME", "the first four get a curve", true},
       {"work", "WHAT",
        "updates or time (level 1: updates, and of times the steady ones; level 2: time of a frame)"},
       {"error", "WHAT",
        "level 1: R_E or E_M; level 2: expect, formula, body, penetration, drift, energy, jitter or "
        "exact"},
       {"start", "WHICH", "level 1: cold or warm, in the chart (cold)"},
       {"scalar", "WHICH", "level 1: double or float, in the chart (double)"},
       {"labels", "", "writes the settings beside the points that nothing beats"},
       {"theme", "WHICH", "light or dark (light)"},
       {"out", "DIR", "for SCENE.csv, .json, .png (or profile.png) and the journal (out/tradeoff)"},
       {"shard", "k/n", "does the k-th of n parts only"},
       {"merge", "FILE,FILE", "puts the journals of parts together instead of running", true},
       {"table", "FILE", "level 3: draws and prints this table of an earlier run"},
       {"list", "", "what can be compared"}},
      search_flags());
}

}  // namespace

Verb tradeoff_verb() {
  return {
      .name = "tradeoff",
      .places = "[SCENE...]",
      .fewest_places = 0,
      .most_places = 4,
      .summary = "work against error: a table and a chart",
      .idea =
          "Runs every setting of a grid and shows what more work buys. Of a frozen problem (level 1): every "
          "solver after 1, 2, 4 ... 4096 sweeps, cold and warm, in float and double; row updates and time "
          "against R_E or, where the true velocity is known to be unique, E_M. Of a scene (level 2): "
          "solver, sweeps, substeps and steps a second, with Box2D 2.4.1 as one more contestant; the error "
          "is a formula's where one knows the motion, else the worst of what the scene expects, over its "
          "limit, or the worst overlap or gap, beside the thinner body. A run that fails, as cairn run says "
          "it, is no point; settings that take more than about half of real time are not followed further. "
          "Several scenes: what more sweeps of one solver buy in each. Level 3 is the "
          "map of settings: 1472 of them in 83 scenes, each with its error and its counted work. It can be "
          "stopped and taken up again.",
      .flags = tradeoff_flags(),
      .examples = {"tradeoff stack10 --quick", "tradeoff pendulum-150 --labels",
                   "tradeoff pyramid --solvers si,wide,wide-accelerated --contact-search when-moved",
                   "tradeoff --all --level 1 --shard 1/4"},
      .run = run_tradeoff};
}

}  // namespace cairn::sandbox
