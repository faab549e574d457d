// Lesson 12. What it prints, checks and draws.
#pragma once

#include <memory>

#include "blocks.hpp"
#include "lessons/lesson.hpp"
#include "math/list.hpp"

namespace cairn::blocks {

BlocksSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const BlocksSettings& settings);
void print_runs(Lesson& lesson, const BlocksRuns& all);
void check_runs(Lesson& lesson, const BlocksRuns& all);
/// What a block saves in each sweep, counted and checked.
void report_counted(Lesson& lesson, const BlocksRuns& all);
CsvTable sweeps_table(const BlocksRuns& all);

using Runs = std::shared_ptr<const BlocksRuns>;

/// The question, every row update of the rod, the chain as sweeps go by, every step of the bob.
List<Shot> blocks_shots(const BlocksRuns& all, const std::string& question);

Shot question_shot(const Runs& all, const std::string& question);

/// The frames of the chain of three welded beams, and the table of all chains.
List<Shot> chain_shots(const Runs& all);
/// The frames of the bob, and its last moment with a text beside it.
List<Shot> bob_shots(const Runs& all);

/// Rows in the look of sequential impulses, blocks in that of a further solver.
render::SeriesStyle style_of_rows(const render::Page& page);
render::SeriesStyle style_of_blocks(const render::Page& page);

}  // namespace cairn::blocks
