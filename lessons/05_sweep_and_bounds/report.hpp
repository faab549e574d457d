// Lesson 05. Its card, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "sweep.hpp"

namespace cairn::sweeps {

LessonInfo card();

void print_scenes(Lesson& lesson, const SweepSettings& settings);
void print_stack(Lesson& lesson, const SweepRun& run);
void print_rod(Lesson& lesson, const SweepRun& run);
void print_intervals(Lesson& lesson);
void check_stack(Lesson& lesson, const SweepRun& run);
void check_rod(Lesson& lesson, const SweepRun& run);
CsvTable updates_table(const SweepRun& run);

}  // namespace cairn::sweeps
