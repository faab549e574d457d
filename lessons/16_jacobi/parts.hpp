// Lesson 16. What it prints, checks and draws.
#pragma once

#include <string>

#include "feet.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "pile.hpp"
#include "render/camera.hpp"

namespace cairn::everybody {

/// Prints both scenes and the answer, and checks every claim.
void report(Lesson& lesson, const FeetRun& feet, const PileRun& pile);

CsvTable sweeps_table(const FeetRun& feet, const PileRun& pile);

/// The feet, sweep by sweep, and the pyramid.
List<Shot> everybody_shots(const FeetRun& feet, const PileRun& pile);

/// Those of the pyramid: its sums, and two pyramids under a ball.
List<Shot> pile_shots(const PileRun& pile);

/// All of a pyramid with so many boxes at the bottom.
render::Camera pyramid_camera(const render::Rect& inside, int base);

/// The pyramid's contacts by colour, and what goes at the same time.
void draw_colours(render::Page& page, const PileRun& run);

/// "Jacobi", "Jacobi, ω = 0.3", "Jacobi, split", "SI".
std::string method_name(Method method, double omega);

/// Its line in every chart of the lesson.
render::SeriesStyle style_of(const render::Theme& theme, Method method);

}  // namespace cairn::everybody
