// Lesson 15. Its card, its settings, what it prints and what it checks.
#pragma once

#include "lessons/lesson.hpp"
#include "slide.hpp"

namespace cairn::top_view {

LessonInfo card();
SlideSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const SlideSettings& settings);
void print_slides(Lesson& lesson, const Slides& all);
void check_slides(Lesson& lesson, const Slides& all);
CsvTable steps_table(const Slides& all);

}  // namespace cairn::top_view
