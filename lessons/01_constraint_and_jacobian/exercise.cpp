// Exercise 01. Write the row j of a point on a rail. Then: bash lessons/run check 1
#include <cmath>

#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise01 {

/// A point of a body that must stay on a straight rail through the origin.
struct Rail {
  double angle = 0;  // [rad] the rail rises to the right by this angle
  double arm_x = 0;  // [m] from the body's centre to the point, as the body stands now
  double arm_y = 0;
};

// j = (j_x, j_y, j_theta) of c, the distance of the point from the rail, positive on the upper side:
// dc/dt = j . v with v = (v_x, v_y, omega).
FixedList<double, 3> jacobian(const Rail& rail) {
  FixedList<double, 3> j = {0, 0, 0};
  // Your code begins here: two or three lines that fill j.

  // Your code ends here.
  return j;
}

}  // namespace cairn::exercise01
