// Exercise 12: a pin solved as one block.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise12 {

/// The two impulses [N s] of a pin that make both of its rows right at once: K x = change, with the symmetric
/// 2 x 2 block K = (k11 k12; k12 k22) [1/kg] of A, and the change of velocity [m/s] that each row asks for.
FixedList<double, 2> solve_block(double k11, double k12, double k22, const FixedList<double, 2>& change);

using Answer = FixedList<double, 2> (*)(double, double, double, const FixedList<double, 2>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise12
