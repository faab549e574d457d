// Exercise 02: one push that stops one point of a body.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise02 {

/// A body that meets a fixed peg. All numbers are those of the row: j = (0, 1, arm) for a push upwards.
struct Meeting {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m^2)]
  double arm = 0;              // [m] of the peg, right of the centre of mass
  double speed = 0;            // [m/s] j . v1: of the point above the peg, upwards
  double wanted = 0;           // [m/s] zeta: what j . v2 is to be
};

/// The impulse lambda dt [N s] after which the point moves as wanted: equation (22), times dt.
double impulse_of(const Meeting& meeting);

using Answer = double (*)(const Meeting&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise02
