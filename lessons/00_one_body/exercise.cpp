// Exercise 00. Write one step of semi-implicit Euler. Then: bash lessons/run check 0
#include "lessons/exercise.hpp"

namespace cairn::exercise00 {

/// A body that moves up and down.
struct Falling {
  double height = 0;    // [m]
  double velocity = 0;  // [m/s] upwards
};

// One step of dt [s]. The acceleration [m/s^2] is upwards: it is negative for a body that falls.
void integrate(Falling& body, double acceleration, double dt) {
  // Your code begins here: two lines.

  // Your code ends here.
}

}  // namespace cairn::exercise00
