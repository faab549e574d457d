// Lesson 17. What it prints, checks and draws.
#pragma once

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "tower.hpp"

namespace cairn::tower {

/// Prints the loads and the answer, and checks every claim.
void report(Lesson& lesson, const TowerRuns& runs);

CsvTable loads_table(const TowerRuns& runs);

/// The question, the warm tower step by step, the cold one, and the answer.
List<Shot> tower_shots(const TowerRuns& runs);

}  // namespace cairn::tower
