// Lesson 00. What it prints, checks and draws.
#pragma once

#include "flight.hpp"
#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"

namespace cairn::one_body {

void tell_scene(Lesson& lesson, const Flight& flight);
void tell_steps(Lesson& lesson, const Flight& flight);
void tell_convergence(Lesson& lesson, const Convergence& convergence);
void check_claims(Lesson& lesson, const Flight& flight, const Convergence& convergence);
CsvTable table_of(const Flight& flight);

/// All frames, from the question to the answer.
List<Shot> pictures(const Flight& flight, const Convergence& convergence);

}  // namespace cairn::one_body
