// Lesson 00. Its card, and what it prints, checks and writes.
#pragma once

#include "flight.hpp"
#include "lessons/lesson.hpp"

namespace cairn::one_body {

LessonInfo card();

void tell_scene(Lesson& lesson, const Flight& flight);
void tell_steps(Lesson& lesson, const Flight& flight);
void tell_convergence(Lesson& lesson, const Convergence& convergence);
void check_claims(Lesson& lesson, const Flight& flight, const Convergence& convergence);
CsvTable table_of(const Flight& flight);

}  // namespace cairn::one_body
