// Exercise 19: how many sweeps a ratio of masses takes.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise19 {

/// A box of `below` kg stands on the ground and carries one of `above` kg. The rows are visited from the
/// ground up, from impulses of 0. After how many sweeps is at most this share (0 < share < 1) of the error of
/// the load on the ground left? Each sweep leaves R / (1 + R) of it, with R = above / below. A whole number,
/// rounded up.
int sweeps_needed(double above, double below, double share);

using Answer = int (*)(double, double, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise19
