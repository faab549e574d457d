// The frames of lesson 17.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "tower.hpp"

namespace cairn::tower {

/// The question, the warm tower step by step, the cold one, and the answer.
std::vector<Shot> tower_shots(const TowerRuns& runs);

}  // namespace cairn::tower
