// What lesson 18 says: its card, its tables, and the claims that it makes.
#pragma once

#include "cost.hpp"
#include "lessons/lesson.hpp"

namespace cairn::cost {

LessonInfo card();

/// Prints errors, sweeps, times and the answer, and checks every claim.
void report(Lesson& lesson, const CostRun& run);

/// Errors, and no times: those are different on every run.
CsvTable errors_table(const CostRun& run);

}  // namespace cairn::cost
