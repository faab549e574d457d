// Floor 9. Whether a problem is one that a solver can be given.
#pragma once

#include <string>

#include "constraints/row.hpp"

namespace cairn {

/// Refuses a problem that is none; worlds write none that it refuses. Sizes agree, body 0 is the ground and
/// nothing moves it, every number is finite but for the bounds, inverse masses and softness are >= 0, every
/// index points at what exists, bounds are an interval, friction names a row that does not itself name
/// another, extra terms lie inside their array, and the blocks are consecutive and cover all rows.
/// @throws std::invalid_argument "place: rows[3].bounds.normal_row must be rule, got value".
void check(const VelocityProblem<double>& problem, const std::string& place);

}  // namespace cairn
