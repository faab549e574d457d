// The card of lesson 08, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "twice.hpp"

namespace cairn::twice {

LessonInfo card();

void tell_scene(Lesson& lesson, const TwiceSettings& settings);
void tell_first_sweep(Lesson& lesson, const TwiceRun& run);
void tell_precisions(Lesson& lesson, const TwiceRun& run);
void check_claims(Lesson& lesson, const TwiceRun& run);
CsvTable table_of(const TwiceRun& run);

}  // namespace cairn::twice
