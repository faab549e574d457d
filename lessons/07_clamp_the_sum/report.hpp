// The card of lesson 07, and what it prints, checks and writes.
#pragma once

#include "feet.hpp"
#include "lessons/lesson.hpp"

namespace cairn::feet {

LessonInfo card();

void tell_scene(Lesson& lesson, const FeetRun& run);
void tell_visits(Lesson& lesson, const FeetRun& run);
void tell_landings(Lesson& lesson, const FeetRun& run);
void tell_motion(Lesson& lesson, const FeetRun& run);
void check_claims(Lesson& lesson, const FeetRun& run);
CsvTable table_of(const FeetRun& run);

}  // namespace cairn::feet
