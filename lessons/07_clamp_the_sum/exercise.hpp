// Exercise 07: what one foot does to the other.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise07 {

/// A box on two feet.
struct Feet {
  double mass = 0;     // [kg]
  double inertia = 0;  // [kg m^2]
  double left = 0;     // [m] where the feet are, from below the centre to the right
  double right = 0;
};

/// A_12 [1/kg]: how much faster the right foot rises after a push of 1 N s at the left one. Above 0, a foot
/// that was visited later may have made an earlier one rise, which then has to take back.
double coupling(const Feet& feet);

using Answer = double (*)(const Feet&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise07
