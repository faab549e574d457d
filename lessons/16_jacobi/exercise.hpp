// Exercise 16: a Jacobi that settles.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise16 {

/// The factor omega by which every correction of Jacobi is multiplied, so that it settles for a box with so
/// many contacts, whichever places they have, and is not slower than it has to be.
double damping(int contacts);

using Answer = double (*)(int);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise16
