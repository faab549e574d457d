// Exercise 15: friction in a plane, clamped to a circle.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise15 {

/// Clamps the friction impulse (x, y) [N s] to the circle of radius `limit` [N s] around 0: its direction
/// stays.
void clamp_to_circle(double& x, double& y, double limit);

using Answer = void (*)(double&, double&, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise15
