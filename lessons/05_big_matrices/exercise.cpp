// Exercise 05. Write b, with all forces that are no rows. Then: bash lessons/run check 5
#include <array>
#include <cmath>

#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise05 {

using Three = std::array<double, 3>;  // for x, for y and for the angle

struct Body {
  Three inverse_mass = {};  // 1/m, 1/m, 1/I; all 0 for the ground
  Three velocity = {};      // [m/s, m/s, rad/s] at the beginning of the step
  Three force = {};         // [N, N, N m] gravity, wind, motors: all that no row computes
};

struct Row {
  int a = 0, b = 0;  // places of its two bodies in the list
  Three j_a = {}, j_b = {};
  double zeta = 0;  // [m/s] the j·v that it wants
};

// b [m/s²] of (15), one number for each row. The forces act during this step: (15) means the velocities that
// they have changed.
List<double> right_side(const List<Row>& rows, const List<Body>& bodies, double dt) {
  List<double> b;
  // Your code begins here: about nine lines.

  // Your code ends here.
  return b;
}

}  // namespace cairn::exercise05
