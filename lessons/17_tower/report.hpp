// What lesson 17 says: its card, its tables, and the claims that it makes.
#pragma once

#include "lessons/lesson.hpp"
#include "tower.hpp"

namespace cairn::tower {

LessonInfo card();

/// Prints the loads and the answer, and checks every claim.
void report(Lesson& lesson, const TowerRuns& runs);

CsvTable loads_table(const TowerRuns& runs);

}  // namespace cairn::tower
