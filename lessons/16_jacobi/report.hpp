// What lesson 16 says: its card, its tables, and the claims that it makes.
#pragma once

#include "feet.hpp"
#include "lessons/lesson.hpp"
#include "pile.hpp"

namespace cairn::everybody {

LessonInfo card();

/// Prints both scenes and the answer, and checks every claim.
void report(Lesson& lesson, const FeetRun& feet, const PileRun& pile);

CsvTable sweeps_table(const FeetRun& feet, const PileRun& pile);

}  // namespace cairn::everybody
