// Lesson 19. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/lesson.hpp"
#include "limits.hpp"
#include "math/list.hpp"
#include "ratio.hpp"
#include "wall.hpp"

namespace cairn::edges {

struct ExtremesRun {
  WallSettings settings = {};
  List<RatioRun> ratios = {};
  List<EdgeCase> wall = {};
  List<Refusal> refusals = {};
};

/// Prints ratios, worlds, refusals and the answer, and checks every claim.
void report(Lesson& lesson, const ExtremesRun& run);

CsvTable numbers_table(const ExtremesRun& run);

/// "100 on 1": the name of a ratio of masses.
std::string name_of(double ratio);

using Run = std::shared_ptr<const ExtremesRun>;

/// Eight worlds, step by step, and what their numbers tell.
List<Shot> wall_shots(const Run& run);
/// The question, the two stacks, the above, and the answer.
List<Shot> extremes_shots(const ExtremesRun& run);

}  // namespace cairn::edges
