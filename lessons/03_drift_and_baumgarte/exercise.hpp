// Exercise 03: what a row asks for.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise03 {

/// How a contact takes errors back.
struct Recovery {
  double beta = 0;       // share of the error for every step
  double slop = 0;       // [m] so deep it may stay
  double max_speed = 0;  // [m/s] zeta is not above this
  double dt = 0;         // [s]
};

/// zeta [m/s] of a contact that is `depth` m inside, equation (7): the separation speed that its row asks
/// for. 0 where the depth is within the slop, and for bodies that are apart (a depth below 0).
double wanted_speed(double depth, const Recovery& recovery);

using Answer = double (*)(double, const Recovery&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise03
