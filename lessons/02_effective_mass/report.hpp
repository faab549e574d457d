// Lesson 02. Its card, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "peg.hpp"

namespace cairn::felt_mass {

LessonInfo card();

void print_scene(Lesson& lesson, const PegSettings& settings);
/// The push at the last place, for both bodies.
void print_pair(Lesson& lesson, const Pushes& all);
void print_places(Lesson& lesson, const Pushes& all);
void check_row(Lesson& lesson, const Pushes& all);
void check_motion(Lesson& lesson, const Pushes& all);
void check_others(Lesson& lesson, const Pushes& all);
CsvTable places_table(const Pushes& all);

}  // namespace cairn::felt_mass
