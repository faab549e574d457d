// What lesson 19 says: its card, its tables, and the claims that it makes.
#pragma once

#include "lessons/lesson.hpp"
#include "pictures.hpp"

namespace cairn::edges {

LessonInfo card();

/// Prints ratios, worlds, refusals and the answer, and checks every claim.
void report(Lesson& lesson, const ExtremesRun& run);

CsvTable numbers_table(const ExtremesRun& run);

}  // namespace cairn::edges
