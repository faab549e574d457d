// Exercise 00. Write one step of semi-implicit Euler. Then: bash lessons/run check 0
#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise00 {

/// A body in the plane: three numbers for each of these, for x, y and θ.
struct Body {
  FixedList<double, 3> place = {0, 0, 0};         // [m, m, rad]
  FixedList<double, 3> velocity = {0, 0, 0};      // [m/s, m/s, rad/s]
  FixedList<double, 3> inverse_mass = {0, 0, 0};  // the diagonal of M⁻¹ [1/kg, 1/kg, 1/(kg m²)]
};

// One step of dt [s] under two forces and a torque [N, N, N m]: equation (12) for each of the three numbers,
// number 0, 1 and 2.
void integrate(Body& body, const FixedList<double, 3>& force, double dt) {
  // Your code begins here: a loop over two lines.

  // Your code ends here.
}

}  // namespace cairn::exercise00
