// Exercise 14: a joint that the solvers have never seen.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise14 {

/// The row j = (j_a, j_b) of two wheels whose teeth mesh from outside, with respect to their angular
/// velocities: j v = 0 where the teeth of both move along together. Any length of j will do.
FixedList<double, 2> gear_row(double teeth_a, double teeth_b);

using Answer = FixedList<double, 2> (*)(double, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise14
