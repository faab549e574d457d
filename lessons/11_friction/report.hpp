// Lesson 11. Its card, its settings, what it prints and what it checks.
#pragma once

#include "lessons/lesson.hpp"
#include "study.hpp"

namespace cairn::friction {

LessonInfo card();
StudySettings settings_of(const Lesson& lesson);

void tell_scene(Lesson& lesson, const Study& study);
/// Needed, limit and verdict for one block.
void tell_law(Lesson& lesson, const Slide& slide);
/// The first step of the slippery block: how the bounds of the tangent rows move with the normal rows.
void tell_sweeps(Lesson& lesson, const Study& study);
/// Speeds, and the angles above which blocks slide.
void tell_run(Lesson& lesson, const Study& study);
void check_study(Lesson& lesson, const Study& study);
CsvTable table_of(const Study& study);

}  // namespace cairn::friction
