// Exercise 00. Write one step of semi-implicit Euler that stores no velocity. Then: bash lessons/run check 0
#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise00 {

/// A body in the plane: three numbers for each of these, for x, y and θ.
struct Body {
  FixedList<double, 3> before = {0, 0, 0};        // where it was one step ago [m, m, rad]
  FixedList<double, 3> place = {0, 0, 0};         // where it is
  FixedList<double, 3> inverse_mass = {0, 0, 0};  // the diagonal of M⁻¹ [1/kg, 1/kg, 1/(kg m²)]
};

// One step of dt [s] under two forces and a torque [N, N, N m]. All steps have this length, so `before` and
// `place` tell the velocity. Afterwards both have to be those of the next step, in numbers 0, 1 and 2.
void advance(Body& body, const FixedList<double, 3>& force, double dt) {
  // Your code begins here: a loop over about three lines.

  // Your code ends here.
}

}  // namespace cairn::exercise00
