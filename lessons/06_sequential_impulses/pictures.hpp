// The frames of lesson 06: one for each row update.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "stack.hpp"

namespace cairn::stack {

/// The question, a frame for every row update, and the answer.
std::vector<Shot> stack_shots(const StackRun& run);

}  // namespace cairn::stack
