// Lesson 06. What it prints, checks and draws.
#pragma once

#include "lessons/kit/lesson.hpp"
#include "math/list.hpp"
#include "stack.hpp"

namespace cairn::stack {

void tell_scene(Lesson& lesson, const StackRun& run);
void tell_updates(Lesson& lesson, const StackRun& run);
void tell_sweeps(Lesson& lesson, const StackRun& run);
void check_claims(Lesson& lesson, const StackRun& run);
/// What the question's stack does, by momentum.
void check_question(Lesson& lesson, const StackRun& heavy);
CsvTable table_of(const StackRun& run);

/// The question, a frame for every row update, the course of all sweeps, and the answer.
List<Shot> stack_shots(const StackRun& run, const StackRun& heavy);

}  // namespace cairn::stack
