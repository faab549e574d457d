// The card of lesson 10, and what it prints, checks and writes.
#pragma once

#include "lessons/lesson.hpp"
#include "stored.hpp"

namespace cairn::stored {

LessonInfo card();

void tell_scene(Lesson& lesson, const StoredRun& run);
void tell_counts(Lesson& lesson, const StoredRun& run);
void tell_kept(Lesson& lesson, const StoredRun& run);
void tell_cases(Lesson& lesson, const StoredRun& run);
void check_claims(Lesson& lesson, const StoredRun& run);
CsvTable table_of(const StoredRun& run);

}  // namespace cairn::stored
