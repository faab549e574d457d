// Floor 9. What must hold of a frozen problem beside its problem.
#pragma once

#include <string>

#include "frozen/frozen_problem.hpp"

namespace cairn {

inline const std::string frozen_schema = "cairn frozen problem 1";

/// @throws std::invalid_argument unless name, description and tags are texts of UTF-8 that have their
/// lengths, and the problem is one that problem_check.hpp accepts.
void check(const FrozenProblem& frozen, const std::string& place);

}  // namespace cairn
