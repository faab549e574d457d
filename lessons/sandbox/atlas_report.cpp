// The stability atlas, from the command line to its pictures.
#include "lessons/sandbox/atlas_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lessons/kit/records.hpp"
#include "lessons/sandbox/atlas_chart.hpp"
#include "lessons/sandbox/interrupt.hpp"
#include "lessons/sandbox/progress_line.hpp"
#include "lessons/sandbox/study_words.hpp"
#include "lessons/sandbox/trade_report.hpp"
#include "math/list.hpp"
#include "render/image.hpp"

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;

bool run_maps(const Study& study, const Shard& shard, Journal& journal, const Words& words) {
  int count = 0;
  for (int task = 0; task < study.tasks.size(); ++task) count += shard.holds(task) ? 1 : 0;
  ProgressLine bar(words.console, "cells", count);
  return run_study(study, shard, journal, [&](int done, int, double) {
    bar.advance(done);
    return !interrupted();
  });
}

/// Cells that were not run stay empty.
void report_sheets(const List<AtlasSheet>& sheets, const fs::path& folder, const Words& words,
                   Console& console) {
  const render::Theme theme = theme_of(words);
  for (const AtlasSheet& sheet : sheets) {
    const AtlasPicture picture = draw_atlas(sheet, theme);
    const std::string name =
        fmt::format("atlas_{}_{}.png", sheet.map.name, words.text("theme").value_or("light"));
    render::write_png(folder / name, picture.image);
    for (const std::string& finding : picture.findings) console.warn(name + ": " + finding);
    if (!words.has("json"))
      console.result(console.spelt(fmt::format("{:<11} {}", sheet.map.name, sheet_finding(sheet))));
  }
}

}  // namespace

int run_atlas(const Words& words, Console& console) {
  for (const char* flag : {"only", "missed", "list", "out"}) words.refuse_beside(flag, "beside --atlas");
  (void)theme_of(words);  // refuses a wrong one before the work
  const AtlasPart part = words.has("quick") ? AtlasPart::quick : AtlasPart::all;
  const Study study = atlas_study(part);
  const Shard shard = shard_of(words);
  const fs::path folder = *words.text("atlas");
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string of = shard.of > 1 ? fmt::format("_{}_of_{}", shard.number, shard.of) : "";
  const fs::path file = folder / (study.name + of + ".csv");
  if (words.has("again")) fs::remove(file, error);
  Journal journal = open_journal(words, file, study);
  for (const std::string& other : words.texts("merge")) journal.absorb(other);
  if (!words.has("merge") && !run_maps(study, shard, journal, words)) {
    console.warn(journal_goes_on);
    return stopped;
  }
  report_sheets(atlas_sheets(part, journal.csv()), folder, words, console);
  if (words.has("json")) {
    std::istringstream in(journal.csv());
    fmt::print("{}\n", json_of(read_csv(in, "atlas")));
  }
  console.narrate(fmt::format("{} of {} cells; journal: {}; --again begins anew", journal.size(),
                              study.tasks.size(), file.string()));
  return all_well;
}

}  // namespace cairn::sandbox
