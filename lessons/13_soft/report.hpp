// Lesson 13. Its card, its settings, what it prints and what it checks.
#pragma once

#include "lessons/lesson.hpp"
#include "spring.hpp"

namespace cairn::soft {

LessonInfo card();
SoftSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const SoftSettings& settings);
void print_runs(Lesson& lesson, const SoftRuns& all);
void check_runs(Lesson& lesson, const SoftRuns& all);
CsvTable steps_table(const SoftRuns& all);

}  // namespace cairn::soft
