// Exercise 01: the row of a bead on a rail.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise01 {

/// A point of a body that has to stay on a straight rail through the origin.
struct Rail {
  double slope = 0;  // [rad] the rail rises to the right by this angle
  double arm_x = 0;  // [m] from the body's centre to the point, as the body stands now
  double arm_y = 0;
};

/// j = (j_x, j_y, j_theta) of c, the distance of the point from the rail, positive on the upper side:
/// dc/dt = j . v with v = (v_x, v_y, omega).
FixedList<double, 3> jacobian(const Rail& rail);

using Answer = FixedList<double, 3> (*)(const Rail&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise01
