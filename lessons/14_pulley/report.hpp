// Lesson 14. Its card, its settings, what it prints and what it checks.
#pragma once

#include "falls.hpp"
#include "lessons/lesson.hpp"

namespace cairn::pulley {

LessonInfo card();
PulleySettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const PulleySettings& settings);
/// The masses that weigh more than the rope pulls, with both.
std::string what_goes_down(const PulleySettings& settings);
void print_runs(Lesson& lesson, const PulleyRuns& all);
void check_runs(Lesson& lesson, const PulleyRuns& all);
CsvTable steps_table(const PulleyRuns& all);

}  // namespace cairn::pulley
