// Lesson 12. What it prints, checks and draws.
#pragma once

#include <memory>

#include "blocks.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"

namespace cairn::blocks {

BlocksSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const BlocksSettings& settings);
void print_runs(Lesson& lesson, const BlocksRuns& all);
void check_runs(Lesson& lesson, const BlocksRuns& all);

/// What a block saves in ten sweeps over three welds.
struct Savings {
  int row_updates = 0;  // of the velocities of two bodies
  int block_updates = 0;
  int inverses_once = 0;  // of 3 x 3 matrices, once a step
  int inverses_again = 0;
  double change = 0;       // [N s] of the impulses, inverted once or in each sweep
  double library_gap = 0;  // [N s] of the impulses, against the library's blocks
};

Savings count_savings(const BlocksRuns& all);
void print_savings(Lesson& lesson, const BlocksRuns& all, const Savings& savings);
void check_savings(Lesson& lesson, const BlocksRuns& all, const Savings& savings);
CsvTable sweeps_table(const BlocksRuns& all);

using Runs = std::shared_ptr<const BlocksRuns>;

/// The question, every row update of the rod, the chain as sweeps go by, every step of the bob.
List<Shot> blocks_shots(const BlocksRuns& all);

/// The frames of the chain of three welded beams, and the table of all chains.
List<Shot> chain_shots(const Runs& all);
/// The frames of the bob.
List<Shot> bob_shots(const Runs& all);

/// A chain before the first sweep.
void draw_start(render::Page& page, const render::Rect& rect, const ChainRun& chain);
/// The sweeps of one, two and three beams with blocks, as a part of those by rows; what is asked for is left
/// out.
void draw_sweep_bars(render::Page& page, const render::Rect& rect, const BlocksRuns& all, bool asked);
/// The bob after so many steps, by rows and by its block.
void draw_both_bobs(render::Page& page, const FixedList<render::Rect, 2>& rects, const BlocksRuns& all,
                    int step);

/// Rows in the look of sequential impulses, blocks in that of a further solver.
render::SeriesStyle style_of_rows(const render::Page& page);
render::SeriesStyle style_of_blocks(const render::Page& page);

}  // namespace cairn::blocks
