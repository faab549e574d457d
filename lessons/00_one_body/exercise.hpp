// Exercise 00: one step of a body that falls.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise00 {

/// A body that moves up and down.
struct Falling {
  double height = 0;    // [m]
  double velocity = 0;  // [m/s] upwards
};

/// One step of dt [s] of semi-implicit Euler, with the acceleration [m/s^2] upwards.
void integrate(Falling& body, double acceleration, double dt);

using Answer = void (*)(Falling&, double, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise00
