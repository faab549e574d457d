// Exercise 16. Write a sweep of Jacobi that converges. Then: bash lessons/run check 16
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise16 {

struct Box {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m²)]
  double up = 0;               // [m/s] velocity of its middle
  double turn = 0;             // [rad/s] counter-clockwise
};

/// One-sided. Its row is j = (1, x) on (up, turn), and ζ is 0.
struct Foot {
  double x = 0;        // [m] right of the box's middle
  double impulse = 0;  // [N s] that it has given so far, in total
};

// One sweep of Jacobi: all feet look at the same velocities, and then all of them act. Each gives only a
// share ω of its correction. Choose ω by the number of feet: so that all feet together never take back more
// than the whole error, wherever they are, and no smaller.
void sweep(Box& box, List<Foot>& feet) {
  // Your code begins here: about twelve lines.

  // Your code ends here.
}

}  // namespace cairn::exercise16
