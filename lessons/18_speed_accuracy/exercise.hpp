// Exercise 18: the best over-relaxation of a tower.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise18 {

/// The omega with which SOR on a stack of n boxes shrinks its slowest error fastest. Jacobi's rate is cos(pi
/// / (2 n)).
double best_relaxation(int boxes);

using Answer = double (*)(int);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise18
