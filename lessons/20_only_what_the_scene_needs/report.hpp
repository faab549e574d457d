// What lesson 20 says: its card, its tables, and the claims that it makes.
#pragma once

#include "bill.hpp"
#include "lessons/lesson.hpp"

namespace cairn::needs {

LessonInfo card();

/// Prints all bills and the answer, and checks every claim.
void report(Lesson& lesson, const NeedsRun& all);

CsvTable bills_table(const NeedsRun& all);

}  // namespace cairn::needs
