// The card of lesson 06, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "stack.hpp"

namespace cairn::stack {

LessonInfo card();

void tell_scene(Lesson& lesson, const StackRun& run);
void tell_updates(Lesson& lesson, const StackRun& run);
void tell_sweeps(Lesson& lesson, const StackRun& run);
void check_claims(Lesson& lesson, const StackRun& run);
CsvTable table_of(const StackRun& run);

}  // namespace cairn::stack
