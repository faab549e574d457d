// Lesson 12. Its card, its settings, what it prints and what it checks.
#pragma once

#include "blocks.hpp"
#include "lessons/lesson.hpp"

namespace cairn::blocks {

LessonInfo card();
BlocksSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const BlocksSettings& settings);
void print_runs(Lesson& lesson, const BlocksRuns& all);
void check_runs(Lesson& lesson, const BlocksRuns& all);
CsvTable sweeps_table(const BlocksRuns& all);

}  // namespace cairn::blocks
