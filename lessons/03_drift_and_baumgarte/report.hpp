// Lesson 03. Its card, and what it prints, checks and writes.
#pragma once

#include "drift.hpp"
#include "lessons/lesson.hpp"

namespace cairn::drift {

LessonInfo card();

void print_scenes(Lesson& lesson, const DriftRuns& all);
void print_swings(Lesson& lesson, const DriftRuns& all);
void print_hangs(Lesson& lesson, const DriftRuns& all);
void print_balls(Lesson& lesson, const DriftRuns& all);
void print_limits(Lesson& lesson, const DriftRuns& all);
void check_rods(Lesson& lesson, const DriftRuns& all);
void check_balls(Lesson& lesson, const DriftRuns& all);
void check_limits(Lesson& lesson, const DriftRuns& all);
CsvTable balls_table(const DriftRuns& all);

}  // namespace cairn::drift
