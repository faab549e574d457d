// Lesson 04. Its card, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "system.hpp"

namespace cairn::big {

LessonInfo card();

void print_scene(Lesson& lesson, const StackRun& run);
void print_matrices(Lesson& lesson, const StackRun& run);
void print_right_side(Lesson& lesson, const StackRun& run);
void print_solution(Lesson& lesson, const StackRun& run);
void print_growth(Lesson& lesson, const StackRun& run);
void check_matrices(Lesson& lesson, const StackRun& run);
void check_solution(Lesson& lesson, const StackRun& run);
CsvTable entries_table(const StackRun& run);

/// Without a minus in front of what rounding left of a zero.
double cleaned(double value);

}  // namespace cairn::big
