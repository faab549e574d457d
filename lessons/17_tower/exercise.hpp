// Exercise 17: how many sweeps a tower takes.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise17 {

/// After how many sweeps the slowest error of a stack of n boxes has shrunk to this share (0 < share < 1):
/// each sweep of PGS or SI multiplies it by cos^2(pi / (2 n)). A whole number, rounded up.
int sweeps_needed(int boxes, double share);

using Answer = int (*)(int, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise17
