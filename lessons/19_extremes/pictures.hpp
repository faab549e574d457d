// The frames of lesson 19.
#pragma once

#include <memory>
#include <vector>

#include "lessons/lesson.hpp"
#include "limits.hpp"
#include "ratio.hpp"
#include "wall.hpp"

namespace cairn::edges {

struct ExtremesRun {
  WallSettings settings = {};
  std::vector<RatioRun> ratios = {};
  std::vector<EdgeCase> wall = {};
  std::vector<Refusal> refusals = {};
};
using Run = std::shared_ptr<const ExtremesRun>;

/// "100 on 1": the name of a ratio of masses.
std::string name_of(double ratio);

/// The two stacks, sweep by sweep, and the map of all ratios.
std::vector<Shot> ratio_shots(const Run& run);
/// Eight worlds, step by step, and what their numbers tell.
std::vector<Shot> wall_shots(const Run& run);
/// The question, both of the above, and the answer.
std::vector<Shot> extremes_shots(const ExtremesRun& run);

}  // namespace cairn::edges
