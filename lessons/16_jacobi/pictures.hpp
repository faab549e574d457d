// The frames of lesson 16: feet, sweep by sweep; the pyramid's sums; and two pyramids under a ball.
#pragma once

#include <string>
#include <vector>

#include "feet.hpp"
#include "lessons/lesson.hpp"
#include "pile.hpp"

namespace cairn::everybody {

std::vector<Shot> everybody_shots(const FeetRun& feet, const PileRun& pile);

/// The frames of the box on its feet, and those of the pyramid.
std::vector<Shot> feet_shots(const FeetRun& feet);
std::vector<Shot> pile_shots(const PileRun& pile);

/// The pyramid's contacts by colour, and what goes at the same time.
void draw_colours(render::Page& page, const PileRun& run);

/// "Jacobi", "Jacobi, ω = 0.3", "Jacobi, split", "SI".
std::string method_name(Method method, double omega);

/// Its line in every chart of the lesson.
render::SeriesStyle style_of(const render::Theme& theme, Method method);

}  // namespace cairn::everybody
