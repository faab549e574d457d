// The stability atlas, from the command line to its pictures.
#include "lessons/sandbox/reports.hpp"

#include <fmt/format.h>

#include "lessons/kit/records.hpp"
#include "lessons/sandbox/charts.hpp"
#include "lessons/sandbox/study_words.hpp"
#include "math/list.hpp"
#include "render/image.hpp"
#include "study/trade_row.hpp"

namespace cairn::sandbox {
namespace {

namespace fs = std::filesystem;

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
