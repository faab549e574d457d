// Lesson 19. What it prints, checks and draws.
#pragma once

#include <memory>
#include <string>

#include "lessons/kit/lesson.hpp"
#include "limits.hpp"
#include "math/list.hpp"
#include "ratio.hpp"
#include "render/camera.hpp"
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

/// "100 kg on 1 kg": the name of a ratio of masses.
std::string name_of(double ratio);

using Run = std::shared_ptr<const ExtremesRun>;

/// The ground and two boxes with their masses on them, the heavy one darker.
void draw_boxes(render::Page& page, const render::Camera& camera, const Snapshot& now, double ratio);
/// Eight worlds, step by step.
List<Shot> wall_shots(const Run& run);
/// The question, the two stacks, the above, and the answer.
List<Shot> extremes_shots(const ExtremesRun& run);

}  // namespace cairn::edges
