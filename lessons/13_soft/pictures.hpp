// The frames of lesson 13: every step of a weight on two rows, stiffer springs, three weights, and a force
// that fails.
#pragma once

#include <memory>
#include <vector>

#include "lessons/lesson.hpp"
#include "render/camera.hpp"
#include "spring.hpp"

namespace cairn::soft {

using Runs = std::shared_ptr<const SoftRuns>;

std::vector<Shot> soft_shots(const SoftRuns& all);

/// Stiffer springs; three weights; the spring as a force.
std::vector<Shot> stiff_shots(const Runs& all);
std::vector<Shot> column_shots(const Runs& all);
std::vector<Shot> harsh_shots(const Runs& all);

/// A zig-zag from the foot of a spring at x up to its end [m].
void draw_spring(render::Page& page, const render::Camera& camera, double x, double bottom, double top,
                 const render::SeriesStyle& style);

/// The soft row in the look of sequential impulses, the row without gamma in that of a further solver.
render::SeriesStyle style_of_soft(const render::Page& page);
render::SeriesStyle style_of_rigid(const render::Page& page);

}  // namespace cairn::soft
