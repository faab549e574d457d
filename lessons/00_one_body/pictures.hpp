// Lesson 00. The pictures of the flight.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "flight.hpp"

namespace cairn::one_body {

/// All frames, from the question to the answer.
std::vector<Shot> pictures(const Flight& flight, const Convergence& convergence, const std::string& question);

}  // namespace cairn::one_body
