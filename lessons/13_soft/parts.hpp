// Lesson 13. What it prints, checks and draws.
#pragma once

#include <memory>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "render/camera.hpp"
#include "spring.hpp"

namespace cairn::soft {

SoftSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const SoftSettings& settings);
void print_runs(Lesson& lesson, const SoftRuns& all);
void check_runs(Lesson& lesson, const SoftRuns& all);
CsvTable steps_table(const SoftRuns& all);

using Runs = std::shared_ptr<const SoftRuns>;

/// Every step of a weight on two rows, and all that follows.
List<Shot> soft_shots(const SoftRuns& all);

/// Stiffer springs; three weights; the spring as a force.
List<Shot> stiff_shots(const Runs& all);
List<Shot> column_shots(const Runs& all);
List<Shot> harsh_shots(const Runs& all);

/// A zig-zag from the foot of a spring at x up to its end [m].
void draw_spring(render::Page& page, const render::Camera& camera, double x, double bottom, double top,
                 const render::SeriesStyle& style);

/// The soft row in the look of sequential impulses, the row without gamma in that of a further solver.
render::SeriesStyle style_of_soft(const render::Page& page);
render::SeriesStyle style_of_rigid(const render::Page& page);

}  // namespace cairn::soft
