// The frames of lesson 12: every row update of the rod, the chain as sweeps go by, every step of the bob.
#pragma once

#include <memory>
#include <vector>

#include "blocks.hpp"
#include "lessons/lesson.hpp"

namespace cairn::blocks {

using Runs = std::shared_ptr<const BlocksRuns>;

std::vector<Shot> blocks_shots(const BlocksRuns& all);

/// The frames of the chain of three welded beams, and the table of all chains.
std::vector<Shot> chain_shots(const Runs& all);
/// The frames of the bob, and its last moment with a text beside it.
std::vector<Shot> bob_shots(const Runs& all);

/// Rows in the look of sequential impulses, blocks in that of a further solver.
render::SeriesStyle style_of_rows(const render::Page& page);
render::SeriesStyle style_of_blocks(const render::Page& page);

}  // namespace cairn::blocks
