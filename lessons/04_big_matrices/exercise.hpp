// Exercise 04: the entries of A for a stack.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise04 {

/// A_ij [1/kg] of a stack with one contact under each box: contact 0 is between the ground and box 0, contact
/// i between the boxes i - 1 and i. `masses` [kg] are those of the boxes, from the ground up. A = J M^-1 J^T
/// (15).
double entry(int i, int j, const List<double>& masses);

using Answer = double (*)(int, int, const List<double>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise04
