// Lesson 15. What it prints, checks and draws.
#pragma once

#include <string>

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "slide.hpp"

namespace cairn::top_view {

SlideSettings settings_of(const Lesson& lesson);

/// "(−3.00, −4.00)"
std::string pair_text(const Vec2<double>& pair, int decimals);

void print_scene(Lesson& lesson, const SlideSettings& settings);
void print_slides(Lesson& lesson, const Slides& all);
void check_slides(Lesson& lesson, const Slides& all);
CsvTable steps_table(const Slides& all);

/// One row at a time in the first step, then the slide, then all directions.
List<Shot> slide_shots(const Slides& all);

}  // namespace cairn::top_view
